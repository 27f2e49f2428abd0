// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/facts/guard_fact.hpp"

#include <fmt/format.h>

#include "lab/warning/warning_words.hpp"
#include "src/output/words.hpp"

namespace triax::src {
namespace {

std::string reading_and_time(const lab::Moment& at) {
  std::string told = fmt::format("reading {}", at.reading);
  if (at.time_s) told += ", " + duration(at.time_s);
  return told;
}

std::string without_line(const lab::GuardOutcome::Without& without) {
  std::string told =
      fmt::format("without it (same programme and seed): axial strain {} % at the end",
                  in_percent(without.last_axial_strain, 3));
  if (without.lost) told += ", runaway after " + reading_and_time(*without.lost);
  if (without.kind != lab::CollapseKind::none)
    told += fmt::format(", collapse: {}", spaced(std::string(to_string(without.kind))));
  return told;
}

}  // namespace

std::vector<std::string> guard_lines(const lab::GuardOutcome& guard) {
  std::vector<std::string> lines = {
      describe(guard) + ", at " + reading_and_time({guard.at.reading, guard.at.time_s}),
      fmt::format("axial strain {} % at the end", in_percent(guard.last_axial_strain, 3))};
  if (guard.without) lines.push_back(without_line(*guard.without));
  return lines;
}

}  // namespace triax::src
