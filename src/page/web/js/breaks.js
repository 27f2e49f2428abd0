// SPDX-License-Identifier: GPL-3.0-or-later
// Where a curve is no solid line: a step in which nothing was read is dotted, a faulty sensor leaves a gap.

/** The places of these readings whose line from the place before crosses a step in which nothing was read. Both rise. */
export function dottedPlaces(readings, unreadSteps) {
  const places = new Set();
  let next = 0;
  for (let i = 1; i < readings.length; ++i) {
    while (next < unreadSteps.length && unreadSteps[next] <= readings[i - 1]) ++next;
    if (next < unreadSteps.length && unreadSteps[next] <= readings[i]) places.add(i);
  }
  return places;
}

export const isFaulty = (reading, { from, to }) => from <= reading && (to === null || reading <= to);

/** The first places after readings of a fault. */
export const placesAfter = (readings, faults) => readings.flatMap((reading, i) =>
  i > 0 && faults.some((fault) => isFaulty(readings[i - 1], fault) && !isFaulty(reading, fault)) ? [i] : []);

/** The columns without values of faulty sensors. */
export function withoutFaults(columns, faults) {
  const clean = { ...columns };
  for (const fault of faults)
    for (const name of fault.columns)
      if (clean[name]) clean[name] = clean[name].map((v, i) => (isFaulty(columns.reading[i], fault) ? null : v));
  return clean;
}

/** Values at these readings, with null where a line to them would cross the readings of a fault that stresses or strains rest on. */
export function openAcross(readings, values, faults) {
  const long = faults.filter((f) => f.columns.some((name) => ["q_kPa", "p_eff_kPa", "axial_strain"].includes(name)) && (f.to === null || f.to - f.from >= 5));
  return values.map((v, i) => (i > 0 && long.some((f) => readings[i - 1] < f.from && f.to !== null && f.to < readings[i]) ? null : v));
}
