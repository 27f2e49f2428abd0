// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers and moments as they are read. What is not known is a dash, never 0.

export const DASH = "–";
const known = (value) => typeof value === "number" && Number.isFinite(value);

export const fixed = (value, digits = 1) => (known(value) ? value.toFixed(digits).replace("-", "−") : DASH);

/** So many significant digits, without an exponent where that can be read. */
export function digits(value, count = 3) {
  if (!known(value)) return DASH;
  const size = Math.abs(value);
  if (size !== 0 && (size < 1e-4 || size >= 1e7)) return value.toExponential(count - 1).replaceAll("-", "−");
  return String(Number(value.toPrecision(count))).replace("-", "−");
}

export function time(seconds) {
  if (!known(seconds)) return DASH;
  const size = Math.abs(seconds);
  if (size < 120) return `${digits(seconds, 3)} s`;
  if (size < 7200) return `${fixed(seconds / 60)} min`;
  if (size < 172800) return `${fixed(seconds / 3600, 2)} h`;
  return `${fixed(seconds / 86400, 2)} d`;
}

export const percent = (value, places = 2) => (known(value) ? `${fixed(100 * value, places)} %` : DASH);
export const words = (name) => (name ?? DASH).replaceAll("_", " ");
export const date = (iso) => (iso ? iso.slice(0, 16).replace("T", " ") : DASH);

/** An interval in the way of the reports: 0.60 (0.59 to 0.60). */
export const within = (value, low, high, places = 2) =>
  known(low) && known(high) ? `${fixed(value, places)} (${fixed(low, places)} to ${fixed(high, places)})` : fixed(value, places);

const LEFT = { axial_strain: [100, "%", "axial strain", 3], mean_effective_stress_kPa: [1, "kPa", "p′", 1], q_kPa: [1, "kPa", "q", 1],
  volumetric_strain: [100, "%", "volumetric strain", 3] };

/** What is left until a forecast onset: number, unit, of what. */
export function left(amount) {
  if (!amount) return null;
  const [factor, unit, of, places] = LEFT[amount.quantity] ?? [1, "", words(amount.quantity), 3];
  return { value: fixed(amount.value * factor, places), unit, of };
}

/** What was assumed of a record, with its evidence and the option that changes it. */
export const assumption = (g) => `${g.what}: assumed to be ${g.taken}${g.evidence ? ` (${g.evidence})` : ""}. ${g.remedy ?? ""}`;
