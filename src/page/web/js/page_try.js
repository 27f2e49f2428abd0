// SPDX-License-Identifier: GPL-3.0-or-later
// A form made from a programme; the virtual test is then watched, faster than the clock.
import { get, post } from "./api.js";
import { el, field, fill, fresh, select } from "./dom.js";
import { failed } from "./notice.js";

const SPEEDS = [["0", "as fast as it computes"], ["600", "600 times real time"], ["60", "60 times real time"], ["10", "10 times real time"], ["1", "real time"]];
const kept = { programme: null, speed: "600", values: {}, rig: false };

function slider(spec, value, set) {
  const id = fresh("slide");
  const unit = el("span", { class: "unit" }, spec.unit && spec.unit !== "–" ? spec.unit : "");
  const box = el("input", { type: "number", min: spec.min, max: spec.max, step: "any", value, "aria-label": `${spec.label}, number` });
  const range = el("input", { type: "range", id, min: spec.min, max: spec.max, step: spec.step ?? "any", value });
  const both = (from, to) => from.addEventListener("input", () => {
    to.value = from.value;
    set(from.value);
  });
  both(box, range);
  both(range, box);
  return el("div", { class: "slider", data: { key: spec.key } }, el("label", { for: id }, spec.label), range, el("span", {}, box, " ", unit));
}

/** What has no way from less to more has no slider. */
function numberField(spec, value, set) {
  const box = el("input", { type: "number", min: spec.min, step: 1, value, on: { input: () => set(box.value) } });
  return field(spec.label, box);
}

function fieldsOf(programme) {
  const values = (kept.values[programme.name] ??= {});
  return programme.fields.map((spec) => {
    const value = values[spec.key] ?? spec.value;
    const set = (v) => (values[spec.key] = v);
    if (spec.options) return field(spec.label, select(spec.options.map((c) => [c, c]), value, set));
    if (spec.key === "test.seed") return numberField(spec, value, set);
    return slider(spec, value, set);
  });
}

/** Only what was changed is said. */
function changed(programme) {
  const values = kept.values[programme.name] ?? {};
  return Object.fromEntries(programme.fields.filter((f) => values[f.key] !== undefined && String(values[f.key]) !== String(f.value))
    .flatMap((f) => [f.key, ...(f.also ?? [])].map((key) => [key, f.options ? values[f.key] : Number(values[f.key])])));
}

export async function show(main) {
  const [{ programmes }, { rig: hasRig }] = await Promise.all([get("/api/programmes"), get("/api/tests")]);
  const find = (name) => programmes.find((p) => p.name === name) ?? programmes[0];
  const fields = el("div", { class: "try" });
  const remark = el("p", { class: "quiet remark" });
  const wrong = el("div");
  const build = () => {
    const programme = find(kept.programme);
    kept.programme = programme.name;
    remark.textContent = programme.about ?? programme.type ?? "";
    fill(fields, fieldsOf(programme));
  };
  const rig = hasRig ? el("input", { type: "checkbox", checked: kept.rig, on: { change: () => (kept.rig = rig.checked) } }) : null;
  const go = el("button", { class: "main", type: "submit" }, "▶ Run the test");
  const form = el("form", { class: "stack", on: { submit: async (event) => {
    event.preventDefault();
    go.disabled = true;
    fill(wrong);
    try {
      const body = { programme: kept.programme, set: changed(find(kept.programme)), speed: Number(kept.speed) };
      if (rig?.checked) body.rig = true;
      const { test } = await post("/api/runs", body);
      location.hash = `#/run/${test}`;
    } catch (failure) {
      fill(wrong, failed(failure));
      go.disabled = false;
    }
  } } },
  el("section", { class: "panel stack", "aria-label": "Programme" }, el("div", { class: "filters" },
    field("Programme", select(programmes.map((p) => [p.name, p.title || p.name]), find(kept.programme).name, (name) => {
      kept.programme = name;
      build();
    })), field("Speed", select(SPEEDS, kept.speed, (v) => (kept.speed = v))),
    rig ? el("div", { class: "row" }, field("On the instruments of the rig", rig)) : null), remark),
  el("section", { class: "panel", "aria-label": "Specimen and test" }, fields),
  wrong, el("div", { class: "row" }, go, el("span", { class: "quiet" }, "A virtual specimen: SIMULATED, not measured.")));
  build();
  fill(main, el("div", { class: "stack" }, el("h1", { tabindex: -1 }, "Try a test before you run it"), form));
  return { title: "Try it" };
}
