// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/replay/import_summary.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "src/output/table.hpp"
#include "src/output/words.hpp"

namespace triax::src {
namespace {

/// Numbers of the shear stages; of all stages if none has this role.
struct Course {
  std::int64_t rows = 0;
  double first_time_s = lab::kMissing, last_time_s = lab::kMissing;
  double first_strain = lab::kMissing, last_strain = lab::kMissing;
  double first_p_eff = lab::kMissing;
  double peak_q = lab::kMissing, peak_strain = lab::kMissing;

  void add_time(double time_s) {
    if (std::isnan(time_s)) return;
    if (std::isnan(first_time_s)) first_time_s = time_s;
    last_time_s = time_s;
  }
  void add(const lab::State& state) {
    const double strain = state.strain.axial;
    if (std::isnan(first_strain)) first_strain = strain;
    if (!std::isnan(strain)) last_strain = strain;
    if (std::isnan(first_p_eff)) first_p_eff = state.p_eff;
    if (std::isnan(state.q) || std::fabs(state.q) <= std::fabs(peak_q)) return;
    peak_q = state.q;
    peak_strain = strain;
  }
};

bool has_shear(const lab::RecordHeader& header) {
  return std::ranges::any_of(header.stages, [](const lab::StageInfo& stage) {
    return stage.role == lab::StageRole::shear;
  });
}

Course course_of(lab::RecordedRig& record, const lab::ReductionOptions& options) {
  lab::Reduction reduction(record.header(), options);
  const bool only_shear = has_shear(record.header());
  Course course;
  lab::Reading reading;
  while (record.next(reading)) {
    ++course.rows;
    course.add_time(reading.time_s);
    const lab::StageInfo* stage = record.header().stage(reading.stage);
    const lab::State state = reduction.reduce(reading);
    if (!only_shear || (stage && stage->role == lab::StageRole::shear)) course.add(state);
  }
  return course;
}

/// "stage 1 shear, closed; ..."
std::string stages_text(const lab::RecordHeader& header) {
  const auto drainage = [](const lab::StageInfo& stage) {
    if (stage.drainage == lab::Drainage::open) return "drained";
    return stage.drainage == lab::Drainage::closed ? "undrained" : "unknown";
  };
  if (header.is_total_stress()) return "total stresses, " + header.programme;
  std::string out;
  for (const lab::StageInfo& stage : header.stages) {
    if (!out.empty()) out += "; ";
    if (header.stages.size() > 1)
      out += fmt::format("stage {} {} ", stage.number, to_string(stage.role));
    out += drainage(stage);
  }
  return out;
}

}  // namespace

std::string import_summary(lab::RecordedRig& record, const lab::ReductionOptions& options) {
  const Course course = course_of(record, options);
  const lab::RecordHeader& header = record.header();
  const std::string time = header.has_time
                               ? fmt::format("{} from the first to the last",
                                             duration(course.last_time_s - course.first_time_s))
                               : "no column of time";
  Table table{{{"Read so"}, {""}}, {}};
  table.rows = {
      {"Rows", fmt::format("{}", course.rows)},
      {"Time", time},
      {"Axial strain", fmt::format("{} to {}", with_unit(in_percent(course.first_strain), "%"),
                                   with_unit(in_percent(course.last_strain), "%"))},
      {"p' at the start", with_unit(in_kPa(course.first_p_eff), "kPa")},
      {"Peak of q", fmt::format("{} at {}", with_unit(in_kPa(course.peak_q), "kPa"),
                                with_unit(in_percent(course.peak_strain), "%"))},
      {"Drainage", stages_text(header)}};
  return to_text(table);
}

}  // namespace triax::src
