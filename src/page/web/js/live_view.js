// SPDX-License-Identifier: GPL-3.0-or-later
// The large numbers and the curves of a running test.
import { Chart } from "./chart.js";
import { el } from "./dom.js";
import { fixed, left, time } from "./format.js";
import { QUANTITIES, axisTitle } from "./quantities.js";
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

/** The charts of what runs; show(rows, forecast, limit). */
export function liveCharts() {
  const make = (x, y, height) => new Chart({ title: `${QUANTITIES[y].title} over ${QUANTITIES[x].title}, live`, height, cursor: false,
    x: { title: axisTitle(x) }, y: { title: height < 200 ? `${QUANTITIES[y].symbol} (${QUANTITIES[y].unit})` : axisTitle(y) } });
  const charts = [["p_eff", "q", 330], ["time", "q", 158], ["time", "u", 158]].map(([x, y, height]) => ({ x, y, chart: make(x, y, height) }));
  return { node: el("div", { class: "charts" }, el("div", {}, charts[0].chart.node), el("div", {}, charts[1].chart.node, charts[2].chart.node)),
    end: () => charts.forEach(({ chart }) => chart.end()),
    show: ({ columns, now }, forecast, limit) => {
      for (const { x, y, chart } of charts) {
        const line = { kind: "line", x: QUANTITIES[x].of(columns), y: QUANTITIES[y].of(columns), colour: y === "u" ? "green" : "blue", range: y === "q" ? { y: [0, 10] } : null };
        const tip = now ? [{ kind: "mark", shape: "dot", colour: "ink", ranged: false, x: line.x.at(-1), y: line.y.at(-1) }] : [];
        const known = x === "p_eff" ? lines({ eta: forecast?.eta_forecast, limit_stress_ratio: limit }, "pq", false) : [];
        chart.set([...known, line, ...tip]);
      }
    } };
}
