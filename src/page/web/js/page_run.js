// SPDX-License-Identifier: GPL-3.0-or-later
// A running test, as it runs. What comes is kept and drawn at the next frame, however fast it comes.
import { get, windowPath } from "./api.js";
import { Chart } from "./chart.js";
import { el, fill } from "./dom.js";
import { fixed, left, time } from "./format.js";
import { controls } from "./live_controls.js";
import { gauge, gaugeNode } from "./live_gauge.js";
import { addEvent, isLoss, showChannels, showSignal, showStages, signalOf } from "./live_parts.js";
import { LiveRows } from "./live_rows.js";
import { listen } from "./live_stream.js";
import { failed } from "./notice.js";
import { COLUMNS, QUANTITIES, axisTitle } from "./quantities.js";
import { lines } from "./stress_layers.js";
import { verdictPanel } from "./test_facts.js";

const FEW = 20000;
const LEVELS = { approaching: "approaching", imminent: "imminent", warning_withdrawn: null };

export async function show(main, [id]) {
  const [first, run] = await Promise.all([get(`/api/tests/${encodeURIComponent(id)}`), get(`/api/runs/${encodeURIComponent(id)}`).catch(() => null)]);
  const { test } = first;
  const rows = new LiveRows(COLUMNS);
  const now = { state: run?.state ?? "ended", level: null, forecast: null, lost: null, end: null, limit: first.collapse.limit_stress_ratio ?? null };

  const signal = el("section", { class: "signal", "aria-label": "State of the test", "aria-live": "assertive" });
  const bigs = el("div", { class: "bigs" });
  const bar = gaugeNode();
  const stage = el("div", { "aria-live": "polite" });
  const link = el("span", { class: "tag info", role: "status" }, "connecting");
  const trouble = el("div");
  const channels = el("div", { class: "scroll" }, el("p", { class: "quiet" }, "No word of the channels yet."));
  const events = el("ol", { class: "event-list", "aria-live": "polite", "aria-label": "Events", tabindex: 0 });
  const verdict = el("div", { "aria-live": "polite" });
  const orders = controls(test.id, test.name, (wrong, answer) => {
    fill(trouble, wrong ? failed(new Error(wrong)) : null);
    if (answer?.state) setState(answer.state);
  });
  const charts = [chartOf("p_eff", "q", 330), chartOf("time", "q", 158), chartOf("time", "u", 158)];
  const node = el("section", { class: "stack", data: { received: "0", last: "", drawn: "", gaps: "0", checksum: "" } },
    el("div", { class: "head" }, el("div", { class: "row" }, el("h1", { tabindex: -1 }, test.name), el("span", { class: `tag ${test.origin === "simulated" ? "care" : "info"}` }, test.origin === "simulated" ? "SIMULATED" : "recorded"), link), orders.node),
    trouble, verdict,
    el("div", { class: "live-state" }, signal, el("section", { class: "panel", "aria-label": "Now" }, bigs, bar)),
    el("section", { class: "panel", "aria-label": "Stage" }, stage),
    el("div", { class: "charts" }, el("div", {}, charts[0].node), el("div", {}, charts[1].node, charts[2].node)),
    el("div", { class: "live-grid" }, el("section", { class: "panel" }, el("h2", {}, "Events"), events), el("section", { class: "panel" }, el("h2", {}, "Channels"), channels)));
  fill(main, node);

  let frame = 0;
  let ended = false;
  const soon = () => {
    frame ||= requestAnimationFrame(draw);
  };

  function setState(state) {
    now.state = state;
    orders.show(state);
    soon();
  }

  function chartOf(x, y, height) {
    return Object.assign(new Chart({ title: `${QUANTITIES[y].title} over ${QUANTITIES[x].title}, live`, height, cursor: false, x: { title: axisTitle(x) }, y: { title: height < 200 ? `${QUANTITIES[y].symbol} (${QUANTITIES[y].unit})` : axisTitle(y) } }), { keys: [x, y] });
  }

  function draw() {
    frame = 0;
    const row = rows.now;
    const eta = row && row.p_eff_kPa > 0 ? row.q_kPa / row.p_eff_kPa : null;
    const forecast = now.forecast;
    showSignal(signal, signalOf(now));
    const amount = left(forecast?.left);
    const big = (name, value, unit) => el("div", { class: "big" }, el("div", { class: "value" }, value, " ", el("small", {}, unit)), el("div", { class: "name" }, name));
    fill(bigs, big("stress ratio η = q/p′", fixed(eta, 2), ""),
      big("to the instability line", forecast && eta !== null ? fixed(forecast.eta_forecast - eta, 2) : "–", forecast ? `η ± ${fixed((forecast.eta_high - forecast.eta_low) / 2, 2)}` : "no forecast"),
      amount ? big("left", amount[0], amount[1]) : big("left", "–", ""),
      big("q", fixed(row?.q_kPa), "kPa"), big("u", fixed(row?.pore_pressure_kPa), "kPa"), big(`axial strain ε₁, at ${time(row?.time_s)}`, row?.axial_strain == null ? "–" : fixed(100 * row.axial_strain, 2), "%"));
    gauge(bar, { eta, forecast, limit: now.limit });
    const { columns } = rows;
    for (const chart of charts) {
      const [x, y] = chart.keys;
      const line = { kind: "line", x: QUANTITIES[x].of(columns), y: QUANTITIES[y].of(columns), colour: y === "u" ? "green" : "blue", range: y === "q" ? { y: [0, 10] } : null };
      const tip = row ? [{ kind: "mark", shape: "dot", colour: "ink", ranged: false, x: line.x.at(-1), y: line.y.at(-1) }] : [];
      const known = x === "p_eff" ? lines({ eta: forecast?.eta_forecast, limit_stress_ratio: now.limit }, "pq", false) : [];
      chart.set([...known, line, ...tip]);
    }
    Object.assign(node.dataset, { received: String(rows.count), first: String(rows.first ?? ""), last: String(rows.last ?? ""), gaps: String(rows.gaps), checksum: rows.sum.value.toString(16).padStart(8, "0"), drawn: String(row?.reading ?? "") });
  }

  async function windowAgain() {
    const { columns } = await get(windowPath(test.id, COLUMNS, { pixels: 300 }));
    rows.replace(columns);
    soon();
  }

  async function finish(end) {
    ended = true;
    now.end = end;
    setState("ended");
    link.textContent = "ended";
    const last = await get(`/api/tests/${test.id}`);
    fill(verdict, verdictPanel(last), el("p", { class: "row" }, el("a", { class: "button main", href: `#/test/${test.id}` }, "Open the test"), last.test.origin === "simulated" ? el("a", { class: "button", href: "#/try" }, "Change and run again") : null));
  }

  if (test.readings > FEW) await windowAgain();
  orders.show(now.state);
  draw();
  const stop = listen(test.id, rows.last, {
    reading: (row) => {
      rows.add(row);
      soon();
    },
    event: (event) => {
      addEvent(events, event);
      if (event.kind in LEVELS) now.level = LEVELS[event.kind];
      if (event.kind === "warning_withdrawn") now.forecast = null;
      if (isLoss(event)) now.lost = event;
      if (event.kind === "held") setState("held");
      if (event.kind === "resumed") setState("running");
      soon();
    },
    forecast: (forecast) => {
      now.forecast = forecast;
      if (forecast.level !== undefined && forecast.level !== null) now.level = forecast.level;
      soon();
    },
    channels: (said) => showChannels(channels, said.channels),
    stage: (said) => showStages(stage, said),
    window: () => windowAgain(),
    end: (end) => finish(end),
    back: () => {
      link.textContent = "live";
      link.className = "tag good";
    },
    lost: (closed) => {
      if (ended) return;
      link.textContent = closed ? "no connection" : "coming back";
      link.className = "tag alarm";
    },
  });
  return { title: `${test.name}, live`, end: () => {
    stop();
    cancelAnimationFrame(frame);
    charts.forEach((chart) => chart.end());
  } };
}
