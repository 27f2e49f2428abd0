// SPDX-License-Identifier: GPL-3.0-or-later
// The circular diagram of one state: normalised second-order work in every stress direction; inside the circle it is negative.
import { svg } from "./dom.js";
import { fixed } from "./format.js";

const R = 130;
const ZERO = 68;
const at = (degrees, r) => {
  const a = (degrees * Math.PI) / 180;
  return `${(r * Math.cos(a)).toFixed(1)},${(-r * Math.sin(a)).toFixed(1)}`;
};

export function circularDiagram({ probes, cones, state }) {
  const known = probes.filter((p) => p.w2_normalised !== null);
  const curve = known.map((p) => at(p.alpha_deg, ZERO * (1 + p.w2_normalised * 0.85))).join(" ");
  const sectors = cones.map(({ from_deg: from, to_deg: to }) =>
    svg("path", { class: "sector", d: `M0,0 L${at(from, R)} A${R} ${R} 0 ${to - from > 180 ? 1 : 0} 0 ${at(to, R)} Z` }));
  const text = (x, y, anchor, words) => svg("text", { x, y, "text-anchor": anchor }, words);
  return svg("svg", { class: "circular", viewBox: "-200 -150 400 300", role: "img",
    "aria-label": cones.length ? `cone of unstable directions from ${cones.map((c) => `${fixed(c.from_deg)} to ${fixed(c.to_deg)} degrees`).join(", and ")}` : `no unstable direction at p′ ${fixed(state.p_eff_kPa)} and q ${fixed(state.q_kPa)} kPa` },
  sectors, svg("path", { class: "axis", d: `M${-R - 8},0H${R + 8}M0,${R + 8}V${-R - 8}` }), svg("circle", { class: "zero", r: ZERO }),
  svg("polygon", { class: "work", points: curve }), text(R + 12, 4, "start", "√2 dσ′₃"), text(8, -R + 2, "start", "dσ′₁"),
  text(ZERO * 0.72, ZERO * 0.72 + 22, "start", "W₂ = 0"));
}
