// SPDX-License-Identifier: GPL-3.0-or-later
// The table of tests: sorts by any column, chooses tests to compare, and grows by parts so that thousands stay quick.
import { el, fill } from "./dom.js";
import { DASH, date, fixed } from "./format.js";
import { SHAPES, verdict } from "./kinds.js";

const PART = 200;
const number = (places, of) => ({ of, kind: "number", show: (t) => fixed(of(t), places) });
const text = (of) => ({ of, show: (t) => of(t) ?? DASH });

const COLUMNS = {
  "No.": { of: (t) => t.test.id, kind: "number wide", show: (t) => t.test.id },
  Name: { of: (t) => t.test.name, kind: "name", show: (t) => el("a", { href: `#/${t.test.status === "running" ? "run" : "test"}/${t.test.id}` }, t.test.name) },
  Type: text((t) => t.test.programme),
  Material: { ...text((t) => t.specimen.material), kind: "short wide" },
  "p′₀ (kPa)": number(0, (t) => t.consolidation?.p_eff_kPa),
  "e₀ (–)": number(3, (t) => t.consolidation?.void_ratio ?? t.specimen.void_ratio),
  Collapse: { of: (t) => verdict(t.collapse).word, show: (t) => {
    const { word, tone } = verdict(t.collapse);
    return el("span", { class: `tag ${tone}` }, el("span", { "aria-hidden": "true" }, `${SHAPES[tone]} `), word);
  } },
  "η at onset (–)": number(2, (t) => t.collapse.eta),
  "φ_mob (°)": { ...number(1, (t) => t.collapse.phi_mob_deg), kind: "number wide" },
  Warnings: { of: (t) => warnings(t), kind: "number", show: (t) => warnings(t) || "" },
  Origin: { of: (t) => t.test.origin, show: (t) => (t.test.origin === "simulated" ? "SIMULATED" : t.test.origin) },
  Stored: { of: (t) => t.test.stored_at, kind: "short wide", show: (t) => el("span", { title: date(t.test.stored_at) }, date(t.test.stored_at).slice(0, 10)) },
};

const warnings = (t) => (Array.isArray(t.warnings) ? t.warnings.length : t.warnings ?? 0);

let sorted = { by: "No.", down: false };

/** Unknown values come last, whichever way. */
function order(tests) {
  const { of } = COLUMNS[sorted.by];
  return [...tests].sort((a, b) => {
    const [x, y] = [of(a), of(b)];
    const unknown = (v) => v === null || v === undefined;
    if (unknown(x) || unknown(y)) return unknown(x) - unknown(y);
    const less = typeof x === "number" ? x - y : String(x).localeCompare(String(y), "en", { numeric: true });
    return sorted.down ? -less : less;
  });
}

export class TestTable {
  constructor(chosen, chosenChanged) {
    Object.assign(this, { chosen, chosenChanged, count: PART });
    this.node = el("div");
  }

  show(tests) {
    this.tests = tests;
    return this.draw();
  }

  draw(focused) {
    const rows = order(this.tests);
    const heads = Object.keys(COLUMNS).map((title) => el("th", { scope: "col", class: COLUMNS[title].kind, "aria-sort": title === sorted.by ? (sorted.down ? "descending" : "ascending") : null },
      el("button", { type: "button", data: { sort: title }, on: { click: () => {
        sorted = { by: title, down: sorted.by === title && !sorted.down };
        this.draw(title);
      } } }, title)));
    const more = rows.length > this.count ? el("button", { type: "button", on: { click: () => {
      this.count += PART;
      this.draw();
    } } }, `Show more (${rows.length - this.count})`) : null;
    fill(this.node, el("div", { class: "scroll" }, el("table", { class: "tests folds" }, el("caption", { hidden: true }, "Tests of this database"),
      el("thead", {}, el("tr", {}, el("th", { scope: "col" }, el("span", { class: "unseen" }, "Compare")), heads)),
      el("tbody", {}, rows.slice(0, this.count).map((t) => this.row(t))))), more);
    if (focused) [...this.node.querySelectorAll("[data-sort]")].find((b) => b.dataset.sort === focused)?.focus();
    return this.node;
  }

  row(t) {
    const box = el("input", { type: "checkbox", checked: this.chosen.has(t.test.id), "aria-label": `Compare ${t.test.name}`, on: { change: () => {
      this.chosen[box.checked ? "add" : "delete"](t.test.id);
      this.chosenChanged();
    } } });
    return el("tr", { data: { test: String(t.test.id) } }, el("td", { "data-label": "Compare" }, box),
      Object.entries(COLUMNS).map(([title, { kind, show }]) => el("td", { class: kind, "data-label": title }, show(t))));
  }
}
