// SPDX-License-Identifier: GPL-3.0-or-later
// The readings of a running test that are drawn: at most kept so many, thinned to those that are least and largest in their
// span. Beside them, what came in all: count, gaps, and a checksum over every reading.

import { dottedPlaces, isFaulty, withoutFaults } from "./breaks.js";

const MOST = 4000;
const SPANS = 400;
const EXTREMES = ["q_kPa", "p_eff_kPa", "pore_pressure_kPa"];

/** FNV-1a over the bytes of reading, time and q as float64, little end first; null is NaN. */
export class Checksum {
  constructor() {
    this.value = 0x811c9dc5;
    this.bytes = new DataView(new ArrayBuffer(24));
  }

  add(row) {
    [row.reading, row.time_s, row.q_kPa].forEach((v, i) => this.bytes.setFloat64(8 * i, v ?? NaN, true));
    let hash = this.value;
    for (let i = 0; i < 24; ++i) hash = Math.imul(hash ^ this.bytes.getUint8(i), 0x01000193) >>> 0;
    this.value = hash;
  }

  hex() {
    return this.value.toString(16).padStart(8, "0");
  }
}

export class LiveRows {
  constructor(columns) {
    this.names = [...new Set(["reading", "time_s", ...columns])];
    this.columns = Object.fromEntries(this.names.map((name) => [name, []]));
    this.sum = new Checksum();
    Object.assign(this, { count: 0, gaps: 0, first: null, last: null, now: null, unread: new Set(), faults: [] });
  }

  get length() {
    return this.columns.reading.length;
  }

  /** False where a reading is missing before this one. A reading that is known already is left out. */
  add(row) {
    if (this.last !== null && row.reading <= this.last) return true;
    const whole = this.last === null || row.reading === this.last + 1;
    if (!whole) this.gaps += 1;
    this.first ??= row.reading;
    this.last = row.reading;
    this.now = row;
    this.count += 1;
    this.sum.add(row);
    if (row.unread) this.unread.add(row.reading);
    for (const name of this.names) this.columns[name].push(row[name] ?? null);
    if (this.length > MOST) this.thin();
    return whole;
  }

  /** What a window of the server says about breaks in the curves of the whole test. */
  learn({ faults, unread_steps: unread }) {
    this.faults = faults;
    unread.forEach((reading) => this.unread.add(reading));
  }

  /** What is drawn: without values of faulty sensors. */
  get shown() {
    return this.faults.length ? withoutFaults(this.columns, this.faults) : this.columns;
  }

  /** The last reading, without values of faulty sensors. */
  get shownNow() {
    const lost = this.faults.filter((fault) => this.now && isFaulty(this.now.reading, fault)).flatMap((fault) => fault.columns);
    return lost.length ? { ...this.now, ...Object.fromEntries(lost.map((name) => [name, null])) } : this.now;
  }

  get dotted() {
    return dottedPlaces(this.columns.reading, [...this.unread].sort((a, b) => a - b));
  }

  /** The window of the server stands for all between `first` and its last reading; what came before and after stays. */
  replace(columns, first = 0) {
    const last = columns.reading.at(-1) ?? -1;
    const readings = this.columns.reading;
    const kept = (which) => readings.flatMap((r, i) => (which(r) ? [i] : []));
    const [before, after] = [kept((r) => r < first), kept((r) => r >= first && r > last)];
    for (const name of this.names) {
      const values = this.columns[name];
      this.columns[name] = [...before.map((i) => values[i]), ...(columns[name] ?? columns.reading.map(() => null)), ...after.map((i) => values[i])];
    }
    if (this.last === null || this.last < last) this.last = last >= 0 ? last : null;
    if (this.length > MOST) this.thin();
  }

  /** Of each of equal spans of readings the first, and those with the least and largest values: a test of any length keeps its
   *  shape, in its old parts as in its new ones. */
  thin() {
    const readings = this.columns.reading;
    const [from, width] = [readings[0], (readings.at(-1) - readings[0] + 1) / SPANS];
    const kept = [];
    for (let begin = 0; begin < readings.length;) {
      const span = Math.floor((readings[begin] - from) / width);
      let end = begin + 1;
      while (end < readings.length && Math.floor((readings[end] - from) / width) === span) ++end;
      kept.push(...this.extremes(begin, end));
      begin = end;
    }
    for (const name of this.names) {
      const values = this.columns[name];
      this.columns[name] = kept.map((i) => values[i]);
    }
  }

  extremes(begin, end) {
    const chosen = new Set([begin]);
    for (let i = begin; i < end; ++i) if (this.unread.has(this.columns.reading[i])) chosen.add(Math.max(begin, i - 1)).add(i);
    for (const name of EXTREMES) {
      const values = this.columns[name];
      let [low, high] = [begin, begin];
      for (let i = begin; i < end; ++i) {
        if (values[i] < values[low]) low = i;
        if (values[i] > values[high]) high = i;
      }
      chosen.add(low).add(high);
    }
    return [...chosen].sort((a, b) => a - b);
  }
}
