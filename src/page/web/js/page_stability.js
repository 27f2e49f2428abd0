// SPDX-License-Identifier: GPL-3.0-or-later
// Where a material is unstable: its domain in the p′-q plane, the cone of unstable directions at a cursor, and the cones along
// the stress path of a test.
import { get, post, windowPath } from "./api.js";
import "./cells.js";
import { dottedPlaces, placesAfter } from "./breaks.js";
import { Chart } from "./chart.js";
import { circularDiagram } from "./circular_diagram.js";
import { along, conesTable } from "./cones_along.js";
import { el, field, fill, select } from "./dom.js";
import { fixed } from "./format.js";
import { legend } from "./legend.js";
import { failed } from "./notice.js";

const GRID = 60;
const LEGEND = [["unstable: W₂ < 0 in some direction; the deeper, the more negative", "vermilion", "cell"], ["first unstable direction", "vermilion", "line"],
  ["isotropic unloading unstable (dq = 0, dp′ < 0)", "blue", "dash"], ["limit", "ink", "line"], ["beyond the limit", "grey", "cell"], ["cones of unstable directions along the test", "purple", "cell"]];

/** What was asked for last, while the page is open. */
const kept = { material: "inl2/S28-general", e: "1.086", p: "300", test: "", cursor: null };

/** The cone of the material at one state. */
async function probed([p, q], signal) {
  const document = await post("/api/probe", { material: kept.material, void_ratio: Number(kept.e), p_kPa: p, q_kPa: [q] }, signal);
  return document.states?.[0] ?? document;
}

/** One domain is computed at a time: who comes too early asks again. */
async function domainOf(signal) {
  const body = { material: kept.material, void_ratio: Number(kept.e), p_from_kPa: 10, p_to_kPa: Number(kept.p), q_from_kPa: 0, q_to_kPa: Math.round(Number(kept.p) * 1.3), columns: GRID, rows: GRID, directions: 180 };
  for (let left = 20; ; --left) {
    try {
      return await post("/api/domain", body, signal);
    } catch (failure) {
      if (failure.status !== 503 || left === 0) throw failure;
      await new Promise((done) => setTimeout(done, 300));
    }
  }
}

const figure = (name, value, unit) => el("div", { class: "figure" }, el("dt", {}, name), el("dd", {}, value, " ", el("small", {}, unit)));
const figures = ([p, q]) => el("dl", { class: "figures" }, figure("p′", fixed(p), "kPa"), figure("q", fixed(q), "kPa"), figure("η", fixed(q / p, 3), ""));

class StabilityPage {
  constructor(main, materials, tests) {
    Object.assign(this, { materials, tests, domain: null, path: null, wedges: [], limit: Infinity, asked: null, timer: 0, probing: false });
    this.wrong = el("div", { "aria-live": "polite" });
    this.side = el("section", { class: "panel", "aria-label": "State at the cursor", "aria-live": "polite" });
    this.table = el("div");
    this.about = el("p", { class: "quiet" });
    this.chart = new Chart({ title: "Domain of instability; arrow keys move the cursor", height: innerWidth < 640 ? 300 : 470, x: { title: "mean effective stress p′ (kPa)" }, y: { title: "deviator stress q (kPa)" },
      does: { move: (p, q) => this.moved(p, q) } });
    this.chart.node.addEventListener("keydown", (event) => this.key(event));
    fill(main, el("div", { class: "stack" }, el("h1", { tabindex: -1 }, "Stability of a material"), this.form(), this.about, this.wrong,
      el("div", { class: "two" }, el("div", { class: "stack" }, this.chart.node, legend(LEGEND)), this.side), this.table));
    this.tellMaterial();
    this.compute();
  }

  form() {
    this.e = el("input", { type: "number", step: "any", min: 0.2, max: 3, value: kept.e, required: true });
    this.p = el("input", { type: "number", step: "any", min: 20, max: 5000, value: kept.p, required: true });
    this.material = select(this.materials.map((m) => [m.name, m.name]), kept.material, (name) => {
      kept.material = name;
      this.tellMaterial();
    });
    return el("form", { class: "filters panel", on: { submit: (event) => {
      event.preventDefault();
      this.compute();
    } } }, field("Material", this.material), field("Void ratio e (–)", this.e), field("p′ up to (kPa)", this.p),
    field("Stress path of", select([["", "no test"], ...this.tests.map((t) => [String(t.test.id), t.test.name])], kept.test, (id) => this.chooseTest(id))),
    el("button", { class: "main", type: "submit" }, "Compute"));
  }

  testOf(id) {
    return this.tests.find((t) => String(t.test.id) === id);
  }

  /** The domain is then that of the test's material, void ratio and pressures. */
  chooseTest(id) {
    kept.test = id;
    const { consolidation, specimen } = this.testOf(id) ?? {};
    const ratio = consolidation?.void_ratio ?? specimen?.void_ratio;
    if (ratio) this.e.value = ratio.toFixed(3);
    if (this.materials.some((m) => m.name === specimen?.material)) this.material.value = kept.material = specimen.material;
    if (consolidation?.p_eff_kPa) this.p.value = String(Math.ceil((consolidation.p_eff_kPa * 1.15) / 10) * 10);
    this.tellMaterial();
    this.compute();
  }

  tellMaterial() {
    const found = this.materials.find((m) => m.name === kept.material);
    this.about.textContent = found ? [`${found.name}: ${found.description ?? ""}`, found.range].filter(Boolean).join("; ") : "";
  }

  async compute() {
    if (kept.p !== this.p.value) kept.cursor = null;
    Object.assign(kept, { e: this.e.value, p: this.p.value });
    kept.cursor ??= [Number(kept.p) * 0.4, Number(kept.p) * 0.28];
    fill(this.wrong, el("p", { class: "quiet", role: "status" }, "Computing…"));
    this.asked?.abort();
    this.asked = new AbortController();
    try {
      this.domain = await domainOf(this.asked.signal);
      this.limit = Math.min(...this.domain.boundaries.map((b) => b.limit?.eta ?? Infinity).filter((v) => v > 0));
      await this.alongTest(this.asked.signal);
      fill(this.wrong, this.domain.warnings.length ? el("ul", { class: "notice" }, this.domain.warnings.map((w) => el("li", {}, w))) : null);
      this.draw();
      this.probe();
    } catch (failure) {
      if (failure.name !== "AbortError") fill(this.wrong, failed(failure));
    }
  }

  /** The stress path of the test in shear, and cones at points of it that the material knows. */
  async alongTest(signal) {
    const from = this.testOf(kept.test)?.collapse.judged?.from_reading ?? 0;
    const window = kept.test ? await get(windowPath(kept.test, ["axial_strain", "q_kPa", "p_eff_kPa"], { from, pixels: 100 }), signal) : null;
    this.path = window && { ...window.columns, dotted: dottedPlaces(window.columns.reading, window.unread_steps) };
    const points = this.path ? along(this.path.p_eff_kPa, this.path.q_kPa, new Set([...this.path.dotted, ...placesAfter(window.columns.reading, window.faults)])).filter(([p, q]) => p - q / 3 > 5 && q >= 0 && q / p < 0.97 * this.limit && p <= Number(kept.p)) : [];
    const states = await Promise.all(points.map((point) => probed(point, signal)));
    this.wedges = states.map((s) => ({ p: s.state.p_eff_kPa, q: s.state.q_kPa, cones: s.cones }));
    fill(this.table, states.length ? conesTable(states) : null);
  }

  draw() {
    const { grid, states, boundaries } = this.domain;
    const compression = boundaries.filter((b) => b.side === "compression");
    const edge = (key) => ({ kind: "line", x: compression.map((b) => b.p_eff_kPa), y: compression.map((b) => b[key]?.q_kPa ?? null) });
    this.chart.set([{ kind: "cells", states, dp: (grid.p_to_kPa - grid.p_from_kPa) / (grid.columns - 1), dq: (grid.q_to_kPa - grid.q_from_kPa) / (grid.rows - 1) },
      { ...edge("limit"), colour: "ink", width: 1.6 }, { ...edge("isotropic_unloading"), colour: "blue", dash: [7, 4] }, { ...edge("first_unstable"), colour: "vermilion", width: 2.2 },
      ...(this.path ? [{ kind: "line", x: this.path.p_eff_kPa, y: this.path.q_kPa, dotted: this.path.dotted, colour: "ink", width: 1.4 }] : []), { kind: "wedges", wedges: this.wedges }],
    { x: [0, grid.p_to_kPa], y: [Math.min(0, grid.q_from_kPa), grid.q_to_kPa] });
    requestAnimationFrame(() => this.chart.mark(...kept.cursor));
  }

  moved(p, q) {
    if (!this.domain || p <= 0) return;
    kept.cursor = [p, Math.max(0, q)];
    this.chart.mark(...kept.cursor);
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.probe(), 60);
  }

  key(event) {
    const [dp, dq] = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key] ?? [0, 0];
    if (!dp && !dq) return;
    event.preventDefault();
    const step = (Number(kept.p) / 100) * (event.shiftKey ? 10 : 1);
    const [p, q] = kept.cursor;
    this.moved(Math.min(Number(kept.p), Math.max(step, p + dp * step)), q + dq * step);
  }

  /** One answer at a time; a cursor that moved on meanwhile is asked for next. */
  async probe() {
    if (this.probing) return;
    this.probing = true;
    const at = kept.cursor;
    const show = (...content) => fill(this.side, el("h2", {}, "At the cursor"), figures(at), content);
    try {
      if (at[1] / at[0] >= this.limit) show(el("p", {}, "Beyond the limit of the material: no such state."));
      else show(this.cone(await probed(at)));
    } catch (failure) {
      show(el("p", { class: "quiet" }, failure.message));
    } finally {
      this.probing = false;
      if (kept.cursor !== at) this.probe();
    }
  }

  cone(state) {
    const said = state.cones.map((c) => `Unstable from ${fixed(c.from_deg)}° to ${fixed(c.to_deg)}°, opening ${fixed(c.to_deg - c.from_deg)}°.`).join(" ");
    return [circularDiagram(state), el("p", {}, said || "Stable in every direction."),
      state.least ? el("p", { class: "quiet" }, `Least W₂ ${fixed(state.least.w2_normalised, 3)} at ${fixed(state.least.alpha_deg)}°.`) : null];
  }

  leave() {
    this.asked?.abort();
    clearTimeout(this.timer);
    this.chart.end();
  }
}

export async function show(main) {
  const [laws, { tests }] = await Promise.all([get("/api/materials"), get("/api/tests")]);
  const page = new StabilityPage(main, laws.flatMap((law) => law.sets), tests);
  return { title: "Stability", end: () => page.leave() };
}
