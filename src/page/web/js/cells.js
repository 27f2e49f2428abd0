// SPDX-License-Identifier: GPL-3.0-or-later
// Layers of the page of stability: a field of states, and cones of unstable stress directions at points of it.
//   {kind: "cells", states, dp, dq}       states as in `triax domain --json`
//   {kind: "wedges", wedges: [{p, q, cones: [{from_deg, to_deg}]}]}
import { addKind } from "./layers.js";
import { colour } from "./theme.js";

const px = () => window.devicePixelRatio || 1;

function hatch(ctx, name) {
  const size = 7 * px();
  const tile = new OffscreenCanvas(size, size);
  const pen = tile.getContext("2d");
  pen.strokeStyle = colour(name);
  pen.globalAlpha = 0.55;
  pen.lineWidth = px();
  pen.beginPath();
  for (const shift of [-size, 0, size]) {
    pen.moveTo(shift, size);
    pen.lineTo(shift + size, 0);
  }
  pen.stroke();
  return ctx.createPattern(tile, "repeat");
}

/** The more negative the least normalised second-order work, the deeper the colour; what lies beyond the limit is hatched. */
addKind("cells", (u, { states, dp, dq }) => {
  const { ctx } = u;
  const beyond = hatch(ctx, "grey");
  for (const s of states) {
    if (s.kind === "stable") continue;
    const left = Math.round(u.valToPos(s.p_eff_kPa - dp / 2, "x", true));
    const right = Math.round(u.valToPos(s.p_eff_kPa + dp / 2, "x", true));
    const top = Math.round(u.valToPos(s.q_kPa + dq / 2, "y", true));
    const bottom = Math.round(u.valToPos(s.q_kPa - dq / 2, "y", true));
    ctx.globalAlpha = s.kind === "unstable" ? 0.12 + 0.5 * Math.min(1, Math.abs(s.w2_normalised_least ?? 0)) : 1;
    ctx.fillStyle = s.kind === "unstable" ? colour("vermilion") : beyond;
    ctx.fillRect(left, top, right - left, bottom - top);
  }
  ctx.globalAlpha = 1;
});

/** The direction on the p′-q plane of the stress increment at this angle of the Rendulic plane (√2 dσ′₃ right, dσ′₁ up). */
export function directionOf(degrees) {
  const axial = Math.sin((degrees * Math.PI) / 180);
  const radial = Math.cos((degrees * Math.PI) / 180) / Math.SQRT2;
  return { dp: (axial + 2 * radial) / 3, dq: axial - radial };
}

addKind("wedges", (u, { wedges, long = 34 }) => {
  const { ctx } = u;
  const wide = Math.abs(u.valToPos(1, "x", true) - u.valToPos(0, "x", true));
  const high = Math.abs(u.valToPos(1, "y", true) - u.valToPos(0, "y", true));
  for (const { p, q, cones } of wedges) {
    const x = u.valToPos(p, "x", true);
    const y = u.valToPos(q, "y", true);
    for (const { from_deg: from, to_deg: to } of cones) {
      ctx.beginPath();
      ctx.moveTo(x, y);
      for (let k = 0; k <= 16; ++k) {
        const { dp, dq } = directionOf(from + ((to - from) * k) / 16);
        const [dx, dy] = [dp * wide, -dq * high];
        const scale = (long * px()) / Math.hypot(dx, dy);
        ctx.lineTo(x + dx * scale, y + dy * scale);
      }
      ctx.closePath();
      ctx.fillStyle = colour("purple");
      ctx.globalAlpha = 0.45;
      ctx.fill();
      ctx.globalAlpha = 1;
      ctx.strokeStyle = colour("purple");
      ctx.lineWidth = 1.3 * px();
      ctx.stroke();
    }
    ctx.beginPath();
    ctx.arc(x, y, 3 * px(), 0, 2 * Math.PI);
    ctx.fillStyle = colour(cones.length ? "purple" : "blue");
    ctx.fill();
  }
});
