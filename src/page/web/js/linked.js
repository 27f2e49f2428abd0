// SPDX-License-Identifier: GPL-3.0-or-later
// Charts that share one window of readings and one cursor. Zooming and panning choose readings, so that each chart shows the
// same part of the test, whatever stands on its axes.

export class Linked {
  /** load(range) gives columns (with `reading`) for [from, to] of readings; changed(columns, range) draws; cursor(i) is told. */
  constructor({ all, load, changed, cursor }) {
    Object.assign(this, { all, load, changed, told: cursor, range: { ...all }, columns: { reading: [] }, at: null, panels: [], asked: null });
  }

  /** A chart with what stands on its axes: x(columns) and y(columns) give arrays. */
  add(chart, x, y) {
    this.panels.push({ chart, x, y });
  }

  async show(range) {
    const width = Math.max(4, Math.min(range.to - range.from, this.all.to - this.all.from));
    const from = Math.max(this.all.from, Math.min(Math.round(range.from), this.all.to - width));
    this.range = { from, to: Math.min(this.all.to, Math.round(from + width)) };
    this.asked?.abort();
    this.asked = new AbortController();
    const asked = this.asked;
    try {
      const columns = await this.load(this.range, asked.signal);
      if (asked !== this.asked) return;
      this.columns = columns;
      this.changed(columns, this.range);
      this.points = null;
      requestAnimationFrame(() => this.place());
    } catch (failure) {
      if (failure.name !== "AbortError") throw failure;
    }
  }

  pointsOf(panel) {
    this.points ??= new Map();
    if (!this.points.has(panel)) this.points.set(panel, [panel.x(this.columns), panel.y(this.columns)]);
    return this.points.get(panel);
  }

  /** The reading nearest to a point of this chart on the screen; along x alone where it is a history. */
  near(chart, x, y, scale) {
    const panel = this.panels.find((p) => p.chart === chart);
    const [xs, ys] = this.pointsOf(panel);
    let best = null;
    let least = Infinity;
    for (let i = 0; i < xs.length; ++i) {
      if (xs[i] === null || ys[i] === null) continue;
      const dx = (xs[i] - x) / scale.x;
      const dy = (ys[i] - y) / scale.y;
      const distance = dx * dx + (chart.does.box ? dy * dy : 0.0004 * dy * dy);
      if (distance < least) [least, best] = [distance, i];
    }
    this.point(best);
  }

  point(index) {
    this.at = index;
    this.place();
    this.told(index);
  }

  pointAtReading(reading) {
    const { reading: readings } = this.columns;
    let best = null;
    readings.forEach((r, i) => {
      if (best === null || Math.abs(r - reading) < Math.abs(readings[best] - reading)) best = i;
    });
    this.point(best);
  }

  place() {
    for (const panel of this.panels) {
      const [xs, ys] = this.at === null ? [[], []] : this.pointsOf(panel);
      panel.chart.mark(xs[this.at], ys[this.at]);
    }
  }

  /** The readings from the first to the last whose point lies in the box. */
  pick(chart, box) {
    const [xs, ys] = this.pointsOf(this.panels.find((p) => p.chart === chart));
    const inside = this.columns.reading.filter((_, i) => xs[i] !== null && xs[i] >= box.x[0] && xs[i] <= box.x[1] && (!box.y || (ys[i] >= box.y[0] && ys[i] <= box.y[1])));
    if (inside.length > 1) this.show({ from: inside[0], to: inside[inside.length - 1] });
  }

  zoom(factor) {
    const { from, to } = this.range;
    const middle = this.at === null ? (from + to) / 2 : this.columns.reading[this.at];
    return this.show({ from: middle - (middle - from) * factor, to: middle + (to - middle) * factor });
  }

  pan(part) {
    const step = (this.range.to - this.range.from) * part;
    return this.show({ from: this.range.from + step, to: this.range.to + step });
  }

  whole() {
    return this.show(this.all);
  }

  /** Keys on any of the charts. */
  key(event) {
    const count = this.columns.reading.length;
    const step = (by) => this.point(Math.max(0, Math.min(count - 1, this.at === null ? (by > 0 ? 0 : count - 1) : this.at + by)));
    const far = Math.max(1, Math.round(count / 50));
    const does = {
      "+": () => this.zoom(0.5), "=": () => this.zoom(0.5), "-": () => this.zoom(2), 0: () => this.whole(),
      ArrowLeft: () => (event.shiftKey ? this.pan(-0.25) : step(-far)), ArrowRight: () => (event.shiftKey ? this.pan(0.25) : step(far)),
      ",": () => step(-1), ".": () => step(1), Home: () => step(-count), End: () => step(count), Escape: () => this.point(null),
    }[event.key];
    if (!does || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    does();
  }
}

export const KEYS = [["←", "→"], "cursor", [",", "."], "one reading", ["+", "−"], "zoom", ["Shift ←", "Shift →"], "pan", ["0"], "all"];
