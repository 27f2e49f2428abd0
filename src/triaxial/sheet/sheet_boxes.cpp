// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/sheet/sheet_boxes.hpp"

#include <fmt/format.h>

#include <cmath>

#include "src/output/words.hpp"
#include "src/study/sheet/deviations.hpp"
#include "src/study/sheet/specimen_phases.hpp"
#include "src/triaxial/facts/collapse_fact.hpp"
#include "src/triaxial/facts/cyclic_fact.hpp"
#include "src/triaxial/facts/verdict_fact.hpp"
#include "src/triaxial/sheet/test_sheet.hpp"

namespace triax::src {
namespace {

constexpr std::size_t kHeadWords = 12;         // of the list: those of the head
constexpr std::size_t kOptionalHeadWords = 2;  // behind them: client and who ordered the test

std::string kPa(double pa, int decimals = 1) { return in_kPa(if_known(pa), decimals); }

/// Three digits, without a power of ten before 10⁹.
std::string plain(double value) {
  return value >= 1000 && value < 1e9 ? fmt::format("{:.0f}", value) : fmt::format("{:.3g}", value);
}

/// "0.0123 mm/min (0.53 %/h)".
std::string rate_words(const std::optional<double>& per_s, const std::optional<double>& height_m) {
  if (!per_s) return {};
  const std::string percent = fmt::format("{:.3g} %/h", *per_s * 100 * 3600);
  return height_m ? fmt::format("{:.3g} mm/min, {}", *per_s * *height_m * 1e3 * 60, percent)
                  : percent;
}

std::string minutes(const std::optional<double>& seconds) {
  return seconds ? fmt::format("{:.3g}", *seconds / 60) : std::string(kUnknown);
}

/// Blank where neither is known.
std::string two(const std::string& a, const std::string& b) {
  return a == kUnknown && b == kUnknown ? std::string() : a + ", " + b;
}

std::optional<double> height_of(const db::StoredTest& test) {
  const auto& at = test.summary.consolidation.height_m;
  return at ? at : test.header.specimen.height_m;
}

}  // namespace

SheetBox head_box(const SheetTest& test) {
  SheetBox box{.columns = 4};
  for (const auto& [key, label] : study::sheet_word_list().first(kHeadWords))
    box.facts.push_back(fact_or_blank(std::string(label), study::word_of(test.words, key)));
  for (const auto& [key, label] : study::sheet_word_list().subspan(kHeadWords, kOptionalHeadWords))
    if (auto word = study::word_of(test.words, key); !word.empty())
      box.facts.push_back({std::string(label), {std::move(word)}});
  const auto& stored = test.result.stored;
  box.facts.push_back(fact_or_blank("Type", stored.header.programme));
  box.facts.push_back(fact_or_blank("Test no.", fmt::format("{}", stored.id)));
  box.facts.push_back(fact_or_blank("Readings", fmt::format("{}", stored.summary.readings)));
  box.facts.push_back(fact_or_blank("Approved", {}));
  return box;
}

SheetBox specimen_box(const SheetTest& test) {
  const auto phases = study::specimen_phases(test.result.stored, test.values, test.words);
  SheetBox box{.title = "Specimen",
               .table = {{{""},
                          {"as built", Align::right},
                          {"before shear", Align::right},
                          {"after", Align::right}},
                         {}}};
  const auto row = [&](const char* label, auto value) {
    auto cell = [&](const study::SpecimenPhase& phase) {
      const std::string text = value(phase);
      return text == kUnknown ? std::string() : text;
    };
    box.table.rows.push_back({label, cell(phases.built), cell(phases.start), cell(phases.end)});
  };
  using Phase = study::SpecimenPhase;
  const auto marked = [](const Phase& p, const std::string& text) {
    return p.saturation_is_assumed && text != kUnknown ? text + "*" : text;
  };
  row("H (mm)", [](const Phase& p) { return in_mm(p.height_m); });
  row("D (mm)", [](const Phase& p) { return in_mm(p.diameter_m); });
  row("m (g)", [&](const Phase& p) {
    return marked(p, number(p.mass_kg ? std::optional(*p.mass_kg * 1e3) : std::nullopt, 1));
  });
  row("w (%)", [&](const Phase& p) { return marked(p, in_percent(p.water_content, 1)); });
  row("ρ_d (Mg/m³)", [](const Phase& p) {
    return number(p.dry_density ? std::optional(*p.dry_density * 1e-3) : std::nullopt, 3);
  });
  row("e", [](const Phase& p) { return number(p.void_ratio, 3); });
  row("S_r (%)", [&](const Phase& p) { return marked(p, in_percent(p.saturation, 0)); });
  const auto& gs = test.result.stored.header.specimen.specific_gravity;
  box.lines.push_back(gs ? fmt::format("G_s = {:.3g}", *gs) : "G_s: not given");
  if (phases.start.saturation_is_assumed || phases.end.saturation_is_assumed)
    box.lines.back() += "; * saturated: w = e/G_s";
  return box;
}

SheetBox saturation_box(const SheetTest& test) {
  SheetBox box{.title = "Saturation"};
  const auto& b = test.result.stored.summary.consolidation.b_value;
  box.facts.push_back(fact_or_blank("B = Δu/Δσ_c", number(b, 3)));
  if (test.values.steps.empty()) {
    box.lines.emplace_back("no stage before shear in the record");
    return box;
  }
  box.table = {
      {{"stage"}, {"σ_c (kPa)", Align::right}, {"u (kPa)", Align::right}, {"B", Align::right}}, {}};
  constexpr std::size_t kMostSteps = 8;
  const auto& steps = test.values.steps;
  const std::size_t first = steps.size() > kMostSteps ? steps.size() - kMostSteps : 0;
  for (std::size_t i = first; i < steps.size(); ++i) {
    const auto& s = steps[i];
    const auto from_to = [](double from, double to) {
      return fmt::format("{}→{}", kPa(from, 0), kPa(to, 0));
    };
    box.table.rows.push_back(
        {fmt::format("{} {}", s.stage,
                     s.name.empty() ? spaced(std::string(to_string(s.role))) : s.name),
         from_to(s.cell_from_pa, s.cell_to_pa), from_to(s.pore_from_pa, s.pore_to_pa),
         s.b() ? number(s.b(), 3) : std::string()});
  }
  if (first > 0) box.lines.push_back(fmt::format("and {} stages before these", first));
  return box;
}

SheetBox consolidation_box(const SheetTest& test) {
  SheetBox box{.title = "Consolidation and rate"};
  const auto& values = test.values;
  const auto& stored = test.result.stored;
  box.facts.push_back(fact_or_blank("p′₀ (kPa)", in_kPa(stored.summary.consolidation.p_eff_pa)));
  if (values.start) {
    box.facts.push_back(fact_or_blank(
        "σ_c, u at start (kPa)",
        two(kPa(values.start->cell_pressure), kPa(values.start->state.pore_pressure))));
    box.facts.push_back(fact_or_blank("σ₁′, σ₃′ at start (kPa)",
                                      two(kPa(values.start->state.effective_stress.axial),
                                          kPa(values.start->state.effective_stress.radial))));
  }
  const auto height = height_of(stored);
  const auto at = values.options.drained_at;
  const auto factors = study::factors_of(at);
  if (const auto& curve = values.consolidation) {
    const double out = curve->points.back().outflow;
    box.facts.push_back(fact_or_blank(curve->in_m3 ? "water out (cm³)" : "ε_v (%)",
                                      number(out * (curve->in_m3 ? 1e6 : 100), 2)));
    if (const auto& fit = curve->fit) {
      box.facts.push_back(fact_or_blank("t₁₀₀, t₉₀, t₅₀ (min)",
                                        fmt::format("{}, {}, {}", minutes(fit->t100_s),
                                                    minutes(fit->t90_s), minutes(fit->t50_s))));
      if (const auto& d = stored.summary.consolidation.diameter_m)
        box.facts.push_back(fact_or_blank(
            "c_v = π D²/(λ t₁₀₀)",
            fmt::format("{} m²/year (λ = {:g})",
                        plain(study::coefficient_of_consolidation(*d, at, fit->t100_s) * 31557600),
                        factors.lambda)));
    } else {
      box.facts.push_back(fact_or_blank("t₁₀₀, c_v", "none: " + curve->why_no_fit));
    }
  } else {
    box.facts.push_back(fact_or_blank("t₁₀₀", {}));
    box.facts.push_back(fact_or_blank("c_v", {}));
  }
  const bool drained = values.drainage == lab::Drainage::open;
  box.facts.push_back(fact_or_blank(
      "rate allowed",
      values.allowed_rate_per_s ? rate_words(values.allowed_rate_per_s, height) : std::string()));
  box.facts.push_back(fact_or_blank("rate used, mean", rate_words(values.rate_per_s, height)));
  if (values.allowed_rate_per_s)
    box.lines.push_back(fmt::format("allowed: ε_f H/(F t₁₀₀), F = {:g} ({}, {})",
                                    drained ? factors.drained : factors.undrained,
                                    drained ? "drained" : "undrained", to_string(at)));
  if (values.consolidation && values.consolidation->fit && !values.options.boundary_is_said)
    box.lines.push_back(fmt::format("drained at {}: assumed", to_string(at)));
  return box;
}

SheetBox failure_box(const SheetTest& test) {
  const auto& values = test.values;
  SheetBox box{.title = "Failure " + failure_words(values.options), .columns = 2};
  if (!values.failure) {
    box.lines.push_back("none: " + values.failure_reason);
    return box;
  }
  const auto& s = values.failure->state;
  box.facts = {
      fact_or_blank("q_f (kPa)", kPa(s.q)),
      fact_or_blank("ε₁ (%)", in_percent(if_known(s.strain.axial))),
      fact_or_blank("p′ (kPa)", kPa(s.p_eff)),
      fact_or_blank("ε_v (%)", in_percent(if_known(s.volumetric_strain))),
      fact_or_blank("σ₁′ (kPa)", kPa(s.effective_stress.axial)),
      fact_or_blank("u (kPa)", kPa(s.pore_pressure)),
      fact_or_blank("σ₃′ (kPa)", kPa(s.effective_stress.radial)),
      fact_or_blank("e", number(if_known(s.void_ratio), 3)),
      fact_or_blank("σ₁′/σ₃′",
                    number(if_known(s.effective_stress.axial / s.effective_stress.radial), 3)),
      fact_or_blank("η = q/p′", number(if_known(s.eta()), 3)),
      fact_or_blank("φ′ (°), c′ = 0", in_degrees(if_known(s.phi_mob_rad()), 1))};
  if (values.start) {
    const double du = s.pore_pressure - values.start->state.pore_pressure;
    const double dq = s.q - values.start->state.q;
    box.facts.push_back(values.drainage == lab::Drainage::closed
                            ? fact_or_blank("A_f = Δu/Δq", number(if_known(du / dq), 3))
                            : fact_or_blank("Δu (kPa)", kPa(du)));
  }
  if (std::isfinite(s.time_s) && values.start)
    box.facts.push_back(fact_or_blank("time to failure",
                                      duration(if_known(s.time_s - values.start->state.time_s))));
  box.facts.push_back(fact_or_blank("reading", fmt::format("{}", s.reading)));
  if (!values.failure_reason.empty()) box.lines.push_back(values.failure_reason);
  const auto& stored = test.result.stored;
  if (stored.summary.cyclic)
    for (auto& line : cyclic_lines(*stored.summary.cyclic)) box.lines.push_back(std::move(line));
  else if (holds_q(stored) &&
           values.options.failure == study::FailureCriterion::peak_deviator_stress)
    box.lines.emplace_back(
        "q is held constant: its largest value is not a failure (use --failure peak-ratio or "
        "strain)");
  return box;
}

/// "η 0.731 to 0.752 with 95 %; detected at reading 330, 33.0 s; 5 readings later"
std::string known_and_interval(const lab::Instant& at,
                               const std::optional<lab::Moment>& detected_at) {
  std::string line = detected_line(at, detected_at);
  if (!at.interval) return line;
  return fmt::format("η {:.3f} to {:.3f} with 95 %; {}", at.interval->eta.low,
                     at.interval->eta.high, line);
}

SheetBox verdict_box(const SheetTest& test) {
  const auto& stored = test.result.stored;
  const auto& collapse = stored.summary.collapse;
  SheetBox box{.title = "Collapse", .marked = study::has_verdict(stored) && collapse.detected()};
  box.facts.push_back({"result", {verdict_line(stored)}});
  if (const auto onset = study::collapse_onset(stored)) {
    box.facts.push_back(
        {"onset of instability",
         {instant(*onset), known_and_interval(*onset, collapse.onset_detected_at)}});
    box.facts.push_back({"limit surface", {inside_limit_surface_or_reason(collapse)}});
  } else if (const auto at = study::failure_onset(stored)) {
    box.facts.push_back({"strength lost from", {instant(*at)}});
  }
  if (const auto& lost = collapse.loss_of_control) {
    box.facts.push_back(
        {"loss of control",
         {instant(*lost), known_and_interval(*lost, collapse.loss_of_control_detected_at)}});
  }
  std::string criteria;
  for (const auto& c : collapse.criteria)
    criteria += fmt::format("{}{}: {}", criteria.empty() ? "" : "; ", spaced(c.name),
                            !c.detected   ? "not assessed"
                            : *c.detected ? "yes"
                                          : "no");
  if (!criteria.empty()) box.facts.push_back({"criteria", {criteria}});
  return box;
}

SheetBox deviations_box(const SheetTest& test) {
  SheetBox box{.title = test.result.stored.header.is_total_stress()
                            ? "Deviations from ISO 17892-8, ASTM D2850"
                            : "Deviations from ISO 17892-9, ASTM D4767/D7181, BS 1377-8"};
  for (const auto& sentence : study::deviations_of(test.result.stored, test.values, test.words))
    box.lines.push_back("– " + sentence);
  if (box.lines.empty()) box.lines.emplace_back("none found in the record");
  return box;
}

SheetBox remarks_box(const SheetTest& test) {
  SheetBox box{.title = "Mode of failure and remarks"};
  box.facts.push_back(fact_or_blank("Mode of failure", study::word_of(test.words, "failure_mode")));
  const auto remarks = study::word_of(test.words, "remarks");
  box.facts.push_back(fact_or_blank("Remarks", remarks));
  constexpr std::size_t kMostWarnings = 3, kLongest = 170;
  const auto warnings = study::warnings(test.result.stored);
  for (std::size_t i = 0; i < std::min(warnings.size(), kMostWarnings); ++i) {
    auto text = warnings[i];
    if (text.size() > kLongest) {
      auto cut = text.rfind(' ', kLongest);
      text = text.substr(0, cut == std::string::npos ? kLongest : cut) + " …";
    }
    box.lines.push_back("– " + text);
  }
  if (warnings.size() > kMostWarnings)
    box.lines.push_back(fmt::format("– and {} more: triax report {}",
                                    warnings.size() - kMostWarnings, test.result.stored.id));
  box.blank_lines = 1;
  return box;
}

}  // namespace triax::src
