// SPDX-License-Identifier: GPL-3.0-or-later
import { el, svg } from "./dom.js";

const stroke = (colour) => `var(--${colour})`;

function sample(colour, kind) {
  const line = (more) => svg("line", { x1: 1, y1: 6, x2: 25, y2: 6, stroke: stroke(colour), "stroke-width": 2.2, ...more });
  switch (kind) {
    case "ring": return [svg("circle", { cx: 13, cy: 6, r: 4.5, fill: "none", stroke: stroke(colour), "stroke-width": 2.2 })];
    case "diamond": return [svg("path", { d: "M13 1l5 5l-5 5l-5-5z", fill: "none", stroke: stroke(colour), "stroke-width": 2.2 })];
    case "cross": return [svg("path", { d: "M9 2l8 8M9 10l8-8", stroke: stroke(colour), "stroke-width": 2.2 })];
    case "band": return [svg("rect", { x: 1, y: 1, width: 24, height: 10, fill: stroke(colour), "fill-opacity": 0.3 })];
    case "cell": return [svg("rect", { x: 1, y: 1, width: 24, height: 10, fill: stroke(colour), "fill-opacity": 0.45 })];
    case "dash": return [line({ "stroke-dasharray": "6 3" })];
    case "dots": return [line({ "stroke-dasharray": "2 3" })];
    default: return [Array.isArray(kind) ? line({ "stroke-dasharray": kind.join(" ") }) : line({})];
  }
}

/** [[text, colour, kind], ...] */
export const legend = (entries) =>
  el("ul", { class: "legend" }, entries.map(([text, colour, kind]) =>
    el("li", {}, svg("svg", { viewBox: "0 0 26 12", "aria-hidden": "true" }, sample(colour, kind)), text)));
