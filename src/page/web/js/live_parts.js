// SPDX-License-Identifier: GPL-3.0-or-later
// Parts of the page of a running test: the signal, the stages, the channels, the events.
import { el, fill } from "./dom.js";
import { digits, left, time, words } from "./format.js";
import { SHAPES } from "./kinds.js";

const GONE = ["lost", "loss_of_sustainability", "loss_of_control", "run_away", "collapse"];

/** What the last events and the forecast come to: {word, tone, sub}. */
export function signalOf({ state, level, forecast, lost, end }) {
  const amount = left(forecast?.left);
  const rest = amount ? `${amount[0]} ${amount[1]}${forecast.left.time_s === null ? "" : `, ${time(forecast.left.time_s)}`} left at the present rate` : null;
  if (lost) return { word: "unstable", tone: "alarm", sub: lost.detail };
  if (end) return { word: "ended", tone: "off", sub: end.why ?? words(end.status ?? "") };
  if (state === "held") return { word: "held", tone: "off", sub: "the drives stand still" };
  if (level === "imminent") return { word: "imminent", tone: "alarm", sub: rest ?? "the onset is near" };
  if (level === "approaching") return { word: "approaching", tone: "care", sub: rest ?? "the onset comes nearer" };
  return { word: "no alarm", tone: "good", sub: rest ? `onset forecast: ${rest}` : "no onset is forecast" };
}

export const isLoss = (event) => GONE.includes(event.kind);

export function showSignal(node, signal) {
  node.className = `signal ${signal.tone}`;
  node.dataset.word = signal.word;
  fill(node, el("div", { class: "word" }, el("span", { "aria-hidden": "true" }, `${SHAPES[signal.tone]} `), signal.word), el("div", { class: "sub" }, signal.sub));
}

export function showStages(node, { stage, of, name, progress }) {
  fill(node, el("div", {}, el("strong", {}, `Stage ${stage}${of ? ` of ${of}` : ""}: `), name ?? ""),
    of ? el("ol", { class: "stages", "aria-hidden": "true" }, Array.from({ length: of }, (_, i) => {
      const fillIn = el("span");
      fillIn.style.width = `${Math.round(100 * (progress ?? 0.5))}%`;
      return el("li", { class: i + 1 < stage ? "done" : i + 1 === stage ? "now" : null }, i + 1 === stage ? fillIn : null);
    })) : null);
}

const HEALTH = { good: ["good", "good"], suspect: ["care", "suspect"], missing: ["alarm", "missing"] };

export function showChannels(node, channels) {
  fill(node, el("table", {}, el("thead", {}, el("tr", {}, ["Channel", "Value", "Health"].map((t, i) => el("th", { scope: "col", class: i === 1 ? "number" : null }, t)))),
    el("tbody", {}, channels.map(({ name, value, unit, health, cause }) => {
      const [tone, word] = HEALTH[health] ?? ["care", words(health)];
      return el("tr", {}, el("th", { scope: "row" }, words(name)), el("td", { class: "number" }, `${digits(value, 5)} ${unit ?? ""}`),
        el("td", {}, el("span", { class: `health ${tone}` }, `${SHAPES[tone]} ${word}`), cause ? el("div", { class: "quiet" }, cause) : null));
    }))));
}

const MOST_EVENTS = 200;

export function addEvent(list, event) {
  list.prepend(el("li", { data: { kind: event.kind } }, el("span", { class: `tag ${isLoss(event) || event.kind === "imminent" ? "alarm" : event.kind === "approaching" ? "care" : ""}` }, words(event.kind)), " ",
    el("span", { class: "quiet" }, `${time(event.time_s)}, reading ${event.reading}`), el("div", {}, event.detail)));
  while (list.children.length > MOST_EVENTS) list.lastChild.remove();
}
