// SPDX-License-Identifier: GPL-3.0-or-later
// Files on their way into the database, one after the other: each is read, asks questions, or says why it cannot be read.
import { postRecord } from "./api.js";
import { el, field, fill } from "./dom.js";
import { assumption } from "./format.js";
import { importDialog } from "./import_dialog.js";
import { failed, leaveNotice } from "./notice.js";

const STATES = { waiting: ["waits", ""], reading: ["is read", "info"], asks: ["has questions", "care"], read: ["read", "good"], lacks: ["lacks values", "care"], failed: ["not read", "alarm"] };

const recognisedAs = (r) => (!r || typeof r === "string" ? r : [r.dialect, r.programme, `${r.columns?.length ?? 0} columns`].filter(Boolean).join(", "));

/** A file whose own columns the server found, without a dialect made for such files. */
const isPlainTable = (answer) => !answer.recognised || answer.recognised.dialect === "table";

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

export class Imports {
  /** `most`: bytes that the server accepts; `columnsFirst()`: whether the user wants the dialog for every file; `changed()`: tests
   *  were stored. */
  constructor() {
    Object.assign(this, { most: 0, columnsFirst: () => false, changed: () => {}, items: [] });
    this.node = el("div", { class: "imports", "aria-live": "polite" });
  }

  async add(files) {
    if (files.length === 0) return;
    const items = files.map((file) => ({ file, state: "waiting", detail: null, several: files.length > 1, room: el("li") }));
    if (this.items.every((item) => item.state !== "waiting" && item.state !== "reading")) this.items = [];
    this.items.push(...items);
    fill(this.node, el("ul", { class: "import-list", "aria-label": "Files" }, this.items.map((item) => item.room)));
    for (const item of items) this.show(item);
    for (const item of items) await this.read(item, {});
    if (items.some((item) => item.several && item.tests)) this.changed();
    if (items.length === 1 && items[0].state === "asks") await this.ask(items[0]);
  }

  set(item, state, detail) {
    Object.assign(item, { state, detail });
    this.show(item);
  }

  show(item) {
    const [text, tone] = STATES[item.state];
    const columns = item.state === "asks" || (item.canChoose && ["failed", "lacks"].includes(item.state))
      ? el("button", { type: "button", on: { click: () => this.ask(item) } }, item.state === "asks" ? "Answer…" : "Columns…") : null;
    fill(item.room, el("div", { class: "row" }, el("strong", { class: "name" }, item.file.name), el("span", { class: `tag ${tone}` }, text),
      (item.tests ?? []).map((id) => el("a", { href: `#/test/${id}` }, `test ${id}`)), columns), item.detail);
  }

  /** Reads a file as it is, or asks what the server does not know. */
  async read(item, answers) {
    const { file } = item;
    if (file.size > this.most) return this.set(item, "failed", failed(new Error(`${file.name} has ${Math.round(file.size / 2 ** 20)} MB; the page accepts at most ${this.most / 2 ** 20}. "triax replay" has no such limit.`)));
    this.set(item, "reading", el("p", { class: "quiet", role: "status" }, `Reading ${file.name}…`));
    try {
      if (this.columnsFirst() && await this.propose(item) && !item.proposal.own) return this.set(item, "asks", null);
      const answer = await postRecord(file, { sets: answers });
      if (answer.test !== null && answer.test !== undefined) return this.done(item, answer);
      if (isPlainTable(answer) && await this.propose(item) && !item.proposal.own) return this.set(item, "asks", this.questionsOf(item, answer));
      item.canChoose ||= Boolean(answer.recognised) && answer.recognised.dialect !== "triax";
      this.set(item, answer.missing?.length ? "lacks" : "failed", answer.recognised ? this.whatIsMissing(item, answer, answers) : failed(new Error(answer.error)));
      item.room.querySelector("h2")?.focus();
    } catch (failure) {
      this.set(item, "failed", failed(failure));
    }
  }

  /** What the columns may be; false if the file has no table. */
  async propose(item, worksheet) {
    const proposal = await postRecord(item.file, { worksheet }, "/proposal");
    item.canChoose = !proposal.error && !proposal.own;
    item.proposal = proposal;
    return !proposal.error;
  }

  questionsOf(item, answer) {
    const texts = item.proposal.tables.flatMap((table) => table.questions.map((question) => question.text));
    if (texts.length === 0 && answer.error) texts.push(answer.error);
    for (const { label, key } of answer.missing ?? []) texts.push(`What is the ${label ?? key}?`);
    return el("ul", { class: "quiet" }, [...new Set(texts)].map((text) => el("li", {}, text)));
  }

  whatIsMissing(item, answer, answers) {
    const guessed = (answer.guessed ?? []).map(assumption);
    return el("section", { class: "stack found", "aria-label": "What was found in the record" },
      el("p", {}, `Recognised as ${recognisedAs(answer.recognised)}.`),
      guessed.length ? [el("h3", {}, "Assumed"), el("ul", {}, guessed.map((text) => el("li", {}, text)))] : null,
      answer.error ? failed(new Error(answer.error)) : null,
      answer.missing?.length ? missingForm(answer, answers, (more) => this.read(item, more)) : null);
  }

  /** One file with one test leads to it; of several the list shows which tests they became, and what was assumed. */
  done(item, answer) {
    const assumed = [answer.error, ...(answer.guessed ?? []).map(assumption), ...(answer.warnings ?? [])].filter(Boolean);
    item.tests = answer.tests;
    item.several ||= item.tests.length > 1;
    if (!item.several) {
      leaveNotice(`${item.file.name} was replayed${answer.recognised ? `, recognised as ${recognisedAs(answer.recognised)}` : ""}.`, assumed);
      location.hash = `#/test/${answer.test}`;
      this.items = [];
      return fill(this.node);
    }
    this.set(item, "read", assumed.length < 2 ? el("p", { class: "quiet" }, assumed) : el("details", { class: "quiet" }, el("summary", {}, `${assumed[0]} (and ${assumed.length - 1} more)`), el("ul", {}, assumed.slice(1).map((text) => el("li", {}, text)))));
  }

  async ask(item) {
    try {
      if (!item.proposal && !await this.propose(item)) throw new Error(item.proposal.error);
    } catch (failure) {
      return this.set(item, "failed", failed(failure));
    }
    const { answer, remembered } = await importDialog(item.file, item.proposal, async (worksheet) => {
      await this.propose(item, worksheet);
      return item.proposal;
    });
    if (answer) this.done(item, answer);
    if (answer && item.several) this.changed();
    if (!remembered) return;
    for (const other of this.items.filter((one) => one.state === "asks" && one !== item)) await this.read(other, {});
  }
}
