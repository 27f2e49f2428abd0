// SPDX-License-Identifier: GPL-3.0-or-later
// What is drawn in a chart. Colours are names of theme.js. Values of null are gaps.
//   {kind: "line", x, y, colour, width, dash, dotted}      x, y: arrays in the order of readings; dotted: places to which nothing
//                                                  was read from the place before (breaks.js)
//   {kind: "band", x, low, high, colour}
//   {kind: "ray", slope, intercept, colour, dash, label}      from x = 0; without an intercept through the origin
//   {kind: "mark", x, y, shape, colour, label}     shape "ring", "diamond", "cross" or "dot"
//   {kind: "rule", x, colour, dash}                a vertical line; {kind: "level", y} a horizontal one
//   {kind: "cells", ...}, {kind: "wedges", ...}    see cells.js
import { colour } from "./theme.js";

const px = () => window.devicePixelRatio || 1;

function stroke(u, layer) {
  const { ctx } = u;
  ctx.strokeStyle = colour(layer.colour ?? "ink");
  ctx.lineWidth = (layer.width ?? 1.8) * px();
  ctx.lineJoin = "round";
  ctx.setLineDash((layer.dash ?? []).map((v) => v * px()));
}

function trace(u, xs, ys, ctx, dotted) {
  let down = false;
  for (let i = 0; i < xs.length; ++i) {
    if (dotted?.has(i)) down = false;
    const x = xs[i];
    const y = ys[i];
    if (x === null || y === null) {
      down = false;
      continue;
    }
    const left = u.valToPos(x, "x", true);
    const top = u.valToPos(y, "y", true);
    if (!Number.isFinite(left) || !Number.isFinite(top)) down = false;
    else if (down) ctx.lineTo(left, top);
    else {
      ctx.moveTo(left, top);
      down = true;
    }
  }
}

function dots(u, { x, y, dotted, colour: name }) {
  if (!dotted?.size) return;
  stroke(u, { colour: name, width: 1.2, dash: [2, 3] });
  u.ctx.beginPath();
  for (const i of dotted) trace(u, x.slice(i - 1, i + 1), y.slice(i - 1, i + 1), u.ctx);
  u.ctx.stroke();
}

function band(u, { x, low, high, colour: name }) {
  const { ctx } = u;
  ctx.fillStyle = colour(name);
  ctx.globalAlpha = 0.22;
  for (let i = 0; i < x.length;) {
    if (low[i] === null || x[i] === null) {
      ++i;
      continue;
    }
    let end = i;
    while (end < x.length && low[end] !== null && x[end] !== null) ++end;
    ctx.beginPath();
    for (let k = i; k < end; ++k) ctx.lineTo(u.valToPos(x[k], "x", true), u.valToPos(high[k], "y", true));
    for (let k = end - 1; k >= i; --k) ctx.lineTo(u.valToPos(x[k], "x", true), u.valToPos(low[k], "y", true));
    ctx.fill();
    i = end;
  }
  ctx.globalAlpha = 1;
}

function label(u, text, left, top, name, align = "left") {
  const { ctx } = u;
  ctx.font = `${12 * px()}px system-ui, "DejaVu Sans", sans-serif`;
  ctx.textAlign = align;
  ctx.textBaseline = "middle";
  ctx.lineWidth = 3.5 * px();
  ctx.setLineDash([]);
  ctx.strokeStyle = colour("surface");
  ctx.strokeText(text, left, top);
  ctx.fillStyle = colour(name);
  ctx.fillText(text, left, top);
}

function ray(u, layer) {
  const { ctx, scales, bbox } = u;
  const { slope, intercept = 0 } = layer;
  const at = (x) => x * slope + intercept;
  const end = Math.min(scales.x.max, slope !== 0 ? Math.abs(((slope > 0 ? scales.y.max : scales.y.min) - intercept) / slope) : scales.x.max);
  const start = scales.x.distr === 3 || scales.y.distr === 3 ? Math.max(scales.x.min, (scales.y.min - intercept) / slope) : 0;
  stroke(u, { width: 1.4, ...layer });
  ctx.beginPath();
  const last = [u.valToPos(end, "x", true), u.valToPos(at(end), "y", true)];
  ctx.moveTo(u.valToPos(start, "x", true), u.valToPos(at(start), "y", true));
  ctx.lineTo(...last);
  ctx.stroke();
  const above = last[1] <= bbox.top + 2;
  if (!layer.label) return;
  const part = layer.along ?? 1;
  const [x, y] = [u.valToPos(start + (end - start) * part, "x", true), u.valToPos(at(start + (end - start) * part), "y", true)];
  if (part < 1) label(u, layer.label, x + 9 * px(), y + 11 * px(), layer.text ?? layer.colour);
  else label(u, layer.label, x - 10 * px(), y + (above ? 14 : -12) * px(), layer.text ?? layer.colour, "right");
}

function mark(u, layer) {
  const { ctx } = u;
  if (layer.x === null || layer.y === null) return;
  const left = u.valToPos(layer.x, "x", true);
  const top = u.valToPos(layer.y, "y", true);
  if (!Number.isFinite(left) || !Number.isFinite(top)) return;
  const r = (layer.shape === "cross" ? 4.5 : 7) * px();
  stroke(u, { width: layer.shape === "cross" ? 1.8 : 2.4, colour: layer.colour });
  ctx.beginPath();
  if (layer.shape === "cross") {
    ctx.moveTo(left - r, top - r);
    ctx.lineTo(left + r, top + r);
    ctx.moveTo(left - r, top + r);
    ctx.lineTo(left + r, top - r);
  } else if (layer.shape === "diamond") {
    ctx.moveTo(left, top - r);
    ctx.lineTo(left + r, top);
    ctx.lineTo(left, top + r);
    ctx.lineTo(left - r, top);
    ctx.closePath();
  } else ctx.arc(left, top, layer.shape === "dot" ? r * 0.7 : r, 0, 2 * Math.PI);
  if (layer.shape === "dot") {
    ctx.fillStyle = colour(layer.colour);
    ctx.fill();
  } else ctx.stroke();
  if (layer.label) label(u, layer.label, left + 11 * px(), top - 11 * px(), layer.text ?? layer.colour);
}

function straight(u, layer, along) {
  const { ctx, bbox } = u;
  const at = u.valToPos(layer[along], along, true);
  stroke(u, { width: 1.3, ...layer });
  ctx.beginPath();
  ctx.moveTo(along === "x" ? at : bbox.left, along === "x" ? bbox.top : at);
  ctx.lineTo(along === "x" ? at : bbox.left + bbox.width, along === "x" ? bbox.top + bbox.height : at);
  ctx.stroke();
}

const DRAWN = {
  line: (u, layer) => {
    stroke(u, layer);
    u.ctx.beginPath();
    trace(u, layer.x, layer.y, u.ctx, layer.dotted);
    u.ctx.stroke();
    dots(u, layer);
  },
  band, ray, mark,
  rule: (u, layer) => straight(u, layer, "x"),
  level: (u, layer) => straight(u, layer, "y"),
};

export const addKind = (kind, does) => (DRAWN[kind] = does);

export function drawLayer(u, layer) {
  u.ctx.save();
  DRAWN[layer.kind]?.(u, layer);
  u.ctx.restore();
}

/** Whether there is something to be seen of a layer that shows what was measured; others say no. */
export const hasPoints = (layer) => layer.kind === "cells" || (layer.kind === "line" && layer.x.some((x, i) => x !== null && layer.y[i] !== null));

/** The ends of a scale: what the lines need, with a margin; 0 stays an end where it nearly is one. */
export function rangeOf(layers, axis, log) {
  let low = Infinity;
  let high = -Infinity;
  const add = (v) => {
    if (v === null || !Number.isFinite(v) || (log && v <= 0)) return;
    if (v < low) low = v;
    if (v > high) high = v;
  };
  for (const layer of layers) {
    if (layer.kind === "line") layer[axis].forEach(add);
    if (layer.kind === "mark" && layer.ranged !== false) add(layer[axis]);
    for (const v of layer.range?.[axis] ?? []) add(v);
  }
  if (low > high) return log ? [1, 10] : [0, 1];
  if (log) return low === high ? [low / 2, high * 2] : [low / 1.15, high * 1.15];
  const width = high - low || Math.abs(high) * 0.1 || 1;
  return [low > -0.015 * width && low < 0.3 * width ? -0.012 * width : low - 0.05 * width, high + 0.06 * width];
}
