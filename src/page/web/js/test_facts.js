// SPDX-License-Identifier: GPL-3.0-or-later
// What the report says of a test, in words and tables: verdict, criteria, checks, events, warnings, specimen.
import { el } from "./dom.js";
import { DASH, assumption, date, digits, fixed, percent, time, within, words } from "./format.js";
import { SHAPES, judgement, verdict } from "./kinds.js";

const figure = (name, ...value) => el("div", { class: "figure" }, el("dt", {}, name), el("dd", {}, value));
const cell = (label, ...content) => el("td", { "data-label": label }, content);
const number = (label, ...content) => el("td", { class: "number", "data-label": label }, content);

function table(caption, heads, rows) {
  if (rows.length === 0) return null;
  return el("section", { class: "panel" }, el("h2", {}, caption),
    el("div", { class: "scroll" }, el("table", { class: "folds" },
      el("thead", {}, el("tr", {}, heads.map(([text, kind]) => el("th", { scope: "col", class: kind }, text)))), el("tbody", {}, rows))));
}

/** Both instants of a test: the loss of control is there whatever the result is. */
function lossOfControl({ loss_of_control: lost }) {
  if (!lost) return [];
  const known = lost.detected_at ? `detected at reading ${lost.detected_at.reading}` : "detected when the record had ended";
  return [figure("loss of control at η", within(lost.eta, lost.eta_low, lost.eta_high)),
    figure("loss of control when", time(lost.time_s), el("small", {}, ` reading ${lost.reading}, ${known}`))];
}

export function verdictPanel({ collapse, test }) {
  const { word, tone, why } = verdict(collapse);
  const inside = collapse.inside_limit_surface;
  const limit = collapse.limit_stress_ratio ? el("small", {}, ` M ${fixed(collapse.limit_stress_ratio, 2)}`) : el("small", { title: collapse.limit_source ?? "" }, " no friction angle given");
  const figures = collapse.detected ? [
    figure("onset of instability at η = q/p′", within(collapse.eta, collapse.eta_low, collapse.eta_high)),
    figure("φ_mob", `${fixed(collapse.phi_mob_deg, 1)}°`),
    figure("when", time(collapse.time_s), el("small", {}, ` reading ${collapse.reading}${collapse.detected_at ? `, detected at reading ${collapse.detected_at.reading}` : ""}`)),
    figure("axial strain ε₁", percent(collapse.axial_strain)),
    figure("p′, q", `${fixed(collapse.p_eff_kPa)}, ${fixed(collapse.q_kPa)} `, el("small", {}, "kPa")),
    figure("W₂ normalised", `${fixed(collapse.second_order_work_normalised, 3)}${collapse.second_order_work_error === null ? "" : ` ± ${fixed(collapse.second_order_work_error, 3)}`}`),
    figure("limit surface", inside === null ? "unknown" : inside ? "inside" : "on it", limit),
    collapse.truth?.lost_sustainability ? figure("truth (specimen)", `η ${fixed(collapse.truth.eta, 2)}`, el("small", {}, ` ${time(collapse.truth.time_s)}`)) : null,
  ] : [
    figure("assessed", collapse.judged?.complete ? "to the end" : collapse.judged?.to_reading !== null && collapse.judged?.to_reading !== undefined ? `to reading ${collapse.judged.to_reading}` : DASH),
    collapse.nearest ? figure("least W₂ normalised", fixed(collapse.nearest.second_order_work_normalised, 3), el("small", {}, ` reading ${collapse.nearest.reading}`)) : null,
    figure("limit surface", collapse.limit_stress_ratio ? null : "unknown", limit),
  ];
  return el("section", { class: `panel assessment ${tone}`, "aria-label": "Assessment", data: { verdict: String(collapse.kind), test: String(test.id) } },
    el("div", {}, el("div", { class: "word" }, el("span", { "aria-hidden": "true" }, `${SHAPES[tone]} `), word), el("div", { class: "quiet" }, why)),
    el("dl", { class: "figures" }, figures, lossOfControl(collapse)));
}

export function criteriaTable({ collapse }) {
  return table("Criteria", [["Criterion"], ["Detected"], ["Reading", "number"], ["Time", "number"], ["η", "number"], ["Detected at", "number"], ["Evidence"]],
    (collapse.criteria ?? []).map((c) => el("tr", {}, el("th", { scope: "row", "data-label": "Criterion" }, words(c.name)),
      cell("Detected", el("span", { class: `tag ${c.detected ? "alarm" : c.detected === false ? "good" : ""}` }, judgement(c.detected))),
      number("Reading", c.reading ?? DASH), number("Time", time(c.time_s)), number("η", fixed(c.eta, 2)), number("Detected at", c.detected_at_reading ?? DASH),
      el("td", { class: "long", "data-label": "Evidence" }, c.evidence ?? ""))));
}

export function checksTable({ checks }) {
  return table("Checks", [["Check"], ["Result"], ["Measured", "number"], ["Limit", "number"], ["What it is"]],
    checks.map((c) => el("tr", {}, el("th", { scope: "row", "data-label": "Check" }, words(c.name)),
      cell("Result", el("span", { class: `tag ${c.ok ? "good" : c.ok === null ? "" : "alarm"}` }, judgement(c.ok, "ok", "not ok"))),
      number("Measured", digits(c.measured, 4)), number("Limit", digits(c.limit, 4)), el("td", { class: "long", "data-label": "What it is" }, c.note ?? ""))));
}

/** `goTo(reading)` puts the cursor of the charts there. */
export function eventsTable({ events }, goTo) {
  return table("Events", [["Reading", "number"], ["Time", "number"], ["Event"], ["What happened"]],
    events.map((e) => el("tr", {}, number("Reading", el("button", { type: "button", class: "plain", "aria-label": `Cursor to reading ${e.reading}`, on: { click: () => goTo(e.reading) } }, e.reading)),
      number("Time", time(e.time_s)), cell("Event", words(e.kind)), el("td", { class: "long", "data-label": "What happened" }, e.detail))));
}

export function guessesPanel({ guesses }) {
  if (!guesses?.length) return null;
  return el("section", { class: "panel", "aria-label": "Assumed" }, el("h2", {}, "Assumed ", el("span", { class: "tag care" }, String(guesses.length))),
    el("ul", {}, guesses.map((g) => el("li", {}, assumption(g)))));
}

export function warningsPanel({ warnings, collapse }) {
  const depends = (collapse.depends_on ?? []).map((d) => `The assessment depends on an assumption: ${d.guess}. ${d.remedy ?? ""}`);
  const all = [...warnings, ...depends];
  return el("section", { class: "panel", "aria-label": "Warnings" }, el("h2", {}, "Warnings ", el("span", { class: `tag ${warnings.length ? "care" : "good"}` }, String(warnings.length))),
    all.length ? el("ul", {}, all.map((text) => el("li", {}, text))) : el("p", { class: "quiet" }, "No problem was found that affects this assessment."));
}

export function specimenPanel({ test, specimen, consolidation, corrections, notes }) {
  const facts = [["Kind of record", test.origin === "simulated" ? "SIMULATED: a virtual specimen, not measured" : "recorded"], ["Type of test", test.programme],
    ["Source", test.source], ["Dialect", test.dialect], ["Seed", test.seed], ["Readings", test.readings], ["Stored", date(test.stored_at)], ["Tags", test.tags?.join(", ") || null],
    ["Material", specimen.material], ["Height, diameter", specimen.height_mm ? `${fixed(specimen.height_mm, 2)} mm, ${fixed(specimen.diameter_mm, 2)} mm` : null],
    ["Void ratio as built", specimen.void_ratio === null ? null : fixed(specimen.void_ratio, 4)],
    ["p′ at the start of shear", consolidation.p_eff_kPa === null ? null : `${fixed(consolidation.p_eff_kPa)} kPa`],
    ["Void ratio at the start of shear", consolidation.void_ratio === null ? null : fixed(consolidation.void_ratio, 4)],
    ["B value", consolidation.b_value === null ? null : fixed(consolidation.b_value, 3)], ["Membrane correction", corrections?.membrane],
    ...(notes ?? []).map(({ label, text }) => [`From the file${label ? `: ${label}` : ""}`, text])];
  return el("section", { class: "panel" }, el("h2", {}, "Test and specimen"), el("table", {}, el("tbody", {},
    facts.filter(([, value]) => value !== null && value !== undefined).map(([name, value]) => el("tr", {}, el("th", { scope: "row" }, name), el("td", { class: "long" }, value))))));
}
