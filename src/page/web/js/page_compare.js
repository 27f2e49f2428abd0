// SPDX-License-Identifier: GPL-3.0-or-later
// Several tests over each other: told apart by colour and by dash.
import { get, windowPath } from "./api.js";
import { dottedPlaces, openAcross } from "./breaks.js";
import { Chart } from "./chart.js";
import { el, fill, segments } from "./dom.js";
import { fixed, percent, within } from "./format.js";
import { SHAPES, verdict } from "./kinds.js";
import { legend } from "./legend.js";
import { COLUMNS, QUANTITIES, WORK, at, axisTitle } from "./quantities.js";
import { marks } from "./stress_layers.js";

const STYLES = [["blue", []], ["vermilion", [9, 4]], ["green", [3, 3]], ["purple", [12, 3, 3, 3]], ["orange", [6, 2]], ["sky", [2, 2]], ["ink", [14, 5]], ["grey", [4, 4]]];
const LINE = { 0: "line" };

async function load(id) {
  const document = await get(`/api/tests/${encodeURIComponent(id)}`);
  const from = document.collapse.judged?.from_reading ?? 0;
  const { columns, work, faults, unread_steps: unread } = await get(windowPath(id, COLUMNS, { from, pixels: 500, work: true }));
  const first = columns.axial_strain.find((v) => v !== null) ?? 0;
  columns.axial_strain = columns.axial_strain.map((v) => (v === null ? null : v - first));
  return { document, columns, work, faults, dotted: dottedPlaces(columns.reading, unread), dottedWork: dottedPlaces(work.reading, unread) };
}

function summary(tests) {
  const cell = (label, ...content) => el("td", { class: "number", "data-label": label }, content);
  return el("section", { class: "panel" }, el("div", { class: "scroll" }, el("table", { class: "folds" },
    el("thead", {}, el("tr", {}, ["Test", "Collapse", "η at onset", "φ_mob (°)", "p′₀ (kPa)", "e₀ (–)", "p′, q at onset (kPa)", "ε₁ at onset", "η at loss of control"].map((t, i) => el("th", { scope: "col", class: i > 1 ? "number" : null }, t)))),
    el("tbody", {}, tests.map(({ document: { test, collapse, consolidation } }) => {
      const { word, tone } = verdict(collapse);
      return el("tr", {}, el("th", { scope: "row", "data-label": "Test" }, el("a", { href: `#/test/${test.id}` }, test.name)),
        el("td", { "data-label": "Collapse" }, el("span", { class: `tag ${tone}` }, `${SHAPES[tone]} ${word}`)),
        cell("η at onset", within(collapse.eta, collapse.eta_low, collapse.eta_high)), cell("φ_mob (°)", fixed(collapse.phi_mob_deg)), cell("p′₀ (kPa)", fixed(consolidation.p_eff_kPa, 0)),
        cell("e₀ (–)", fixed(consolidation.void_ratio, 3)), cell("p′, q at onset (kPa)", collapse.detected ? `${fixed(collapse.p_eff_kPa)}, ${fixed(collapse.q_kPa)}` : "–"),
        cell("ε₁ at onset", percent(collapse.axial_strain)), cell("η at loss of control", fixed(collapse.loss_of_control?.eta, 2)));
    })))));
}

export async function show(main, [ids]) {
  const tests = await Promise.all(ids.split(",").slice(0, STYLES.length).map(load));
  let charts = [];
  let relative = false;
  const grid = el("div", { class: "charts" });

  const build = () => {
    charts.forEach((chart) => chart.end());
    charts = [];
    const make = (x, y, height, relates) => {
      const over = (key) => (relative && relates ? `${QUANTITIES[key].symbol} / p′₀ (–)` : axisTitle(key));
      const chart = new Chart({ title: `${(QUANTITIES[y] ?? WORK).title} over ${QUANTITIES[x].title}, ${tests.length} tests`, height, cursor: false,
        x: { title: relative && x === "p_eff" ? "p′ / p′₀ (–)" : axisTitle(x) }, y: { title: y === "work" ? "W₂ normalised (–)" : over(y) } });
      chart.set(tests.flatMap(({ document, columns, work, faults, dotted, dottedWork }, i) => {
        const [colour, dash] = STYLES[i];
        const p0 = relative ? document.consolidation.p_eff_kPa || 1 : 1;
        const by = (v, does) => (v === null ? null : does ? v / p0 : v);
        const line = { kind: "line", colour, dash, ...(y === "work" ? { x: at(work.reading, columns, x), y: openAcross(work.reading, work.normalised, faults), dotted: dottedWork }
          : { dotted, x: QUANTITIES[x].of(columns).map((v) => by(v, x === "p_eff")), y: QUANTITIES[y].of(columns).map((v) => by(v, relates)) }) };
        const onset = x === "p_eff" ? marks({ ...document.collapse, truth: null }, "pq", false).map((m) => ({ ...m, x: m.x / p0, y: m.y / p0, colour })) : [];
        return [line, ...onset];
      }), y === "work" ? { y: [-1.08, 1.08] } : {});
      charts.push(chart);
      return chart.node;
    };
    const high = innerWidth < 640 ? 230 : 330;
    fill(grid, el("div", {}, make("p_eff", "q", high, true), make("axial", "u", high, true)), el("div", {}, make("axial", "q", high, true), make("axial", "work", high, false)));
  };
  fill(main, el("div", { class: "stack" }, el("div", { class: "head" }, el("h1", { tabindex: -1 }, `${tests.length} tests over each other`),
    segments("Stresses", [[false, "kPa"], [true, "over p′₀"]], false, (value) => {
      relative = value;
      build();
    })),
  legend(tests.map(({ document }, i) => [document.test.name, STYLES[i][0], STYLES[i][1].length ? STYLES[i][1] : LINE[0]])),
  grid, el("p", { class: "quiet" }, "From the start of shear, axial strain from there. Rings: onset of instability, diamonds: loss of control."), summary(tests)));
  build();
  return { title: "Compare", end: () => charts.forEach((chart) => chart.end()) };
}
