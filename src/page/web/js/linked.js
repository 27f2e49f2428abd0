// SPDX-License-Identifier: GPL-3.0-or-later
// Charts that share one window of readings and one cursor, which stands at a reading. Zooming and panning choose readings, so
// that each chart shows the same part of the test, whatever stands on its axes.

/** The place of the reading nearest to this one; readings rise. */
export function placeOf(readings, reading) {
  let [low, high] = [0, readings.length - 1];
  if (high < 0) return null;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (readings[middle] < reading) low = middle + 1;
    else high = middle;
  }
  return low > 0 && reading - readings[low - 1] < readings[low] - reading ? low - 1 : low;
}

export class Linked {
  /** load(range, signal) gives what is shown of [from, to]; changed(data, range) draws; told(reading or null) of the cursor. */
  constructor({ all, load, changed, told }) {
    Object.assign(this, { all, load, changed, told, range: { ...all }, data: null, at: null, panels: [], asked: null });
  }

  /** A chart, and curve(data), which gives its {reading, x, y}. */
  add(chart, curve) {
    this.panels.push({ chart, curve, points: null });
  }

  async show(range) {
    const width = Math.max(4, Math.min(range.to - range.from, this.all.to - this.all.from));
    const from = Math.max(this.all.from, Math.min(Math.round(range.from), this.all.to - width));
    this.range = { from, to: Math.min(this.all.to, Math.round(from + width)) };
    this.asked?.abort();
    const asked = (this.asked = new AbortController());
    try {
      const data = await this.load(this.range, asked.signal);
      if (asked !== this.asked) return;
      this.data = data;
      for (const panel of this.panels) panel.points = panel.curve(data);
      this.changed(data, this.range);
      requestAnimationFrame(() => this.point(this.at));
    } catch (failure) {
      if (failure.name !== "AbortError") throw failure;
    }
  }

  pointsOf(chart) {
    return this.panels.find((panel) => panel.chart === chart).points;
  }

  /** The cursor goes to the point of this chart nearest on the screen; along x nearly alone where it is a history. */
  near(chart, x, y, scale) {
    const points = this.pointsOf(chart);
    if (!points) return;
    let best = null;
    let least = Infinity;
    for (let i = 0; i < points.x.length; ++i) {
      if (points.x[i] === null || points.y[i] === null) continue;
      const dx = (points.x[i] - x) / scale.x;
      const dy = (points.y[i] - y) / scale.y;
      const distance = dx * dx + (chart.does.box ? dy * dy : 0.0004 * dy * dy);
      if (distance < least) [least, best] = [distance, i];
    }
    this.point(best === null ? null : points.reading[best]);
  }

  point(reading) {
    this.at = reading;
    for (const { chart, points } of this.panels) {
      const i = reading === null || !points ? null : placeOf(points.reading, reading);
      if (i === null) chart.mark(null, null);
      else chart.mark(points.x[i], points.y[i]);
    }
    this.told(reading);
  }

  /** Zooms to the readings from the first to the last whose point lies in the box. */
  pick(chart, box) {
    const points = this.pointsOf(chart);
    const inside = points.reading.filter((_, i) => points.x[i] !== null && points.x[i] >= box.x[0] && points.x[i] <= box.x[1] && (!box.y || (points.y[i] >= box.y[0] && points.y[i] <= box.y[1])));
    if (inside.length > 1) this.show({ from: inside[0], to: inside[inside.length - 1] });
  }

  zoom(factor) {
    const { from, to } = this.range;
    const middle = this.at === null ? (from + to) / 2 : Math.min(to, Math.max(from, this.at));
    return this.show({ from: middle - (middle - from) * factor, to: middle + (to - middle) * factor });
  }

  pan(part) {
    const step = (this.range.to - this.range.from) * part;
    return this.show({ from: this.range.from + step, to: this.range.to + step });
  }

  whole() {
    return this.show(this.all);
  }

  step(by) {
    const readings = this.data?.columns.reading ?? [];
    const last = readings.length - 1;
    const now = this.at === null ? (by > 0 ? -by : last - by) : placeOf(readings, this.at);
    if (last >= 0) this.point(readings[Math.max(0, Math.min(last, now + by))]);
  }

  /** Keys on any of the charts. */
  key(event) {
    const count = this.data?.columns.reading.length ?? 0;
    const far = Math.max(1, Math.round(count / 50));
    const does = {
      "+": () => this.zoom(0.5), "=": () => this.zoom(0.5), "-": () => this.zoom(2), 0: () => this.whole(),
      ArrowLeft: () => (event.shiftKey ? this.pan(-0.25) : this.step(-far)), ArrowRight: () => (event.shiftKey ? this.pan(0.25) : this.step(far)),
      ",": () => this.step(-1), ".": () => this.step(1), Home: () => this.step(-count), End: () => this.step(count), Escape: () => this.point(null),
    }[event.key];
    if (!does || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    does();
  }
}

export const KEYS = [[["←", "→"], "cursor"], [[",", "."], "one reading"], [["+", "−"], "zoom"], [["Shift ←", "Shift →"], "pan"], [["0"], "all"]];
