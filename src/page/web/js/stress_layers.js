// SPDX-License-Identifier: GPL-3.0-or-later
// Marks and lines of one test, from its document: onset, loss of control, truth, instability line, limit surface.
import { fixed } from "./format.js";
import { onAxes, slopeOn } from "./quantities.js";

const known = (at) => at && typeof at.q_kPa === "number" && typeof at.p_eff_kPa === "number";

/** The instability line and the limit surface, which are lines of effective stress. */
export function lines(collapse, view, total) {
  if (total) return [];
  const layers = [];
  if (collapse.limit_stress_ratio) {
    const slope = slopeOn(collapse.limit_stress_ratio, view);
    const [x, y] = onAxes({ p_eff_kPa: 0, q_kPa: collapse.limit_intercept_kPa ?? 0, pore_pressure_kPa: 0 }, view, false);
    layers.push({ kind: "ray", slope, intercept: y - slope * x, colour: "ink", label: `M ${fixed(collapse.limit_stress_ratio, 2)}` });
  }
  if (collapse.eta)
    layers.push({ kind: "ray", slope: slopeOn(collapse.eta, view), colour: "vermilion", text: "alarm", dash: [7, 4], along: 0.45, label: `η ${fixed(collapse.eta, 2)}` });
  return layers;
}

export function marks(collapse, view, total) {
  const layers = [];
  const put = (at, more) => {
    if (!known(at) || (total && typeof at.pore_pressure_kPa !== "number")) return;
    const [x, y] = onAxes(at, view, total);
    layers.push({ kind: "mark", x, y, ...more });
  };
  put(collapse, { shape: "ring", colour: "vermilion" });
  put(collapse.loss_of_control, { shape: "diamond", colour: "purple" });
  if (collapse.truth?.lost_sustainability) put(collapse.truth, { shape: "cross", colour: "ink" });
  return layers;
}

/** Vertical rules at onset, loss of control and truth where time or axial strain runs to the right. */
export function rules(collapse, axis) {
  const at = (moment) => {
    const value = axis === "time" ? moment?.time_s : moment?.axial_strain;
    return typeof value === "number" ? value * (axis === "time" ? 1 / 60 : 100) : null;
  };
  const layers = [];
  const put = (x, more) => x !== null && layers.push({ kind: "rule", x, ...more });
  if (collapse.detected) put(at(collapse), { colour: "vermilion", width: 1.6 });
  put(at(collapse.loss_of_control), { colour: "purple", dash: [8, 3, 2, 3], width: 1.6 });
  if (collapse.truth?.lost_sustainability) put(at(collapse.truth), { colour: "ink", dash: [2, 3], width: 1.6 });
  return layers;
}

export const LEGEND = {
  path: ["stress path or history", "blue", "line"], limit: ["limit surface, slope M", "ink", "line"],
  instability: ["instability line through the onset", "vermilion", "dash"], onset: ["onset of instability", "vermilion", "ring"],
  control: ["loss of control", "purple", "diamond"],
  unread: ["nothing was read between", "blue", "dots"],
  truth: ["truth: the simulated specimen itself", "ink", "cross"], band: ["one standard error of W₂", "purple", "band"],
};
