// SPDX-License-Identifier: GPL-3.0-or-later
// The large numbers and the curves of a running test.
import { Chart } from "./chart.js";
import { el } from "./dom.js";
import { fixed, left, time } from "./format.js";
import { QUANTITIES, WORK, axisTitle } from "./quantities.js";
import { lines } from "./stress_layers.js";

/** M of a friction angle: 6 sin φ / (3 − sin φ). */
export function limitOf(degrees) {
  if (typeof degrees !== "number") return null;
  const sine = Math.sin((degrees * Math.PI) / 180);
  return (6 * sine) / (3 - sine);
}

function big(name, value, unit) {
  return el("div", { class: "big" }, el("div", { class: "value" }, value, " ", el("small", {}, unit)), el("div", { class: "name" }, name));
}

export function numbers(row, eta, { forecast, lost }) {
  const amount = lost ? null : left(forecast?.left);
  const away = lost ? big("to the instability line: passed", "–", "") : forecast && eta !== null
    ? big(`η to the instability line, ± ${fixed((forecast.eta_high - forecast.eta_low) / 2, 2)}`, fixed(forecast.eta_forecast - eta, 2), "") : big("to the instability line: no forecast", "–", "");
  return [big("stress ratio η = q/p′", fixed(eta, 2), ""), away, amount ? big(`left, of ${amount.of}`, amount.value, amount.unit) : big("left", "–", ""),
    big("deviator stress q", fixed(row?.q_kPa), "kPa"), big("pore pressure u", fixed(row?.pore_pressure_kPa), "kPa"),
    big(`axial strain ε₁, at ${time(row?.time_s)}`, typeof row?.axial_strain === "number" ? fixed(100 * row.axial_strain, 2) : "–", "%")];
}

const CHARTS = [["p_eff", "q", 330], ["axial", "q", 176], ["time", "u", 160], ["time", "volume", 160], ["time", "work", 160]];
const COLOURS = { u: "green", volume: "orange", work: "purple" };
/** Milliseconds between two drawings of all charts but the stress path, which is drawn with every frame. */
const PAUSE = 400;

function makeChart([x, y, height]) {
  const { title, symbol, unit } = QUANTITIES[y] ?? WORK;
  const short = y === "work" ? "W₂ normalised (–)" : `${symbol} (${unit})`;
  return { x, y, chart: new Chart({ title: `${title} over ${QUANTITIES[x].title}, live`, height, cursor: false, nothing: "none yet", x: { title: axisTitle(x) }, y: { title: height < 200 ? short : axisTitle(y) } }) };
}

function workLayers({ time_s: time, normalised, error, dotted }) {
  const x = time.map((t) => t / 60);
  const edge = (sign) => normalised.map((w, i) => (w === null || error[i] === null || dotted.has(i) ? null : w + sign * error[i]));
  return [{ kind: "band", x, low: edge(-1), high: edge(1), colour: "purple" }, { kind: "level", y: 0, colour: "grey" }, { kind: "line", x, y: normalised, dotted, colour: "purple" }];
}

function curve({ shown, dotted, now }, x, y) {
  const line = { kind: "line", x: QUANTITIES[x].of(shown), y: QUANTITIES[y].of(shown), dotted, colour: COLOURS[y] ?? "blue", range: y === "q" ? { y: [0, 10] } : null };
  return now ? [line, { kind: "mark", shape: "dot", colour: "ink", ranged: false, x: line.x.at(-1), y: line.y.at(-1) }] : [line];
}

/** The curves of what runs; show({rows, work, forecast, limit}, at) at a time in milliseconds. */
export function liveCharts() {
  const charts = CHARTS.map(makeChart);
  let last = -PAUSE;
  return { node: el("div", { class: "charts" }, el("div", {}, charts.slice(0, 2).map((c) => c.chart.node)), el("div", {}, charts.slice(2).map((c) => c.chart.node))),
    end: () => charts.forEach(({ chart }) => chart.end()),
    show: ({ rows, work, forecast, limit }, at) => {
      charts[0].chart.set([...lines({ eta: forecast?.eta_forecast, limit_stress_ratio: limit }, "pq", false), ...curve(rows, "p_eff", "q")]);
      if (at - last < PAUSE) return;
      last = at;
      for (const { x, y, chart } of charts.slice(1)) {
        if (y !== "work") chart.set(curve(rows, x, y));
        else if (work) chart.set(workLayers(work), { y: [-1.08, 1.08] });
      }
    } };
}
