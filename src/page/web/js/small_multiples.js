// SPDX-License-Identifier: GPL-3.0-or-later
// Small stress paths of shear, each to scales of its own, asked for when they come into sight.
import { get, windowPath } from "./api.js";
import { dottedPlaces, isFaulty } from "./breaks.js";
import { el, svg } from "./dom.js";
import { fixed } from "./format.js";
import { SHAPES, verdict } from "./kinds.js";

const WIDE = 176;
const HIGH = 118;
const EDGE = { left: 30, bottom: 16, top: 8, right: 8 };

/** An end of a scale that is easily read: 1, 2, 2.5 or 5 times a power of ten. */
export function roundUp(value) {
  const power = 10 ** Math.floor(Math.log10(value || 1));
  return ([1, 2, 2.5, 5, 10].find((step) => step * power >= value * 0.999) ?? 10) * power;
}

/** The known points: parts that were read one after the other, and dotted lines where nothing was read between. */
function linesOf({ columns: { reading, p_eff_kPa: p, q_kPa: q }, faults, unread_steps: unread }, place) {
  const dotted = dottedPlaces(reading, unread);
  const [solid, dots] = [[], []];
  let [gap, unreadStep] = [true, false];
  reading.forEach((number, i) => {
    unreadStep ||= dotted.has(i);
    if (p[i] === null || q[i] === null) {
      gap ||= faults.some((fault) => isFaulty(number, fault));
      return;
    }
    const here = place(p[i], q[i]);
    if (!gap && unreadStep) dots.push([solid.at(-1).at(-1), here]);
    if (gap || unreadStep) solid.push([]);
    solid.at(-1).push(here);
    [gap, unreadStep] = [false, false];
  });
  return { solid, dots };
}

function picture(window, collapse) {
  const { p_eff_kPa: p, q_kPa: q } = window.columns;
  const known = p.map((v, i) => [v, q[i]]).filter(([a, b]) => a !== null && b !== null);
  const top = roundUp(Math.max(1, ...known.map(([, b]) => b)));
  const low = Math.min(0, ...known.map(([, b]) => b));
  const end = roundUp(Math.max(1, ...known.map(([a]) => a)));
  const x = (v) => EDGE.left + ((WIDE - EDGE.left - EDGE.right) * v) / end;
  const y = (v) => HIGH - EDGE.bottom - ((HIGH - EDGE.bottom - EDGE.top) * (v - low)) / (top - low);
  const { solid, dots } = linesOf(window, (a, b) => `${x(a).toFixed(1)},${y(b).toFixed(1)}`);
  const reach = collapse.eta ? Math.min(end, top / collapse.eta) : 0;
  return svg("svg", { viewBox: `0 0 ${WIDE} ${HIGH}`, role: "img", "aria-label": `stress path to p′ ${fixed(Math.max(0, ...known.map(([a]) => a)), 0)} kPa and q ${fixed(Math.max(0, ...known.map(([, b]) => b)), 0)} kPa` },
    svg("path", { class: "axis", d: `M${x(0)} ${y(top)}V${y(low)}M${x(0)} ${y(0)}H${x(end)}` }),
    reach ? svg("line", { class: "line", x1: x(0), y1: y(0), x2: x(reach), y2: y(reach * collapse.eta) }) : null,
    solid.map((part) => svg("polyline", { class: "path", points: part.join(" ") })),
    dots.map((part) => svg("polyline", { class: "path", points: part.join(" "), "stroke-dasharray": "2 3" })),
    collapse.detected && collapse.p_eff_kPa !== null ? svg("circle", { class: "onset", cx: x(collapse.p_eff_kPa), cy: y(collapse.q_kPa), r: 3.5 }) : null,
    svg("text", { x: EDGE.left - 4, y: y(top) + 7, "text-anchor": "end" }, top), svg("text", { x: EDGE.left - 4, y: y(top) + 18, "text-anchor": "end" }, "kPa"),
    svg("text", { x: x(end), y: HIGH - 4, "text-anchor": "end" }, `p′ ${end} kPa`), svg("text", { x: EDGE.left + 4, y: y(top) + 7 }, "q"));
}

function card(t) {
  const { word, tone } = verdict(t.collapse);
  const room = el("div", {}, svg("svg", { viewBox: `0 0 ${WIDE} ${HIGH}` }));
  return { t, room, node: el("a", { class: "card", href: `#/test/${t.test.id}` }, el("span", { class: "title" }, t.test.name), room,
    el("span", { class: `tag ${tone}` }, el("span", { "aria-hidden": "true" }, `${SHAPES[tone]} `), word)) };
}

export function paths(tests) {
  const cards = new Map();
  const stop = new AbortController();
  const seen = new IntersectionObserver((entries) => {
    for (const { isIntersecting, target } of entries) {
      if (!isIntersecting) continue;
      seen.unobserve(target);
      const { t, room } = cards.get(target);
      get(windowPath(t.test.id, ["q_kPa", "p_eff_kPa"], { from: t.collapse.judged?.from_reading ?? 0, pixels: 120 }), stop.signal)
        .then((window) => room.replaceChildren(picture(window, t.collapse)))
        .catch((failure) => failure.name === "AbortError" || (room.textContent = failure.message));
    }
  }, { rootMargin: "200px" });
  const node = el("div", { class: "cards" }, tests.map((t) => {
    const made = card(t);
    cards.set(made.node, made);
    seen.observe(made.node);
    return made.node;
  }));
  return { node, end: () => {
    stop.abort();
    seen.disconnect();
  } };
}
