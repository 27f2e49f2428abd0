// SPDX-License-Identifier: GPL-3.0-or-later
// A running test, as it runs. What comes is kept and drawn at the next frame, however fast it comes.
import { get, windowPath } from "./api.js";
import { dottedPlaces, openAcross } from "./breaks.js";
import { el, fill } from "./dom.js";
import { controls } from "./live_controls.js";
import { gauge, gaugeNode } from "./live_gauge.js";
import { Channels, addEvent, isLoss, showSignal, signalOf, stageLine } from "./live_parts.js";
import { LiveRows } from "./live_rows.js";
import { listen } from "./live_stream.js";
import { limitOf, liveCharts, numbers } from "./live_view.js";
import { failed } from "./notice.js";
import { COLUMNS } from "./quantities.js";
import { verdictPanel } from "./test_facts.js";

/** Readings above which the page begins with a window of them instead of each. */
const FEW = 20000;
/** Milliseconds between two drawings at least: nobody sees more, and other work of the machine goes on. */
const PAUSE = 45;
const LEVELS = { approaching: "approaching", imminent: "imminent", warning_withdrawn: null };
const STATES = { held: "held", resumed: "running" };

const stateOf = (live) => (!live?.running ? "ended" : live.held ? "held" : "running");

class RunPage {
  constructor(main, first) {
    const { test, collapse, specimen } = first;
    Object.assign(this, { test, simulated: test.origin === "simulated", rows: new LiveRows(COLUMNS), frame: 0, said: null, drawn: -PAUSE, queue: null, work: null,
      state: stateOf(first.live), level: null, forecast: null, lost: null, end: null,
      limit: collapse.limit_stress_ratio ?? limitOf(specimen.limit_friction_angle_deg) });
    this.signal = el("section", { class: "signal", "aria-label": "State of the test", "aria-live": "assertive" });
    this.bigs = el("div", { class: "bigs" });
    this.bar = gaugeNode();
    this.stage = stageLine();
    this.link = el("span", { class: "tag info", role: "status" }, "connecting");
    this.trouble = el("div");
    this.channels = new Channels(el("div", { class: "scroll" }));
    this.events = el("ol", { class: "event-list", "aria-live": "polite", "aria-label": "Events", tabindex: 0 });
    this.verdict = el("div", { "aria-live": "polite" });
    this.orders = controls(test.id, test.name, (wrong) => fill(this.trouble, wrong ? failed(new Error(wrong)) : null));
    this.charts = liveCharts();
    this.node = this.layout(first.live?.controlled);
    fill(main, this.node);
    first.events.forEach((event) => this.happened(event));
    this.orders.show(this.state);
    this.soon();
  }

  layout(controlled) {
    return el("section", { class: "stack", "aria-label": "Running test" },
      el("div", { class: "head" }, el("div", { class: "row" }, el("h1", { tabindex: -1 }, this.test.name),
        el("span", { class: `tag ${this.simulated ? "care" : "info"}` }, this.simulated ? "SIMULATED" : "recorded"), this.link),
      controlled ? this.orders.node : el("span", { class: "quiet" }, "recorded by another program: view only")),
      this.trouble, this.verdict,
      el("div", { class: "live-state" }, this.signal, el("section", { class: "panel", "aria-label": "Now" }, this.bigs, this.bar)),
      el("section", { class: "panel", "aria-label": "Stage" }, this.stage.node), this.charts.node,
      el("div", { class: "live-grid" }, el("section", { class: "panel" }, el("h2", {}, "Events"), this.events),
        el("section", { class: "panel" }, el("h2", {}, "Channels"), this.channels.node)));
  }

  soon() {
    this.frame ||= requestAnimationFrame((at) => this.draw(at));
  }

  draw(at) {
    this.frame = 0;
    if (at - this.drawn < PAUSE) return this.soon();
    this.drawn = at;
    const { rows, forecast, limit } = this;
    const row = rows.shownNow;
    const eta = row && row.p_eff_kPa > 0 && row.q_kPa !== null ? row.q_kPa / row.p_eff_kPa : null;
    const signal = signalOf(this);
    if (this.said !== signal.word + signal.sub) showSignal(this.signal, signal);
    this.said = signal.word + signal.sub;
    fill(this.bigs, numbers(row, eta, this));
    gauge(this.bar, { eta, forecast, limit });
    this.charts.show(this, at);
    this.channels.show(rows.now, at);
    Object.assign(this.node.dataset, { received: rows.count, first: rows.first ?? "", last: rows.last ?? "", gaps: rows.gaps, checksum: rows.sum.hex(), drawn: row?.reading ?? "" });
  }

  setState(state) {
    this.state = state;
    this.orders.show(state);
    if (state === "held") this.connection("held", "care");
    if (state === "running" && this.link.textContent === "held") this.connection("live", "good");
    this.soon();
  }

  /** A reading, or a span {from, to} of readings that were left out for this browser: all in their order. */
  came(item) {
    if (this.queue) this.queue.push(item);
    else if ("to" in item) this.drain([item]).catch((failure) => fill(this.trouble, failed(failure)));
    else this.rows.add(item);
    this.soon();
  }

  async drain(queue) {
    this.queue = queue;
    try {
      for (let item = queue.shift(); item; item = queue.shift()) {
        if ("to" in item) await this.fillGap(item);
        else this.rows.add(item);
      }
    } finally {
      this.queue = null;
      this.soon();
    }
  }

  happened(event) {
    if (!addEvent(this.events, event)) return;
    if (event.kind in LEVELS) this.level = LEVELS[event.kind];
    if (event.kind === "warning_withdrawn") this.forecast = null;
    if (isLoss(event)) this.lost = event;
    if (event.kind in STATES) this.setState(STATES[event.kind]);
    this.soon();
  }

  /** The database has what was left out within a second, and the events of that time. */
  async fillGap({ from, to }) {
    for (let left = 30; left > 0; --left) {
      const window = await get(windowPath(this.test.id, COLUMNS, { from, to, pixels: 8000 }));
      const { columns, exact, last } = window;
      if (last < to && left > 1) {
        await new Promise((done) => setTimeout(done, 200));
        continue;
      }
      this.rows.learn(window);
      if (exact) columns.reading.forEach((_, i) => this.rows.add(Object.fromEntries(this.rows.names.map((name) => [name, columns[name][i]]))));
      else this.rows.replace(columns, from);
      break;
    }
    (await get(`/api/tests/${this.test.id}`)).events.forEach((event) => this.happened(event));
  }

  /** Second-order work comes with the monitor's windows, later than readings: it is asked for now and then. */
  async readWork() {
    if (document.hidden) return;
    const window = await get(windowPath(this.test.id, ["time_s", "q_kPa"], { pixels: 300, work: true }));
    const { work, faults, unread_steps: unread } = window;
    this.work = { ...work, normalised: openAcross(work.reading, work.normalised, faults), dotted: dottedPlaces(work.reading, unread) };
    this.rows.learn(window);
    this.soon();
  }

  connection(text, tone) {
    if (this.end) return;
    this.link.textContent = text;
    this.link.className = `tag ${tone}`;
  }

  async finish(end) {
    this.connection("ended", "");
    this.end = end;
    clearInterval(this.asking);
    await this.readWork();
    this.setState("ended");
    const last = await get(`/api/tests/${this.test.id}`);
    fill(this.verdict, verdictPanel(last), el("p", { class: "row" }, el("a", { class: "button main", href: `#/test/${this.test.id}` }, "Open the test"),
      this.simulated ? el("a", { class: "button", href: "#/try" }, "Change and run again") : null));
  }

  async listen() {
    if (this.test.readings > FEW) {
      const window = await get(windowPath(this.test.id, COLUMNS, { pixels: 300 }));
      this.rows.learn(window);
      this.rows.replace(window.columns);
    }
    this.asking = setInterval(() => this.readWork().catch(() => clearInterval(this.asking)), 3000);
    const wrong = (failure) => fill(this.trouble, failed(failure));
    this.stop = listen(this.test.id, this.rows.last, {
      reading: (row) => this.came(row),
      event: (event) => this.happened(event),
      forecast: (forecast) => {
        this.forecast = forecast;
        this.soon();
      },
      channels: (finding) => this.channels.told(finding),
      stage: (stage) => this.stage.stage(stage),
      progress: ({ share }) => this.stage.share(share),
      window: (missed) => this.came(missed),
      end: (end) => this.finish(end).catch(wrong),
      back: () => this.connection("live", "good"),
      lost: (closed) => this.connection(closed ? "no connection" : "reconnecting", "alarm"),
    });
  }

  leave() {
    this.stop?.();
    clearInterval(this.asking);
    cancelAnimationFrame(this.frame);
    this.charts.end();
  }
}

export async function show(main, [id]) {
  const page = new RunPage(main, await get(`/api/tests/${encodeURIComponent(id)}`));
  await page.listen();
  return { title: `${page.test.name}, live`, end: () => page.leave() };
}
