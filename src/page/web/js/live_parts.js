// SPDX-License-Identifier: GPL-3.0-or-later
// Parts of the page of a running test: the signal, the stages, the channels, the events.
import { el, fill } from "./dom.js";
import { digits, left, time, words } from "./format.js";
import { SHAPES } from "./kinds.js";

const GONE = ["lost", "loss_of_sustainability", "loss_of_control", "run_away", "collapse"];

/** What the last events and the forecast come to: {word, tone, sub}. */
export function signalOf({ state, level, forecast, lost, end }) {
  const amount = left(forecast?.left);
  const rest = amount && forecast.left.value <= 0 ? "the forecast onset is reached" : amount ? `${amount.value} ${amount.unit} of ${amount.of}${forecast.left.time_s === null ? "" : `, ${time(forecast.left.time_s)}`} left at the present rate` : null;
  if (lost) return { word: "unstable", tone: "alarm", sub: lost.detail };
  if (end) return { word: "ended", tone: "off", sub: end.error || words(end.status ?? "") };
  if (state === "held") return { word: "held", tone: "off", sub: "the drives are stopped" };
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

/** stage: {number, name, role, drainage, control}; share: of the programme, 0 to 1. */
export function stageLine() {
  const words1 = el("div", { "aria-live": "polite" });
  const bar = el("progress", { max: 1, "aria-label": "completed fraction of the programme" });
  return { node: el("div", { class: "stage" }, words1, bar), stage: ({ number, name, role, drainage, control }) =>
    fill(words1, el("strong", {}, `Stage ${number}: ${name ?? words(role)}`), " ", el("span", { class: "quiet" }, [words(role), drainage && `drainage ${words(drainage)}`, control && `control: ${words(control)}`].filter(Boolean).join(", "))),
  share: (value) => {
    bar.value = value;
    bar.textContent = `${Math.round(100 * value)} %`;
  } };
}

// A raw channel's name ends with its unit.
const CHANNEL = /^(.+)_(kN|N|kPa|mm|mm3|cm3|ml|m3|C|V|pct)$/;
const UNITS = { mm3: "mm³", cm3: "cm³", m3: "m³", C: "°C", pct: "%" };
const NO_CHANNEL = new Set(["q_kPa", "p_eff_kPa"]);
const TONES = { missing: "alarm", saturated: "alarm", stuck: "care", spike: "care" };

/** Every channel of the last reading, with its last finding: one that has not ended, or how many have. */
export class Channels {
  constructor(node) {
    Object.assign(this, { node, findings: new Map(), counts: new Map(), at: 0 });
  }

  told(finding) {
    if (finding.until === null) this.counts.set(finding.channel, (this.counts.get(finding.channel) ?? 0) + 1);
    this.findings.set(finding.channel, finding);
  }

  /** At most twice a second: nobody reads faster. */
  show(row, now) {
    if (!row || now - this.at < 500) return;
    this.at = now;
    const names = Object.keys(row).filter((name) => CHANNEL.test(name) && !NO_CHANNEL.has(name) && (row[name] !== null || this.findings.has(name)));
    fill(this.node, el("table", {}, el("thead", {}, el("tr", {}, ["Channel", "Value", "Health"].map((t, i) => el("th", { scope: "col", class: i === 1 ? "number" : null }, t)))),
      el("tbody", {}, names.map((name) => this.row(name, row[name])))));
  }

  row(name, value) {
    const [, what, unit] = CHANNEL.exec(name);
    const finding = this.findings.get(name);
    const open = finding && finding.until === null;
    const tone = open ? TONES[finding.state] ?? "care" : "good";
    const past = this.counts.get(name) ?? 0;
    return el("tr", {}, el("th", { scope: "row" }, words(what)), el("td", { class: "number" }, digits(value, 5), " ", UNITS[unit] ?? unit),
      el("td", {}, el("span", { class: `health ${tone}` }, `${SHAPES[tone]} ${open ? finding.state : "good"}`), open ? el("div", { class: "quiet" }, finding.detail) : past ? el("div", { class: "quiet" }, `${past} findings before`) : null));
  }
}

const MOST_EVENTS = 200;

/** The newest first; one that stands in the list already is left out, and false is said. */
export function addEvent(list, event) {
  const key = [event.kind, event.reading, event.detected_at_reading, event.detail].join(" ");
  if ([...list.children].some((item) => item.dataset.key === key)) return false;
  list.prepend(el("li", { data: { kind: event.kind, key } }, el("span", { class: `tag ${isLoss(event) || event.kind === "imminent" ? "alarm" : event.kind === "approaching" ? "care" : ""}` }, words(event.kind)), " ",
    el("span", { class: "quiet" }, `${time(event.time_s)}, reading ${event.reading}`), el("div", {}, event.detail)));
  while (list.children.length > MOST_EVENTS) list.lastChild.remove();
  return true;
}
