// SPDX-License-Identifier: GPL-3.0-or-later
// A chart: uPlot's axes, scales and cursor, with layers of our own drawn in them, since a stress path turns back on itself and
// uPlot's series may not. Layers: see layers.js.
import uPlot from "./uPlot.esm.js";
import { el } from "./dom.js";
import { drawLayer, hasPoints, rangeOf } from "./layers.js";
import { colour, onTheme } from "./theme.js";

const FONT = "12px system-ui, 'DejaVu Sans', sans-serif";

export class Chart {
  /** x, y: {title, log}; does: {move(x, y), pick(box), leave()}. `title` is what a screen reader calls it. */
  constructor({ title, x, y, height = 240, does = {}, cursor = true, nothing = "not measured" }) {
    Object.assign(this, { x, y, does, height, layers: [], limits: { x: null, y: null } });
    this.plot = el("div", { class: "plot" });
    this.node = el("div", { class: "chart", role: "group", "aria-label": title, tabindex: 0 }, this.plot);
    this.node.chart = this; // for tests of what is drawn
    this.dot = el("div", { class: "dot" });
    this.nothing = el("p", { class: "nothing quiet", hidden: true }, nothing);
    this.node.append(this.nothing);
    this.withCursor = cursor;
    this.pending = 0;
    this.sized = new ResizeObserver(() => this.resize());
    this.sized.observe(this.plot);
    this.unTheme = onTheme(() => this.u?.redraw(false, false));
  }

  options(width) {
    const axis = (scale, which, size) => ({ scale, label: which.title, labelSize: 20, labelFont: FONT, font: FONT, size, labelGap: scale === "y" ? 2 : 0,
      stroke: () => colour("muted"), grid: { stroke: () => colour("grid"), width: 1 }, ticks: { stroke: () => colour("line"), width: 1, size: 5 },
      space: scale === "x" ? 55 : 32,
      values: (u, ticks) => ticks.map((v) => (v === null ? "" : String(Number(v.toPrecision(which.log ? 2 : 8))).replace("-", "−"))) });
    const scale = (which) => ({ time: false, auto: false, distr: which.log ? 3 : 1 });
    return { width, height: this.height, padding: [10, 14, 0, 0], legend: { show: false },
      scales: { x: scale(this.x), y: scale(this.y) },
      series: [{}, { scale: "y", paths: () => null, points: { show: false } }],
      axes: [axis("x", this.x, 34), axis("y", this.y, 52)],
      cursor: { show: this.withCursor, points: { show: false }, drag: { x: true, y: this.does.box === true, setScale: false, uni: 20 } },
      hooks: { draw: [(u) => this.draw(u)], setCursor: [(u) => this.moved(u)], setSelect: [(u) => this.picked(u)] } };
  }

  resize() {
    const width = Math.floor(this.plot.clientWidth);
    if (width < 60) return;
    if (!this.u) {
      this.u = new uPlot(this.options(width), [[0, 1], [null, null]], this.plot);
      this.u.over.append(this.dot);
      this.u.over.addEventListener("dblclick", () => this.does.all?.());
      this.show();
    } else if (width !== this.u.width) this.u.setSize({ width, height: this.height });
  }

  /** Draws these layers at the next frame; `limits` fixes the ends of a scale that is not to follow the layers. */
  set(layers, limits = {}) {
    this.layers = layers;
    this.fixed = limits;
    if (!this.pending) this.pending = requestAnimationFrame(() => this.show());
  }

  show() {
    this.pending = 0;
    if (!this.u) return;
    const x = this.fixed?.x ?? rangeOf(this.layers, "x", this.x.log);
    const y = this.fixed?.y ?? rangeOf(this.layers, "y", this.y.log);
    this.u.batch(() => {
      this.u.setScale("x", { min: x[0], max: x[1] });
      this.u.setScale("y", { min: y[0], max: y[1] });
    });
    this.u.redraw(false, false);
    this.nothing.hidden = this.layers.length === 0 || this.layers.some(hasPoints);
    this.node.dataset.draws = String(Number(this.node.dataset.draws ?? 0) + 1);
  }

  draw(u) {
    const { ctx, bbox } = u;
    ctx.save();
    ctx.beginPath();
    ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
    ctx.clip();
    for (const layer of this.layers) drawLayer(u, layer);
    ctx.restore();
  }

  moved(u) {
    const { left, top, event } = u.cursor;
    // uPlot tells of its cursor again when scales change: only a mouse that moved moves ours.
    if (left === undefined || left < 0 || !event || event === this.event) return;
    this.event = event;
    this.does.move?.(u.posToVal(left, "x"), u.posToVal(top, "y"), this.scaleOf(u));
  }

  /** Data units per pixel, so that nearness on the screen can be asked for. */
  scaleOf(u) {
    return { x: (u.scales.x.max - u.scales.x.min) / u.over.clientWidth, y: (u.scales.y.max - u.scales.y.min) / u.over.clientHeight };
  }

  picked(u) {
    const { left, top, width, height } = u.select;
    if (width < 4 && height < 4) return;
    const box = { x: [u.posToVal(left, "x"), u.posToVal(left + width, "x")], y: height > 4 && this.does.box ? [u.posToVal(top + height, "y"), u.posToVal(top, "y")] : null };
    u.setSelect({ left: 0, top: 0, width: 0, height: 0 }, false);
    this.does.pick?.(box);
  }

  /** The common cursor, here at this point, or nowhere. */
  mark(x, y) {
    const here = this.u && Number.isFinite(x) && Number.isFinite(y) && x !== null && y !== null;
    const left = here ? this.u.valToPos(x, "x") : -1;
    const top = here ? this.u.valToPos(y, "y") : -1;
    const inside = here && left >= 0 && top >= 0 && left <= this.u.over.clientWidth && top <= this.u.over.clientHeight;
    this.dot.style.display = inside ? "block" : "none";
    if (inside) this.dot.style.transform = `translate(${left}px, ${top}px)`;
  }

  end() {
    cancelAnimationFrame(this.pending);
    this.sized.disconnect();
    this.unTheme();
    this.u?.destroy();
    this.u = null;
    this.layers = [];
  }
}
