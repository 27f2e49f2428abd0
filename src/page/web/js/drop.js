// SPDX-License-Identifier: GPL-3.0-or-later
// A record that is dropped on the page, or chosen, is replayed. What it does not say is asked for, exactly that.
import { postRecord } from "./api.js";
import { el, field, fill } from "./dom.js";
import { failed, leaveNotice } from "./notice.js";

const recognisedAs = (r) => (!r || typeof r === "string" ? r : [r.dialect, r.programme, `${r.columns?.length ?? 0} columns`].filter(Boolean).join(", "));
const guess = (g) => (typeof g === "string" ? g : `${g.what}: assumed to be ${g.taken}${g.evidence ? ` (${g.evidence})` : ""}. ${g.remedy ?? ""}`);

function missingForm(answer, answers, send) {
  const inputs = answer.missing.map(({ key, label, unit, why }) => {
    const input = el("input", { name: key, required: true, autocomplete: "off", value: answers[key] ?? "", inputmode: unit ? "decimal" : null });
    return field(`${label ?? key}${unit ? ` (${unit})` : ""}`, input, el("span", { class: "why" }, label ? key : why));
  });
  const form = el("form", { class: "stack", on: { submit: (event) => {
    event.preventDefault();
    send({ ...answers, ...Object.fromEntries(new FormData(form)) });
  } } }, el("h2", { tabindex: -1 }, "Missing from the record"), el("div", { class: "columns" }, inputs),
  el("div", { class: "row" }, el("button", { class: "main", type: "submit" }, "Replay with these")));
  return form;
}

/** `main` takes the drop, wherever on the page it falls. The server's answer to a file of more than `most` bytes would be lost
 *  while the file is sent: it is refused here. */
export function dropZone(main, most) {
  const result = el("div", { "aria-live": "polite" });
  const input = el("input", { type: "file", hidden: true, "aria-label": "Record file", tabindex: -1, id: "record-file" });
  const choose = el("button", { type: "button", on: { click: () => input.click() } }, "Open a record…");
  const zone = el("div", { class: "drop" }, el("span", {}, "Drop a record of a logger here"), choose, input);

  async function send(file, answers) {
    if (file.size > most) return fill(result, failed(new Error(`${file.name} has ${Math.round(file.size / 2 ** 20)} MB; the page accepts at most ${most / 2 ** 20}. "triax replay" has no such limit.`)));
    fill(result, el("p", { class: "notice", role: "status" }, `Reading ${file.name}…`));
    try {
      const answer = await postRecord(file, answers);
      const guessed = (answer.guessed ?? []).map(guess);
      if (answer.test !== null && answer.test !== undefined) {
        leaveNotice(`${file.name} was replayed${answer.recognised ? `, recognised as ${recognisedAs(answer.recognised)}` : ""}.`, guessed);
        location.hash = `#/test/${answer.test}`;
        return;
      }
      fill(result, el("section", { class: "panel stack", "aria-label": "What was found in the record" },
        el("p", {}, el("strong", {}, file.name), answer.recognised ? `: recognised as ${recognisedAs(answer.recognised)}.` : "."),
        guessed.length ? [el("h3", {}, "Assumed"), el("ul", {}, guessed.map((g) => el("li", {}, g)))] : null,
        answer.error ? failed(new Error(answer.error)) : null,
        answer.missing?.length ? missingForm(answer, answers, (more) => send(file, more)) : null));
      result.querySelector("h2")?.focus();
    } catch (failure) {
      fill(result, failed(failure));
    }
  }

  const over = (event, is) => {
    event.preventDefault();
    zone.classList.toggle("over", is);
  };
  main.addEventListener("dragover", (event) => over(event, true));
  main.addEventListener("dragleave", (event) => over(event, false));
  main.addEventListener("drop", (event) => {
    over(event, false);
    const file = event.dataTransfer?.files[0];
    if (file) send(file, {});
  });
  input.addEventListener("change", () => {
    if (input.files[0]) send(input.files[0], {});
    input.value = "";
  });
  return el("div", { class: "stack" }, zone, result);
}
