// SPDX-License-Identifier: GPL-3.0-or-later
// A running test, as it runs. What comes is kept and drawn at the next frame, however fast it comes.
import { get, windowPath } from "./api.js";
import { Chart } from "./chart.js";
import { el, fill } from "./dom.js";
import { fixed, left, time } from "./format.js";
import { controls } from "./live_controls.js";
import { gauge, gaugeNode } from "./live_gauge.js";
import { Channels, addEvent, isLoss, showSignal, signalOf, stageLine } from "./live_parts.js";
import { LiveRows } from "./live_rows.js";
import { listen } from "./live_stream.js";
import { failed } from "./notice.js";
import { COLUMNS, QUANTITIES, axisTitle } from "./quantities.js";
import { lines } from "./stress_layers.js";
import { verdictPanel } from "./test_facts.js";

const FEW = 20000;
const LEVELS = { approaching: "approaching", imminent: "imminent", warning_withdrawn: null };
const STATES = { held: "held", resumed: "running" };

const stateOf = (live) => (!live?.running ? "ended" : live.held ? "held" : "running");

/** M of a friction angle: 6 sin φ / (3 − sin φ). */
function limitOf(degrees) {
  if (typeof degrees !== "number") return null;
  const sine = Math.sin((degrees * Math.PI) / 180);
  return (6 * sine) / (3 - sine);
}

function big(name, value, unit) {
  return el("div", { class: "big" }, el("div", { class: "value" }, value, " ", el("small", {}, unit)), el("div", { class: "name" }, name));
}

function numbers(row, eta, { forecast, lost }) {
  const amount = lost ? null : left(forecast?.left);
  const away = lost ? big("to the instability line: passed", "–", "") : forecast && eta !== null
    ? big(`η to the instability line, ± ${fixed((forecast.eta_high - forecast.eta_low) / 2, 2)}`, fixed(forecast.eta_forecast - eta, 2), "") : big("to the instability line: no forecast", "–", "");
  return [big("stress ratio η = q/p′", fixed(eta, 2), ""), away, amount ? big(`left, of ${amount.of}`, amount.value, amount.unit) : big("left", "–", ""),
    big("deviator stress q", fixed(row?.q_kPa), "kPa"), big("pore pressure u", fixed(row?.pore_pressure_kPa), "kPa"),
    big(`axial strain ε₁, at ${time(row?.time_s)}`, typeof row?.axial_strain === "number" ? fixed(100 * row.axial_strain, 2) : "–", "%")];
}

/** The charts of what runs; show(rows, forecast, limit). */
function liveCharts() {
  const make = (x, y, height) => new Chart({ title: `${QUANTITIES[y].title} over ${QUANTITIES[x].title}, live`, height, cursor: false,
    x: { title: axisTitle(x) }, y: { title: height < 200 ? `${QUANTITIES[y].symbol} (${QUANTITIES[y].unit})` : axisTitle(y) } });
  const charts = [["p_eff", "q", 330], ["time", "q", 158], ["time", "u", 158]].map(([x, y, height]) => ({ x, y, chart: make(x, y, height) }));
  return { node: el("div", { class: "charts" }, el("div", {}, charts[0].chart.node), el("div", {}, charts[1].chart.node, charts[2].chart.node)),
    end: () => charts.forEach(({ chart }) => chart.end()),
    show: ({ columns, now }, forecast, limit) => {
      for (const { x, y, chart } of charts) {
        const line = { kind: "line", x: QUANTITIES[x].of(columns), y: QUANTITIES[y].of(columns), colour: y === "u" ? "green" : "blue", range: y === "q" ? { y: [0, 10] } : null };
        const tip = now ? [{ kind: "mark", shape: "dot", colour: "ink", ranged: false, x: line.x.at(-1), y: line.y.at(-1) }] : [];
        const known = x === "p_eff" ? lines({ eta: forecast?.eta_forecast, limit_stress_ratio: limit }, "pq", false) : [];
        chart.set([...known, line, ...tip]);
      }
    } };
}

export async function show(main, [id]) {
  const first = await get(`/api/tests/${encodeURIComponent(id)}`);
  const { test } = first;
  const rows = new LiveRows(COLUMNS);
  const now = { state: stateOf(first.live), level: null, forecast: null, lost: null, end: null };
  const limit = first.collapse.limit_stress_ratio ?? limitOf(first.specimen.limit_friction_angle_deg);

  const signal = el("section", { class: "signal", "aria-label": "State of the test", "aria-live": "assertive" });
  const bigs = el("div", { class: "bigs" });
  const bar = gaugeNode();
  const stage = stageLine();
  const link = el("span", { class: "tag info", role: "status" }, "connecting");
  const trouble = el("div");
  const channelNode = el("div", { class: "scroll" });
  const channels = new Channels(channelNode);
  const events = el("ol", { class: "event-list", "aria-live": "polite", "aria-label": "Events", tabindex: 0 });
  const verdict = el("div", { "aria-live": "polite" });
  const orders = controls(test.id, test.name, (wrong) => fill(trouble, wrong ? failed(new Error(wrong)) : null));
  const charts = liveCharts();
  const simulated = test.origin === "simulated";
  const node = el("section", { class: "stack", "aria-label": "Running test" },
    el("div", { class: "head" }, el("div", { class: "row" }, el("h1", { tabindex: -1 }, test.name), el("span", { class: `tag ${simulated ? "care" : "info"}` }, simulated ? "SIMULATED" : "recorded"), link),
      first.live?.controlled ? orders.node : el("span", { class: "quiet" }, "recorded by another program: look only")),
    trouble, verdict,
    el("div", { class: "live-state" }, signal, el("section", { class: "panel", "aria-label": "Now" }, bigs, bar)),
    el("section", { class: "panel", "aria-label": "Stage" }, stage.node), charts.node,
    el("div", { class: "live-grid" }, el("section", { class: "panel" }, el("h2", {}, "Events"), events), el("section", { class: "panel" }, el("h2", {}, "Channels"), channelNode)));
  fill(main, node);

  let frame = 0;
  let word = null;
  const soon = () => (frame ||= requestAnimationFrame(draw));
  const setState = (state) => {
    now.state = state;
    orders.show(state);
    soon();
  };

  function draw(at) {
    frame = 0;
    const row = rows.now;
    const eta = row && row.p_eff_kPa > 0 ? row.q_kPa / row.p_eff_kPa : null;
    const said = signalOf(now);
    if (said.word + said.sub !== word) showSignal(signal, said);
    word = said.word + said.sub;
    fill(bigs, numbers(row, eta, now));
    gauge(bar, { eta, forecast: now.forecast, limit });
    charts.show(rows, now.forecast, limit);
    channels.show(row, at);
    Object.assign(node.dataset, { received: rows.count, first: rows.first ?? "", last: rows.last ?? "", gaps: rows.gaps, checksum: rows.sum.hex(), drawn: row?.reading ?? "" });
  }

  function happened(event) {
    if (!addEvent(events, event)) return;
    if (event.kind in LEVELS) now.level = LEVELS[event.kind];
    if (event.kind === "warning_withdrawn") now.forecast = null;
    if (isLoss(event)) now.lost = event;
    if (event.kind in STATES) setState(STATES[event.kind]);
    soon();
  }

  /** Readings that were dropped for this browser are asked of the database, which has them within a second. */
  let waiting = null;
  async function fillGap({ from, to }) {
    waiting ??= [];
    for (let left = 30; left > 0; --left) {
      const { columns, exact } = await get(windowPath(test.id, COLUMNS, { from, to, pixels: 8000 }));
      if ((columns.reading.at(-1) ?? -1) >= to || left === 1) {
        if (exact) columns.reading.forEach((_, i) => rows.add(Object.fromEntries(rows.names.map((name) => [name, columns[name][i]]))));
        else rows.replace(columns);
        break;
      }
      await new Promise((done) => setTimeout(done, 200));
    }
    const queue = waiting;
    waiting = null;
    queue.forEach((row) => rows.add(row));
    (await get(`/api/tests/${test.id}`)).events.forEach(happened);
  }

  async function finish(end) {
    now.end = end;
    setState("ended");
    link.textContent = "ended";
    link.className = "tag";
    const last = await get(`/api/tests/${test.id}`);
    fill(verdict, verdictPanel(last), el("p", { class: "row" }, el("a", { class: "button main", href: `#/test/${test.id}` }, "Open the test"), simulated ? el("a", { class: "button", href: "#/try" }, "Change and run again") : null));
  }

  if (test.readings > FEW) rows.replace((await get(windowPath(test.id, COLUMNS, { pixels: 300 }))).columns);
  first.events.forEach(happened);
  orders.show(now.state);
  soon();
  const stop = listen(test.id, rows.last, {
    reading: (row) => {
      if (waiting) waiting.push(row);
      else rows.add(row);
      soon();
    },
    event: happened,
    forecast: (forecast) => {
      now.forecast = forecast;
      soon();
    },
    channels: (finding) => channels.told(finding),
    stage: (said) => stage.stage(said),
    progress: ({ share }) => stage.share(share),
    window: (missed) => fillGap(missed).catch((failure) => fill(trouble, failed(failure))),
    end: (end) => finish(end),
    back: () => {
      link.textContent = "live";
      link.className = "tag good";
    },
    lost: (closed) => {
      if (now.end) return;
      link.textContent = closed ? "no connection" : "coming back";
      link.className = "tag alarm";
    },
  });
  return { title: `${test.name}, live`, end: () => {
    stop();
    cancelAnimationFrame(frame);
    charts.end();
  } };
}
