// SPDX-License-Identifier: GPL-3.0-or-later
// One test.
import { get } from "./api.js";
import { el, fill } from "./dom.js";
import { takeNotice } from "./notice.js";
import { TestCharts } from "./test_charts.js";
import { checksTable, criteriaTable, eventsTable, guessesPanel, specimenPanel, verdictPanel, warningsPanel } from "./test_facts.js";

const FORMATS = [["pdf", "PDF"], ["html", "HTML"], ["json", "JSON"], ["csv", "CSV"]];

function downloads(id) {
  return el("nav", { class: "row", "aria-label": "Report and downloads" },
    el("a", { class: "button main", href: `/api/tests/${id}/sheet`, target: "_blank", rel: "noopener" }, "Test report"),
    FORMATS.map(([format, text]) => el("a", { class: "button", href: `/api/tests/${id}/export?format=${format}`, download: "" }, `↓ ${text}`)));
}

export async function show(main, [id]) {
  const document = await get(`/api/tests/${encodeURIComponent(id)}`);
  const { test } = document;
  const charts = new TestCharts(test.id, document);
  const running = test.status === "running";
  fill(main, el("div", { class: "stack" },
    takeNotice(),
    el("div", { class: "head" },
      el("div", { class: "row" }, el("h1", { tabindex: -1 }, test.name), el("span", { class: "tag" }, test.programme ?? "type unknown"),
        el("span", { class: `tag ${test.origin === "simulated" ? "care" : "info"}` }, test.origin === "simulated" ? "SIMULATED" : "recorded"),
        test.status !== "complete" ? el("span", { class: "tag care" }, test.status.replaceAll("_", " ")) : null,
        running ? el("a", { href: `#/run/${test.id}` }, "watch it live") : null),
      downloads(test.id)),
    verdictPanel(document), charts.node, warningsPanel(document), guessesPanel(document), criteriaTable(document), checksTable(document),
    el("div", { class: "two" }, eventsTable(document, (reading) => {
      charts.goTo(reading);
      charts.node.scrollIntoView({ block: "start" });
    }), specimenPanel(document))));
  return { title: test.name, end: () => charts.end() };
}
