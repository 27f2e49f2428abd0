// SPDX-License-Identifier: GPL-3.0-or-later
// Where a material is unstable: its domain in the p′-q plane, the cone of unstable directions at a cursor, and the cones along
// the stress path of a test.
import { get, post, windowPath } from "./api.js";
import "./cells.js";
import { Chart } from "./chart.js";
import { circularDiagram } from "./circular_diagram.js";
import { el, field, fill, select } from "./dom.js";
import { fixed } from "./format.js";
import { legend } from "./legend.js";
import { failed } from "./notice.js";

const GRID = 60;
const kept = { material: "inl2/S28-general", e: "1.086", p: "300", test: "", cursor: null };
const LEGEND = [["unstable: W₂ < 0 in some direction; the deeper, the more negative", "vermilion", "cell"], ["first unstable direction", "vermilion", "line"],
  ["isotropic unloading unstable (dq = 0, dp′ < 0)", "blue", "dash"], ["limit", "ink", "line"], ["beyond the limit", "grey", "cell"], ["cones of unstable directions along the test", "purple", "cell"]];

/** Some ten points of a path, evenly by its length on a square picture. */
function along(p, q, count = 10) {
  const known = p.map((v, i) => [v, q[i]]).filter(([a, b]) => a !== null && b !== null);
  const [wide, high] = [Math.max(1, ...known.map(([a]) => a)), Math.max(1, ...known.map(([, b]) => b))];
  const walked = [0];
  for (let i = 1; i < known.length; ++i) walked.push(walked[i - 1] + Math.hypot((known[i][0] - known[i - 1][0]) / wide, (known[i][1] - known[i - 1][1]) / high));
  const total = walked.at(-1) ?? 0;
  return Array.from({ length: total > 0 ? count : 0 }, (_, k) => {
    const here = (total * (k + 0.5)) / count;
    const i = walked.findIndex((w) => w >= here);
    const part = (here - walked[i - 1]) / (walked[i] - walked[i - 1]);
    return [0, 1].map((c) => known[i - 1][c] + part * (known[i][c] - known[i - 1][c]));
  });
}

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

export async function show(main) {
  const [laws, { tests }] = await Promise.all([get("/api/materials"), get("/api/tests")]);
  const materials = laws.flatMap((law) => law.sets);
  const view = { domain: null, path: null, wedges: [], limit: Infinity, asked: null };
  const wrong = el("div", { "aria-live": "polite" });
  const side = el("section", { class: "panel", "aria-label": "State at the cursor", "aria-live": "polite" });
  const table = el("div");
  const range = el("p", { class: "quiet" });
  const chart = new Chart({ title: "Domain of instability; arrow keys move the cursor", height: innerWidth < 640 ? 300 : 470, x: { title: "mean effective stress p′ (kPa)" }, y: { title: "deviator stress q (kPa)" },
    does: { move: (p, q) => moved(p, q) } });
  let timer = 0;

  const e = el("input", { type: "number", step: 0.001, min: 0.2, max: 3, value: kept.e, required: true });
  const p = el("input", { type: "number", step: 10, min: 20, max: 5000, value: kept.p, required: true });
  const form = el("form", { class: "filters panel", on: { submit: (event) => {
    event.preventDefault();
    compute();
  } } },
  field("Material", select(materials.map((m) => [m.name, m.name]), kept.material, (name) => {
    kept.material = name;
    told();
  })), field("Void ratio e (–)", e), field("p′ up to (kPa)", p),
  field("Stress path of", select([["", "no test"], ...tests.map((t) => [String(t.test.id), t.test.name])], kept.test, (id) => {
    kept.test = id;
    const found = tests.find((t) => String(t.test.id) === id);
    const ratio = found?.consolidation?.void_ratio ?? found?.specimen.void_ratio;
    if (ratio) e.value = ratio.toFixed(3);
    if (materials.some((m) => m.name === found?.specimen.material)) form.querySelector("select").value = kept.material = found.specimen.material;
    if (found?.consolidation?.p_eff_kPa) p.value = String(Math.ceil((found.consolidation.p_eff_kPa * 1.15) / 10) * 10);
    compute();
  })), el("button", { class: "main", type: "submit" }, "Compute"));

  function told() {
    const found = materials.find((m) => m.name === kept.material);
    range.textContent = found ? `${found.name}: ${found.description ? `${found.description}; ` : ""}${found.range ?? ""}` : "";
  }

  function draw() {
    if (!view.domain) return;
    const { grid, states, boundaries } = view.domain;
    const side1 = boundaries.filter((b) => b.side === "compression");
    const edge = (key) => ({ kind: "line", x: side1.map((b) => b.p_eff_kPa), y: side1.map((b) => b[key]?.q_kPa ?? null) });
    chart.set([{ kind: "cells", states, dp: (grid.p_to_kPa - grid.p_from_kPa) / (grid.columns - 1), dq: (grid.q_to_kPa - grid.q_from_kPa) / (grid.rows - 1) },
      { ...edge("limit"), colour: "ink", width: 1.6 }, { ...edge("isotropic_unloading"), colour: "blue", dash: [7, 4] }, { ...edge("first_unstable"), colour: "vermilion", width: 2.2 },
      ...(view.path ? [{ kind: "line", x: view.path.p_eff_kPa, y: view.path.q_kPa, colour: "ink", width: 1.4 }] : []), { kind: "wedges", wedges: view.wedges }],
    { x: [0, grid.p_to_kPa], y: [Math.min(0, grid.q_from_kPa), grid.q_to_kPa] });
    if (kept.cursor) requestAnimationFrame(() => chart.mark(...kept.cursor));
  }

  async function compute() {
    if (kept.p !== p.value) kept.cursor = null;
    Object.assign(kept, { e: e.value, p: p.value });
    fill(wrong, el("p", { class: "quiet", role: "status" }, "Computing…"));
    view.asked?.abort();
    view.asked = new AbortController();
    const { signal } = view.asked;
    try {
      view.domain = await domainOf(signal);
      view.limit = Math.min(...view.domain.boundaries.map((b) => b.limit?.eta ?? Infinity).filter((v) => v > 0));
      const from = tests.find((t) => String(t.test.id) === kept.test)?.collapse.judged?.from_reading ?? 0;
      view.path = kept.test ? (await get(windowPath(kept.test, ["q_kPa", "p_eff_kPa"], { from, pixels: 100 }), signal)).columns : null;
      const points = view.path ? along(view.path.p_eff_kPa, view.path.q_kPa).filter(([a, b]) => a - b / 3 > 5 && b >= 0 && b / a < 0.97 * view.limit && a <= Number(kept.p)) : [];
      const states = points.length ? await Promise.all(points.map((point) => probed(point, signal))) : [];
      view.wedges = states.map((s) => ({ p: s.state.p_eff_kPa, q: s.state.q_kPa, cones: s.cones }));
      fill(table, states.length ? conesTable(states) : null);
      fill(wrong, view.domain.warnings.length ? el("ul", { class: "notice" }, view.domain.warnings.map((w) => el("li", {}, w))) : null);
      kept.cursor ??= [Number(kept.p) * 0.4, Number(kept.p) * 0.28];
      draw();
      probe();
    } catch (failure) {
      if (failure.name !== "AbortError") fill(wrong, failed(failure));
    }
  }

  function moved(a, b) {
    if (!view.domain || a <= 0) return;
    kept.cursor = [a, Math.max(0, b)];
    chart.mark(...kept.cursor);
    clearTimeout(timer);
    timer = setTimeout(probe, 60);
  }

  let probing = false;
  async function probe() {
    if (probing || !kept.cursor) return;
    probing = true;
    const [a, b] = kept.cursor;
    try {
      if (b / a >= view.limit) return fill(side, el("h2", {}, "At the cursor"), figures(a, b), el("p", {}, "Beyond the limit of the material: no state of it."));
      const state = await probed([a, b]);
      fill(side, el("h2", {}, "At the cursor"), figures(a, b), circularDiagram(state),
        el("p", {}, state.cones.length ? state.cones.map((c) => `Unstable from ${fixed(c.from_deg)}° to ${fixed(c.to_deg)}°, opening ${fixed(c.opening_deg ?? c.to_deg - c.from_deg)}°.`).join(" ") : "Stable in every direction."),
        state.least ? el("p", { class: "quiet" }, `Least W₂ ${fixed(state.least.w2_normalised, 3)} at ${fixed(state.least.alpha_deg)}°.`) : null);
    } catch (failure) {
      fill(side, el("h2", {}, "At the cursor"), figures(a, b), el("p", { class: "quiet" }, failure.message));
    } finally {
      probing = false;
      if (kept.cursor[0] !== a || kept.cursor[1] !== b) probe();
    }
  }

  const figure = (name, value, unit) => el("div", { class: "figure" }, el("dt", {}, name), el("dd", {}, value, " ", el("small", {}, unit)));
  const figures = (a, b) => el("dl", { class: "figures" }, figure("p′", fixed(a), "kPa"), figure("q", fixed(b), "kPa"), figure("η", fixed(b / a, 3), ""));

  chart.node.addEventListener("keydown", (event) => {
    const [dp, dq] = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key] ?? [0, 0];
    if (!dp && !dq) return;
    event.preventDefault();
    const step = (Number(kept.p) / 100) * (event.shiftKey ? 10 : 1);
    const [a, b] = kept.cursor ?? [Number(kept.p) * 0.4, 0];
    moved(Math.min(Number(kept.p), Math.max(step, a + dp * step)), b + dq * step);
  });

  fill(main, el("div", { class: "stack" }, el("h1", { tabindex: -1 }, "Stability of a material"), form, range, wrong,
    el("div", { class: "two" }, el("div", { class: "stack" }, chart.node, legend(LEGEND)), side), table));
  told();
  compute();
  return { title: "Stability", end: () => {
    view.asked?.abort();
    clearTimeout(timer);
    chart.end();
  } };
}

function conesTable(states) {
  const cell = (label, text) => el("td", { class: "number", "data-label": label }, text);
  return el("section", { class: "panel" }, el("h2", {}, "Cones along the test"), el("div", { class: "scroll" }, el("table", { class: "folds" },
    el("thead", {}, el("tr", {}, ["p′ (kPa)", "q (kPa)", "η (–)", "cone (°)", "opening (°)", "least W₂ (–)"].map((t) => el("th", { scope: "col", class: "number" }, t)))),
    el("tbody", {}, states.map(({ state, cones, least }) => el("tr", {}, cell("p′ (kPa)", fixed(state.p_eff_kPa)), cell("q (kPa)", fixed(state.q_kPa)), cell("η (–)", fixed(state.eta, 3)),
      cell("cone (°)", cones.map((c) => `${fixed(c.from_deg)} to ${fixed(c.to_deg)}`).join(", ") || "none"), cell("opening (°)", cones.length ? cones.map((c) => fixed(c.to_deg - c.from_deg)).join(", ") : "–"),
      cell("least W₂ (–)", fixed(least?.w2_normalised, 3))))))));
}
