// SPDX-License-Identifier: GPL-3.0-or-later
// Points along a stress path, and the table of the cones there.
import { el } from "./dom.js";
import { fixed } from "./format.js";

/** Some points of a path, evenly by its length on a square picture; none on the way to a place of `open`. */
export function along(p, q, open, count = 16) {
  const known = p.map((v, i) => [v, q[i], open.has(i)]).filter(([a, b]) => a !== null && b !== null);
  const [wide, high] = [Math.max(1, ...known.map(([a]) => a)), Math.max(1, ...known.map(([, b]) => b))];
  const walked = [0];
  for (let i = 1; i < known.length; ++i) walked.push(walked[i - 1] + (known[i][2] ? 0 : 1) * Math.hypot((known[i][0] - known[i - 1][0]) / wide, (known[i][1] - known[i - 1][1]) / high));
  const total = walked.at(-1) ?? 0;
  return Array.from({ length: total > 0 ? count : 0 }, (_, k) => {
    const here = (total * (k + 0.5)) / count;
    const i = walked.findIndex((w) => w >= here);
    const part = (here - walked[i - 1]) / (walked[i] - walked[i - 1]);
    return [0, 1].map((c) => known[i - 1][c] + part * (known[i][c] - known[i - 1][c]));
  });
}

export function conesTable(states) {
  const cell = (label, text) => el("td", { class: "number", "data-label": label }, text);
  return el("section", { class: "panel" }, el("h2", {}, "Cones along the test"), el("div", { class: "scroll" }, el("table", { class: "folds" },
    el("thead", {}, el("tr", {}, ["p′ (kPa)", "q (kPa)", "η (–)", "cone (°)", "opening (°)", "least W₂ (–)"].map((t) => el("th", { scope: "col", class: "number" }, t)))),
    el("tbody", {}, states.map(({ state, cones, least }) => el("tr", {}, cell("p′ (kPa)", fixed(state.p_eff_kPa)), cell("q (kPa)", fixed(state.q_kPa)), cell("η (–)", fixed(state.eta, 3)),
      cell("cone (°)", cones.map((c) => `${fixed(c.from_deg)} to ${fixed(c.to_deg)}`).join(", ") || "none"), cell("opening (°)", cones.length ? cones.map((c) => fixed(c.to_deg - c.from_deg)).join(", ") : "–"),
      cell("least W₂ (–)", fixed(least?.w2_normalised, 3))))))));
}
