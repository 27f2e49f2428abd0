// SPDX-License-Identifier: GPL-3.0-or-later
// The readings of a running test that are drawn: at most kept so many, thinned to those that are least and largest where the
// test goes on. Beside them, what came in all: count, gaps, and a checksum over every reading.

const MOST = 4000;
const BLOCK = 12;
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
    Object.assign(this, { count: 0, gaps: 0, first: null, last: null, now: null });
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
    for (const name of this.names) this.columns[name].push(row[name] ?? null);
    if (this.length > MOST) this.thin();
    return whole;
  }

  /** The window of the server stands for all up to its last reading; what came after it stays. */
  replace(columns) {
    const last = columns.reading.at(-1) ?? -1;
    const from = this.columns.reading.findIndex((r) => r > last);
    for (const name of this.names)
      this.columns[name] = [...(columns[name] ?? columns.reading.map(() => null)), ...(from < 0 ? [] : this.columns[name].slice(from))];
    if (this.last === null || this.last < last) this.last = last >= 0 ? last : null;
    while (this.length > MOST) this.thin();
  }

  thin() {
    const { length } = this;
    const keep = [];
    for (let from = 0; from < length; from += BLOCK) {
      const to = Math.min(from + BLOCK, length);
      const chosen = new Set([from]);
      for (const name of EXTREMES) {
        const values = this.columns[name];
        let [low, high] = [from, from];
        for (let i = from; i < to; ++i) {
          if (values[i] < values[low]) low = i;
          if (values[i] > values[high]) high = i;
        }
        chosen.add(low).add(high);
      }
      keep.push(...[...chosen].sort((a, b) => a - b).slice(0, BLOCK / 2 + 1));
    }
    for (const name of this.names) {
      const values = this.columns[name];
      this.columns[name] = keep.map((i) => values[i]);
    }
  }
}
