// SPDX-License-Identifier: GPL-3.0-or-later
// How far the stress ratio is from the instability line: now, the forecast with its band, and the limit surface.
import { fill, svg } from "./dom.js";
import { fixed } from "./format.js";

const WIDE = 640;

/** eta: now; forecast: {eta_forecast, eta_low, eta_high} or null; limit: M or null. */
export function gauge(node, { eta, forecast, limit }) {
  const most = Math.max(0.1, eta ?? 0, forecast?.eta_high ?? 0, limit ?? 0) * 1.06;
  const x = (v) => (Math.max(0, v) / most) * WIDE;
  const known = typeof eta === "number";
  const close = known && limit && Math.abs(x(eta) - x(limit)) < 150;
  fill(node,
    svg("rect", { class: "scale", x: 0, y: 22, width: WIDE, height: 26, rx: 5 }),
    known ? svg("rect", { class: "done", x: 0, y: 22, width: x(eta), height: 26, rx: 5 }) : null,
    forecast ? [svg("rect", { class: "band", x: x(forecast.eta_low), y: 16, width: Math.max(2, x(forecast.eta_high) - x(forecast.eta_low)), height: 38 }),
      svg("line", { class: "best", x1: x(forecast.eta_forecast), x2: x(forecast.eta_forecast), y1: 14, y2: 56 }),
      svg("text", { x: x(forecast.eta_forecast), y: 11, "text-anchor": "middle" }, `instability line η ${fixed(forecast.eta_forecast, 2)}`)] : null,
    limit ? [svg("line", { class: "limit", x1: x(limit), x2: x(limit), y1: 16, y2: 54 }), svg("text", { class: "soft", x: x(limit), y: close ? 86 : 70, "text-anchor": "end" }, `limit surface M ${fixed(limit, 2)}`)] : null,
    known ? svg("text", { x: Math.min(WIDE - 60, Math.max(0, x(eta) - 4)), y: 70, "text-anchor": x(eta) > 60 ? "end" : "start" }, `now η ${fixed(eta, 2)}`) : null);
  node.setAttribute("aria-label", known ? `stress ratio ${fixed(eta, 2)}${forecast ? `, forecast of the onset at ${fixed(forecast.eta_forecast, 2)}, between ${fixed(forecast.eta_low, 2)} and ${fixed(forecast.eta_high, 2)}` : ", no forecast"}` : "stress ratio unknown");
}

export const gaugeNode = () => svg("svg", { class: "gauge", viewBox: `0 0 ${WIDE} 88`, role: "img" });
