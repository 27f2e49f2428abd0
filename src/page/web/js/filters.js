// SPDX-License-Identifier: GPL-3.0-or-later
// Which tests are shown. What was asked for is kept while the page is open.
import { el, field, select } from "./dom.js";
import { DASH, words } from "./format.js";

const OF = { type: (t) => t.test.programme ?? DASH, material: (t) => t.specimen.material ?? DASH, kind: (t) => t.collapse.kind ?? "not assessed", origin: (t) => t.test.origin };
const RANGES = { p: (t) => t.consolidation?.p_eff_kPa, e: (t) => t.consolidation?.void_ratio ?? t.specimen.void_ratio };

let values = {};

const named = (t, text) => [t.test.name, t.test.source, t.test.id, ...(t.test.tags ?? [])].join(" ").toLowerCase().includes(text.toLowerCase());

/** The tests that these filters leave. */
export function kept(tests, asked) {
  return tests.filter((t) => {
    if (asked.text && !named(t, asked.text)) return false;
    for (const [key, of] of Object.entries(OF)) if (asked[key] && of(t) !== asked[key]) return false;
    for (const [key, of] of Object.entries(RANGES)) {
      const value = of(t);
      if (asked[`${key}_low`] && !(value >= Number(asked[`${key}_low`]))) return false;
      if (asked[`${key}_high`] && !(value <= Number(asked[`${key}_high`]))) return false;
    }
    return true;
  });
}

export class Filters {
  constructor(tests, changed) {
    this.values = values;
    const set = (key) => (value) => {
      values[key] = value;
      changed();
    };
    const choice = (title, key) => field(title, select([["", "all"], ...[...new Set(tests.map(OF[key]))].sort().map((v) => [v, words(v)])], values[key] ?? "", set(key)));
    const input = (type, key, more) => {
      const node = el("input", { type, value: values[key] ?? "", ...more, on: { input: () => set(key)(node.value) } });
      return node;
    };
    const range = (title, key, step) => [field(`${title} from`, input("number", `${key}_low`, { step })), field("to", input("number", `${key}_high`, { step, "aria-label": `${title} to` }))];
    const asked = Object.values(values).some((v) => v);
    this.node = el("details", { class: "filtering", open: innerWidth > 760 || asked }, el("summary", {}, "Filter"), el("div", { class: "filters", role: "search", "aria-label": "Filter tests" },
      field("Name, source or tag", input("search", "text", { autocomplete: "off" })), choice("Type", "type"), choice("Material", "material"),
      choice("Collapse", "kind"), choice("Origin", "origin"), range("p′₀ (kPa)", "p", 10), range("e₀ (–)", "e", 0.01)));
  }
}
