// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/sheet/test_sheet.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "src/study/version.hpp"
#include "src/triaxial/sheet/corrections_box.hpp"
#include "src/triaxial/sheet/sheet_boxes.hpp"
#include "src/triaxial/sheet/sheet_figures.hpp"
#include "src/triaxial/sheet/total_stress_sheet.hpp"

namespace triax::src {
namespace {

void add_figures(Sheet& sheet, std::vector<SheetFigure> figures) {
  const std::size_t first = figures.size() > 3 ? (figures.size() + 1) / 2 : figures.size();
  SheetRow row;
  for (std::size_t i = 0; i < figures.size(); ++i) {
    if (i == first) sheet.rows.push_back(std::exchange(row, {}));
    row.parts.push_back({.plot = std::move(figures[i].drawing.plot)});
  }
  if (!row.parts.empty()) sheet.rows.push_back(std::move(row));
}

std::string mark_of(const db::StoredTest& test) {
  std::string mark = test.header.origin == lab::Origin::simulated ? "SIMULATED" : "";
  if (test.status != db::TestStatus::complete)
    mark += std::string(mark.empty() ? "" : ", ") +
            (test.status == db::TestStatus::running ? "RUNNING" : "INTERRUPTED");
  return mark;
}

void add_last_boxes(Sheet& sheet, const SheetTest& test) {
  sheet.rows.push_back(row_of_boxes({{1, corrections_box(test)}}));
  sheet.rows.push_back(row_of_boxes({{1, deviations_box(test)}, {1, remarks_box(test)}}));
}

}  // namespace

bool holds_q(const db::StoredTest& test) {
  const auto& type = test.header.programme;
  return type == "CSD" || type == "CSU" ||
         std::ranges::any_of(test.header.stages, [](const lab::StageInfo& stage) {
           return stage.control == lab::AxialControl::constant_q;
         });
}

std::string kind_of_test(const SheetTest& test) {
  const auto& stored = test.result.stored;
  if (stored.header.is_unconfined()) return "Unconfined compression test";
  if (stored.header.is_total_stress()) return "Unconsolidated undrained triaxial test";
  if (stored.summary.cyclic) return "Cyclic triaxial test";
  for (const auto& stage : stored.header.stages)
    if (stage.strain_path_R)
      return fmt::format("Strain-path triaxial test, R = {:.3g}", *stage.strain_path_R);
  if (holds_q(stored))
    return test.values.drainage == lab::Drainage::closed ? "Constant-shear undrained test"
                                                         : "Constant-shear drained test";
  switch (test.values.drainage) {
    case lab::Drainage::closed:
      return "Consolidated undrained triaxial test";
    case lab::Drainage::open:
      return "Consolidated drained triaxial test";
    case lab::Drainage::unknown:
      break;
  }
  return "Triaxial test, drainage unknown";
}

std::string failure_words(const study::SheetOptions& options) {
  switch (options.failure) {
    case study::FailureCriterion::peak_deviator_stress:
      break;
    case study::FailureCriterion::peak_stress_ratio:
      return "at the largest σ₁′/σ₃′";
    case study::FailureCriterion::axial_strain:
      return fmt::format("at ε₁ = {:.4g} %", options.failure_strain * 100);
    case study::FailureCriterion::critical_state:
      return "at the critical state";
  }
  return "at the largest q";
}

std::string sheet_footer(const db::StoredTest& test) {
  std::string text =
      fmt::format("triax {}; test {}, stored {}", study::version(), test.id, test.stored_at);
  const auto& header = test.header;
  if (!header.source.empty())
    text += "; " + header.source.substr(header.source.find_last_of("/\\") + 1);
  if (!header.digest.empty()) text += fmt::format(" (SHA-256 {}…)", header.digest.substr(0, 16));
  if (header.seed) text += fmt::format("; seed {}", *header.seed);
  return text + "; " + (header.is_total_stress() ? "□ failure" : kSheetLegend);
}

Sheet test_sheet(const SheetTest& test) {
  const auto& stored = test.result.stored;
  Sheet sheet{.title = kind_of_test(test),
              .subject = stored.header.name,
              .mark = mark_of(stored),
              .footer = sheet_footer(stored)};
  sheet.rows.push_back(row_of_boxes({{1, head_box(test)}}));
  if (stored.header.is_total_stress()) {
    for (auto& row : total_stress_rows(test)) sheet.rows.push_back(std::move(row));
    add_last_boxes(sheet, test);
    return sheet;
  }
  sheet.rows.push_back(row_of_boxes(
      {{1, specimen_box(test)}, {1.2, saturation_box(test)}, {1.15, consolidation_box(test)}}));
  add_figures(sheet, sheet_figures(test));
  sheet.rows.push_back(row_of_boxes({{1.1, failure_box(test)}, {1.1, verdict_box(test)}}));
  if (auto circle = circle_part(test); circle.plot) {
    circle.share = 0.7;
    auto& parts = sheet.rows.back().parts;
    parts.insert(parts.begin() + 1, std::move(circle));
  }
  add_last_boxes(sheet, test);
  return sheet;
}

}  // namespace triax::src
