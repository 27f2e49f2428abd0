// SPDX-License-Identifier: GPL-3.0-or-later
// What can stand on an axis: how it is called, its unit, and how it comes from the columns of a window.
import { fixed } from "./format.js";

const scaled = (column, factor) => (w) => w[column].map((v) => (v === null ? null : v * factor));
const both = (a, b, f) => (w) => w[a].map((v, i) => (v === null || w[b][i] === null ? null : f(v, w[b][i])));

export const QUANTITIES = {
  time: { symbol: "t", title: "time", unit: "min", needs: ["time_s"], places: 1, of: scaled("time_s", 1 / 60) },
  reading: { symbol: "reading", title: "reading", unit: "–", needs: [], places: 0, of: (w) => w.reading },
  axial: { symbol: "ε₁", title: "axial strain ε₁", unit: "%", needs: ["axial_strain"], places: 2, of: scaled("axial_strain", 100) },
  volume: { symbol: "εᵥ", title: "volumetric strain εᵥ", unit: "%", needs: ["volumetric_strain"], places: 3, of: scaled("volumetric_strain", 100) },
  q: { symbol: "q", title: "deviator stress q", unit: "kPa", needs: ["q_kPa"], places: 1, of: (w) => w.q_kPa },
  p_eff: { symbol: "p′", title: "mean effective stress p′", unit: "kPa", needs: ["p_eff_kPa"], places: 1, of: (w) => w.p_eff_kPa },
  p_total: { symbol: "p", title: "mean total stress p", unit: "kPa", needs: ["p_eff_kPa", "pore_pressure_kPa"], places: 1,
    of: both("p_eff_kPa", "pore_pressure_kPa", (p, u) => p + u) },
  t: { symbol: "t", title: "t = (σ₁ − σ₃)/2", unit: "kPa", needs: ["q_kPa"], places: 1, of: scaled("q_kPa", 0.5) },
  s_eff: { symbol: "s′", title: "s′ = (σ′₁ + σ′₃)/2", unit: "kPa", needs: ["p_eff_kPa", "q_kPa"], places: 1,
    of: both("p_eff_kPa", "q_kPa", (p, q) => p + q / 6) },
  s_total: { symbol: "s", title: "s = (σ₁ + σ₃)/2", unit: "kPa", needs: ["p_eff_kPa", "q_kPa", "pore_pressure_kPa"], places: 1,
    of: (w) => w.q_kPa.map((q, i) => (q === null || w.p_eff_kPa[i] === null || w.pore_pressure_kPa[i] === null ? null : w.p_eff_kPa[i] + q / 6 + w.pore_pressure_kPa[i])) },
  u: { symbol: "u", title: "pore pressure u", unit: "kPa", needs: ["pore_pressure_kPa"], places: 1, of: (w) => w.pore_pressure_kPa },
};

export const COLUMNS = [...new Set(Object.values(QUANTITIES).flatMap((quantity) => quantity.needs))];
/** Second-order work has points of its own, which stand at readings. */
export const WORK = { symbol: "W₂", title: "normalised second-order work W₂", unit: "–" };

/** What stands on an axis at these readings, from the window's columns; nothing where that reading is not in it. */
export function at(readings, columns, key) {
  const values = QUANTITIES[key].of(columns);
  let i = 0;
  return readings.map((reading) => {
    while (i < columns.reading.length && columns.reading[i] < reading) ++i;
    if (i === columns.reading.length) return null;
    if (columns.reading[i] === reading || i === 0) return values[i];
    const [a, b] = [values[i - 1], values[i]];
    if (a === null || b === null) return null;
    return a + ((b - a) * (reading - columns.reading[i - 1])) / (columns.reading[i] - columns.reading[i - 1]);
  });
}

export const axisTitle = (key) => `${QUANTITIES[key].title} (${QUANTITIES[key].unit})`;
export const shown = (key, value) => {
  const { symbol, unit, places } = QUANTITIES[key];
  return [symbol, `${fixed(value, places)}${unit === "–" ? "" : ` ${unit}`}`];
};

/** A stress point (p′, q, u) on the axes chosen: view "pq" or "st", total or effective. */
export function onAxes({ p_eff_kPa: p, q_kPa: q, pore_pressure_kPa: u }, view, total) {
  const add = total ? u : 0;
  return view === "st" ? [p + q / 6 + add, q / 2] : [p + add, q];
}

/** The slope of a line q = eta p′ on these axes. */
export const slopeOn = (eta, view) => (view === "st" ? (3 * eta) / (6 + eta) : eta);
