// SPDX-License-Identifier: GPL-3.0-or-later
// The linked charts of one test: stress path, q over strain, pore pressure, volume, second-order work with its band.
import { get, windowPath } from "./api.js";
import { dottedPlaces, openAcross } from "./breaks.js";
import { Chart } from "./chart.js";
import { el, fill, segments } from "./dom.js";
import { fixed, time } from "./format.js";
import { KEYS, Linked, placeOf } from "./linked.js";
import { legend } from "./legend.js";
import { failed } from "./notice.js";
import { COLUMNS, QUANTITIES, WORK, at, axisTitle, shown } from "./quantities.js";
import { LEGEND, lines, marks, rules } from "./stress_layers.js";

/** Of the width of all charts that of the widest axis. */
const PART = 0.45;
const READ = ["q", "p_eff", "u", "axial", "volume"];

export class TestCharts {
  constructor(id, document) {
    const readings = document.test.readings;
    const shear = document.collapse.judged?.from_reading ?? 0;
    Object.assign(this, { id, document, view: "pq", total: false, log: false, axis: document.test.axis === "axial_strain" ? "axial" : "time",
      part: shear > 0 ? "shear" : "all", shear, last: Math.max(1, readings - 1) });
    this.grid = el("div", { class: "charts" });
    this.readout = el("output", { class: "readout", "aria-live": "polite" });
    this.legend = el("div");
    this.node = el("section", { class: "stack", "aria-label": "Charts" }, this.choices(), this.grid, this.readout, this.legend, this.keys());
    this.build();
  }

  choices() {
    const set = (name) => (value) => {
      this[name] = value;
      this.build();
    };
    return el("div", { class: "row" },
      segments("Stresses", [[false, "effective"], [true, "total"]], this.total, set("total")),
      segments("Stress axes", [["pq", "p′, q"], ["st", "s′, t"]], this.view, set("view")),
      segments("Histories over", [["time", "time"], ["axial", "strain"]], this.axis, set("axis")),
      segments("Stress scales", [[false, "linear"], [true, "log"]], this.log, set("log")),
      segments("Part of the test", [["shear", "shear"], ["all", "whole test"]], this.part, set("part")),
      el("button", { type: "button", on: { click: () => this.linked.zoom(0.5) }, "aria-label": "Zoom in" }, "+"),
      el("button", { type: "button", on: { click: () => this.linked.zoom(2) }, "aria-label": "Zoom out" }, "−"),
      el("button", { type: "button", on: { click: () => this.linked.whole() } }, "All"));
  }

  keys() {
    return el("p", { class: "keys" }, "Drag to zoom, double click for all. On a chart: ",
      KEYS.map(([keys, does], i) => [i ? ", " : "", keys.map((key) => [el("kbd", {}, key), " "]), does]), ".");
  }

  /** Charts are made anew when what stands on their axes changes. */
  build() {
    const cursor = this.linked?.at ?? null;
    this.end();
    const from = this.part === "shear" ? this.shear : 0;
    this.linked = new Linked({ all: { from, to: this.last },
      load: ({ from: first, to }, signal) => get(windowPath(this.id, COLUMNS, { from: first, to, pixels: this.grid.clientWidth * PART || 500, work: true }), signal),
      changed: (data) => this.draw(data), told: (reading) => this.read(reading), wrong: (failure) => fill(this.grid, failed(failure)) });
    this.panels = [];
    const stress = this.view === "st" ? [this.total ? "s_total" : "s_eff", "t"] : [this.total ? "p_total" : "p_eff", "q"];
    const height = innerWidth < 640 ? 230 : 300;
    const lower = innerWidth < 640 ? 170 : 197;
    const left = el("div", {}, this.panel(stress, height, { box: true, log: this.log ? "xy" : "" }), this.panel(["axial", "q"], height, { log: this.log ? "y" : "" }));
    const right = el("div", {}, ["u", "volume", "work"].map((y) => this.panel([this.axis, y], lower, {})));
    fill(this.grid, left, right);
    this.linked.at = cursor;
    this.ready = this.linked.whole();
  }

  legendOf(unread) {
    const { collapse } = this.document;
    const has = { path: true, unread, limit: !this.total && collapse.limit_stress_ratio, instability: !this.total && collapse.eta, onset: collapse.detected, control: collapse.loss_of_control,
      truth: collapse.truth?.lost_sustainability, band: true };
    return Object.keys(LEGEND).filter((key) => has[key]).map((key) => LEGEND[key]);
  }

  panel([x, y], height, { box = false, log = "" }) {
    const what = QUANTITIES[y] ?? WORK;
    const chart = new Chart({ title: `${what.title} over ${QUANTITIES[x].title}`, height,
      x: { title: axisTitle(x), log: log.includes("x") }, y: { title: y === "work" ? "W₂ normalised (–)" : height < 220 ? `${what.symbol} (${what.unit})` : axisTitle(y), log: log.includes("y") },
      does: { box, all: () => this.linked.whole(), pick: (area) => this.linked.pick(chart, area), move: (a, b, scale) => this.linked.near(chart, a, b, scale) } });
    chart.node.addEventListener("keydown", (event) => this.linked.key(event));
    this.linked.add(chart, ({ columns, work, faults, unread_steps: unread }) => (y === "work"
      ? { reading: work.reading, x: at(work.reading, columns, x), y: openAcross(work.reading, work.normalised, faults), dotted: dottedPlaces(work.reading, unread) }
      : { reading: columns.reading, x: QUANTITIES[x].of(columns), y: QUANTITIES[y].of(columns), dotted: dottedPlaces(columns.reading, unread) }));
    this.panels.push({ chart, x, y });
    return chart.node;
  }

  draw({ work, unread_steps: unread }) {
    const { collapse } = this.document;
    fill(this.legend, legend(this.legendOf(unread.length > 0)));
    for (const { chart, x, y } of this.panels) {
      const points = this.linked.pointsOf(chart);
      const line = { kind: "line", x: points.x, y: points.y, dotted: points.dotted, colour: { u: "green", volume: "orange", work: "purple" }[y] ?? "blue" };
      if (chart.does.box) chart.set([...lines(collapse, this.view, this.total), line, ...marks(collapse, this.view, this.total).map((m) => ({ ...m, ranged: false }))]);
      else if (y === "work") chart.set([this.band(work, points), { kind: "level", y: 0, colour: "grey" }, line, ...rules(collapse, x)], { y: [-1.08, 1.08] });
      else chart.set([line, ...rules(collapse, x)]);
    }
  }

  band({ error }, { x, y, dotted }) {
    const edge = (sign) => y.map((w, i) => (w === null || error[i] === null || dotted.has(i) ? null : w + sign * error[i]));
    return { kind: "band", x, low: edge(-1), high: edge(1), colour: "purple" };
  }

  read(reading) {
    const { columns, work } = this.linked.data ?? {};
    const index = reading === null || !columns ? null : placeOf(columns.reading, reading);
    if (index === null) {
      const { from, to } = this.linked.range;
      fill(this.readout, el("span", { class: "quiet" }, `readings ${from} to ${to}; no cursor`));
      return;
    }
    const pair = ([symbol, value]) => el("span", {}, el("b", {}, symbol), " ", value);
    const of = placeOf(work.reading, reading);
    const near = of !== null && Math.abs(work.reading[of] - reading) <= Math.max(20, (this.linked.range.to - this.linked.range.from) / 200) ? of : null;
    fill(this.readout, pair(["reading", String(columns.reading[index])]), pair(["t", time(columns.time_s[index])]),
      READ.map((key) => pair(shown(key, QUANTITIES[key].of(columns)[index]))),
      pair(["W₂", near === null ? "–" : `${fixed(work.normalised[near], 3)} ± ${fixed(work.error[near], 3)}`]));
  }

  goTo(reading) {
    if (reading < this.linked.range.from || reading > this.linked.range.to) {
      this.part = "all";
      this.build();
    }
    this.ready.then(() => this.linked.point(reading));
  }

  end() {
    this.panels?.forEach(({ chart }) => chart.end());
  }
}
