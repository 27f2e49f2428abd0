// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/sheet/set_sheet.hpp"

#include <fmt/format.h>
#include <qcustomplot.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "src/output/words.hpp"
#include "src/study/triaxial/read_again.hpp"
#include "src/study/version.hpp"
#include "src/triaxial/facts/verdict_fact.hpp"
#include "src/triaxial/sheet/set_figure.hpp"
#include "src/triaxial/sheet/sheet_figures.hpp"
#include "src/triaxial/sheet/test_sheet.hpp"
#include "src/triaxial/sheet/total_stress_sheet.hpp"

namespace triax::src {
namespace {

constexpr std::size_t kMinCircles = 3;
constexpr double kMinSpread = 1.5;  // of σ₃′ at failure, largest over least

std::string kind_word(const db::StoredTest& test) {
  return spaced(verdict_word(test.status, study::has_verdict(test)
                                              ? std::optional(test.summary.collapse.kind)
                                              : std::nullopt));
}

/// A column of numbers of a set: as it reads, and its value of a test.
struct SetColumn {
  std::string heading;
  int decimals;
  std::optional<double> (*value)(const SheetTest&);
};

template <class Member>
std::optional<double> at_failure(const SheetTest& test, Member member) {
  return test.values.failure ? if_known(member(test.values.failure->state)) : std::nullopt;
}

const std::vector<SetColumn>& set_columns() {
  static const std::vector<SetColumn> kColumns = {
      {"e₀", 3, [](const SheetTest& t) { return study::void_ratio(t.result.stored); }},
      {"B", 2, [](const SheetTest& t) { return t.result.stored.summary.consolidation.b_value; }},
      {"p′₀", 0,
       [](const SheetTest& t) {
         const auto& p = t.result.stored.summary.consolidation.p_eff_pa;
         return p ? std::optional(*p * 1e-3) : std::nullopt;
       }},
      {"rate (%/h)", 2,
       [](const SheetTest& t) {
         const auto& rate = t.values.rate_per_s;
         return rate ? std::optional(*rate * 3600 * 100) : std::nullopt;
       }},
      {"ε₁ (%)", 2,
       [](const SheetTest& t) {
         return at_failure(t, [](const lab::State& s) { return s.strain.axial * 100; });
       }},
      {"q", 1,
       [](const SheetTest& t) {
         return at_failure(t, [](const lab::State& s) { return s.q * 1e-3; });
       }},
      {"σ₁′", 1,
       [](const SheetTest& t) {
         return at_failure(t, [](const lab::State& s) { return s.effective_stress.axial * 1e-3; });
       }},
      {"σ₃′", 1,
       [](const SheetTest& t) {
         return at_failure(t, [](const lab::State& s) { return s.effective_stress.radial * 1e-3; });
       }},
      {"u", 1,
       [](const SheetTest& t) {
         return at_failure(t, [](const lab::State& s) { return s.pore_pressure * 1e-3; });
       }},
      {"η", 3, [](const SheetTest& t) {
         return at_failure(t, [](const lab::State& s) { return s.eta(); });
       }}};
  return kColumns;
}

std::string blank_if_unknown(const std::optional<double>& value, int decimals) {
  return value ? number(value, decimals) : std::string();
}

SheetBox specimens_box(const TestSet& set) {
  SheetBox box{.title = fmt::format("Specimens; failure {}; stresses in kPa",
                                    failure_words(set.tests.front()->values.options))};
  box.table.columns = {{"test"}, {"type"}};
  for (const auto& column : set_columns())
    box.table.columns.push_back({column.heading, Align::right});
  box.table.columns.push_back({"collapse", Align::right});
  box.table.columns.push_back({"η at onset", Align::right});
  box.table.columns.push_back({"at loss of control", Align::right});
  for (const auto* test : set.tests) {
    const auto& stored = test->result.stored;
    std::vector<std::string> row = {
        stored.header.name + (stored.header.origin == lab::Origin::simulated ? " (simulated)" : ""),
        stored.header.programme};
    for (const auto& column : set_columns())
      row.push_back(blank_if_unknown(column.value(*test), column.decimals));
    const auto onset = study::collapse_onset(stored);
    row.push_back(kind_word(stored));
    row.push_back(blank_if_unknown(onset ? onset->eta() : std::nullopt, 3));
    const auto& lost = stored.summary.collapse.loss_of_control;
    row.push_back(blank_if_unknown(lost ? lost->eta() : std::nullopt, 3));
    box.table.rows.push_back(std::move(row));
  }
  return box;
}

/// Of many tests: the least, the median, the largest of each number; how many came to what.
SheetBox spread_box(const TestSet& set) {
  SheetBox box{.title = fmt::format("{} specimens; failure {}; stresses in kPa", set.tests.size(),
                                    failure_words(set.tests.front()->values.options))};
  box.table.columns = {{"of all tests"},         {"known of", Align::right},
                       {"least", Align::right},  {"5 %", Align::right},
                       {"median", Align::right}, {"95 %", Align::right},
                       {"largest", Align::right}};
  for (const auto& column : set_columns()) {
    std::vector<double> values;
    for (const auto* test : set.tests)
      if (const auto value = column.value(*test)) values.push_back(*value);
    if (values.empty()) continue;
    std::ranges::sort(values);
    std::vector<std::string> row = {column.heading, fmt::format("{}", values.size())};
    for (const double share : {0.0, 0.05, 0.5, 0.95, 1.0})
      row.push_back(number(values[static_cast<std::size_t>(
                               std::lround(share * static_cast<double>(values.size() - 1)))],
                           column.decimals));
    box.table.rows.push_back(std::move(row));
  }
  std::map<std::string, int> kinds;
  for (const auto* test : set.tests) ++kinds[kind_word(test->result.stored)];
  std::string line;
  for (const auto& [kind, count] : kinds)
    line += fmt::format("{}{} {}", line.empty() ? "collapse: " : ", ", count, kind);
  box.lines.push_back(line);
  const auto drawn = drawn_of_many(set.tests.size()).size();
  box.lines.push_back(drawn < set.tests.size()
                          ? fmt::format("bands hold nine of ten tests, lines are medians; of paths "
                                        "and circles {} are drawn",
                                        drawn)
                          : "bands hold nine of ten tests, lines are medians");
  box.lines.emplace_back(
      "the table of each test: triax report --format json; a page a test: --each");
  return box;
}

struct Strength {
  std::vector<study::MohrCircle> circles;
  std::optional<study::StrengthSet> set;
  int at_constant_q = 0;  ///< left out: their largest q is no failure
};

Strength strength_of(const TestSet& set) {
  Strength strength;
  for (const auto* test : set.tests) {
    if (!test->values.failure || test->result.stored.summary.cyclic) continue;
    if (test->values.options.failure == study::FailureCriterion::peak_deviator_stress &&
        holds_q(test->result.stored)) {
      ++strength.at_constant_q;
      continue;
    }
    const auto& s = test->values.failure->state.effective_stress;
    if (!(std::max(s.axial, s.radial) > std::min(s.axial, s.radial))) continue;
    strength.circles.push_back({strength.circles.size(), test->result.stored.header.name,
                                std::max(s.axial, s.radial) * 1e-3,
                                std::min(s.axial, s.radial) * 1e-3});
  }
  const auto [least, most] =
      std::ranges::minmax_element(strength.circles, {}, &study::MohrCircle::minor_kPa);
  if (strength.circles.size() >= kMinCircles && most->minor_kPa > kMinSpread * least->minor_kPa)
    strength.set = study::strength_set(strength.circles, set.tests.front()->values.options.failure);
  return strength;
}

SheetBox strength_box(const TestSet& set, const Strength& strength) {
  SheetBox box{.title = "Strength of the set, " + failure_words(set.tests.front()->values.options),
               .columns = 3};
  if (strength.set) {
    const auto& [c, phi] = std::pair(strength.set->cohesion_kPa, strength.set->friction_angle_deg);
    box.facts = {
        {"c′ (kPa)", {fmt::format("{:.1f} ({:.1f} to {:.1f})", c.value, c.low, c.high)}},
        {"φ′ (°)", {fmt::format("{:.1f} ({:.1f} to {:.1f})", phi.value, phi.low, phi.high)}}};
    if (const auto& without = strength.set->friction_angle_without_cohesion_deg)
      box.facts.push_back({"φ′ with c′ = 0 (°)",
                           {fmt::format("{:.1f} ({:.1f} to {:.1f})", without->value, without->low,
                                        without->high)}});
    box.lines.push_back(fmt::format(
        "common tangent of {} circles, σ₁′ = A + K σ₃′ by weighted least squares; in brackets 95 %",
        strength.circles.size()));
  } else {
    box.lines.push_back(
        strength.circles.size() < kMinCircles
            ? fmt::format("c′ and φ′ need {} specimens; {} failed", kMinCircles,
                          strength.circles.size())
            : "c′ and φ′: σ₃′ at failure differs by less than half of its smallest value");
  }
  if (strength.at_constant_q > 0)
    box.lines.push_back(fmt::format(
        "not used: {} at constant q, whose largest q is not a failure (use --failure peak-ratio)",
        strength.at_constant_q));
  return box;
}

SheetPart circles_part(const Strength& strength) {
  if (strength.circles.empty()) return {};
  constexpr std::size_t kMostNames = 12;
  std::vector<DrawnCircle> circles;
  for (const std::size_t i : drawn_of_many(strength.circles.size())) {
    const auto& c = strength.circles[i];
    circles.push_back(
        {strength.circles.size() <= kMostNames ? c.name : "", c.minor_kPa, c.major_kPa});
  }
  std::optional<DrawnEnvelope> envelope;
  if (strength.set)
    envelope = {strength.set->cohesion_kPa.value, strength.set->friction_angle_deg.value};
  return mohr_part(circles, envelope, 2 * kSheetFigureWidth);
}

SheetBox set_head(const TestSet& set) {
  constexpr std::size_t kHeadLabels = 14, kAlwaysPrinted = 12;
  SheetBox box{.columns = 4};
  for (const auto& [key, label] : study::sheet_word_list().first(kHeadLabels)) {
    std::vector<std::string> said;
    for (const auto* test : set.tests) {
      auto word = study::word_of(test->words, key);
      if (!word.empty() && std::ranges::find(said, word) == said.end())
        said.push_back(std::move(word));
    }
    if (said.empty() && box.facts.size() >= kAlwaysPrinted) continue;
    if (said.size() > 3) said = {said.front() + " …"};
    box.facts.push_back({std::string(label), {}});
    if (!said.empty()) box.facts.back().lines = {fmt::format("{}", fmt::join(said, ", "))};
  }
  return box;
}

/// The figures behind the first, in rows of three or, if there are four, two.
void add_rows(std::vector<SheetRow>& rows, std::vector<OwnPlot> plots) {
  std::erase(plots, nullptr);
  const std::size_t wide = plots.size() == 4 ? 2 : 3;
  for (std::size_t i = 0; i < plots.size(); ++i) {
    if (i % wide == 0) rows.emplace_back();
    rows.back().parts.push_back({.plot = std::move(plots[i])});
  }
}

std::vector<OwnPlot> set_figures(const TestSet& set) {
  std::vector<OwnPlot> plots;
  const auto strain = axial_strain_axis();
  plots.push_back(set_figure(set.tests, strain, q_axis()));
  plots.push_back(set_figure(set.tests, p_axis(), q_axis()));
  plots.push_back(set_figure(set.tests, strain, eta_axis()));
  plots.push_back(set_figure(set.tests, strain, u_axis()));
  plots.push_back(set_figure(set.tests, strain, volumetric_strain_axis()));
  plots.push_back(set_figure(set.tests, p_axis(), void_ratio_axis()));
  plots.push_back(set_consolidation_figure(set.tests));
  return plots;
}

std::vector<SheetRow> effective_stress_rows(const TestSet& set) {
  std::vector<SheetRow> rows;
  rows.push_back(
      row_of_boxes({{1, set.tests.size() > kMostCurves ? spread_box(set) : specimens_box(set)}}));
  const auto strength = strength_of(set);
  auto plots = set_figures(set);
  if (auto circles = circles_part(strength); circles.plot) {
    circles.share = 2;
    SheetRow row{.parts = {}, .weight = 1.3};
    row.parts.push_back(std::move(circles));
    if (plots.front()) row.parts.push_back({.plot = std::move(plots.front())});
    rows.push_back(std::move(row));
  }
  add_rows(rows, std::move(plots));
  rows.push_back(row_of_boxes({{1, strength_box(set, strength)}}));
  return rows;
}

}  // namespace

std::vector<TestSet> test_sets(const std::vector<SheetTest>& tests) {
  std::map<std::pair<std::string, bool>, TestSet> sets;
  std::vector<const db::StoredTest*> stored;
  stored.reserve(tests.size());
  for (const auto& test : tests) stored.push_back(&test.result.stored);
  const auto left_out = study::read_again(stored);
  for (const auto& test : tests) {
    const auto& material = test.result.stored.header.specimen.material;
    const bool total = test.result.stored.header.is_total_stress();
    TestSet& set = sets[{material, total}];
    set.material = material;
    set.total_stress = total;
    if (left_out.contains(test.result.stored.id))
      ++set.read_again;
    else
      set.tests.push_back(&test);
  }
  std::vector<TestSet> several;
  for (auto& [key, set] : sets)
    if (set.tests.size() > 1) several.push_back(std::move(set));
  return several;
}

Sheet set_sheet(const TestSet& set) {
  std::size_t simulated = 0;
  for (const auto* test : set.tests)
    if (test->result.stored.header.origin == lab::Origin::simulated) ++simulated;
  Sheet sheet{.title = fmt::format("Set of {} {}triaxial tests", set.tests.size(),
                                   set.total_stress ? "unconsolidated undrained " : ""),
              .subject = set.material.empty() ? "soil not given" : set.material,
              .footer = fmt::format("triax {}; {}", study::version(),
                                    set.total_stress ? "□ failure" : kSheetLegend)};
  if (simulated == set.tests.size())
    sheet.mark = "SIMULATED";
  else if (simulated > 0)
    sheet.mark = fmt::format("{} of {} SIMULATED", simulated, set.tests.size());
  sheet.rows.push_back(row_of_boxes({{1, set_head(set)}}));
  for (auto& row : set.total_stress ? total_stress_set_rows(set.tests) : effective_stress_rows(set))
    sheet.rows.push_back(std::move(row));
  SheetBox remarks{.title = "Remarks", .blank_lines = 2};
  if (set.read_again > 0)
    remarks.lines.push_back(fmt::format(
        "{} more: the file was READ AGAIN, the latest complete replay counts", set.read_again));
  if (set.material.empty())
    remarks.lines.emplace_back(
        "no record gives its soil: check that these specimens are of one soil");
  sheet.rows.push_back(row_of_boxes({{1, std::move(remarks)}}));
  return sheet;
}

}  // namespace triax::src
