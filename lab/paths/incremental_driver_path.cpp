// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/paths/incremental_driver_path.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "lab/base/text.hpp"
#include "lab/paths/inp_step.hpp"

namespace triax::lab {
namespace {

using Segment = sim::Segment<sim::Tensor>;
using Vector = sim::Vector<sim::Tensor>;

constexpr int kMostRowsOfCommand = 10'000;
constexpr std::size_t kMostSegments = 100'000;
constexpr int kMostSides = 20'000;
constexpr int kMostRepetitions = 1'000'000;

Segment segment_of(const InpStep& step, const Vector& change, int rows) {
  Segment segment;
  segment.name = step.keyword;
  segment.conditions = step.conditions;
  segment.conditions.increment = change;
  segment.labels = step.labels;
  segment.end = step.end;
  segment.rows = std::clamp(rows, 1, kMostRowsOfCommand);
  return segment;
}

/// Instants, in periods, between which the path of an oscillation is straight: its turning points
/// where all components move together, else as many as the file has increments (kMostSides at
/// most).
std::vector<double> corners(const InpStep& step, double start) {
  std::vector<double> instants{start};
  bool together = step.conditions.increment.isZero(0);
  std::optional<double> phase;
  for (int i = 0; i < 6; ++i) {
    if (step.amplitude(i) == 0) continue;
    together = together && phase.value_or(step.phase(i)) == step.phase(i);
    phase = step.phase(i);
  }
  if (together) {
    const double first = 0.25 - std::fmod(phase.value_or(0) / (2 * std::numbers::pi), 1);
    for (int half = -4; half <= 8; ++half) {
      const double turn = first + 0.5 * half;
      if (turn > start + 1e-9 && turn < start + 1 - 1e-9) instants.push_back(turn);
    }
  } else {
    const int sides = std::min(step.increments, kMostSides);
    for (int i = 1; i < sides; ++i) instants.push_back(start + static_cast<double>(i) / sides);
  }
  instants.push_back(start + 1);
  return instants;
}

void append(const InpStep& step, double start, std::vector<Segment>& segments) {
  const int rows = (step.increments + step.every - 1) / step.every;
  if (step.circulating) {
    const auto instants = corners(step, std::fmod(start / step.duration, 1));
    const auto swing = [&step](double at) {
      return Vector(step.amplitude.array() *
                    (2 * std::numbers::pi * at + step.phase.array()).sin());
    };
    for (std::size_t i = 1; i < instants.size(); ++i) {
      const double share = instants[i] - instants[i - 1];
      segments.push_back(segment_of(
          step, swing(instants[i]) - swing(instants[i - 1]) + share * step.conditions.increment,
          static_cast<int>(std::lround(share * rows))));
    }
  } else if (!step.imported.empty()) {
    for (const Vector& change : step.imported) segments.push_back(segment_of(step, change, 1));
  } else {
    segments.push_back(segment_of(step, step.conditions.increment, rows));
  }
}

/// A group of steps done `repetitions` times, the first of them at `time`, which is moved on.
void append_group(const std::vector<InpStep>& group, int repetitions, double& time,
                  const InpLines& lines, std::vector<Segment>& segments) {
  const auto limit = [&] {
    if (segments.size() > kMostSegments)
      lines.fail(fmt::format("the loading has more than {} straight pieces", kMostSegments));
  };
  double duration = 0;
  for (const InpStep& step : group) duration += std::max(step.duration, 0.0);
  const bool in_phase = std::ranges::all_of(group, [&](const InpStep& step) {
    if (!step.circulating) return true;
    const double periods = duration / step.duration;
    return std::abs(periods - std::round(periods)) < 1e-9 * periods;
  });
  const std::size_t first = segments.size();
  for (int round = 0; round < (in_phase ? 1 : repetitions); ++round) {
    double at = time + round * duration;
    for (const InpStep& step : group) {
      append(step, at, segments);
      limit();
      at += std::max(step.duration, 0.0);
    }
  }
  if (in_phase && repetitions > 1) {
    segments.back().repeat = repetitions;
    segments.back().repeat_from = first;
  }
  time += repetitions * duration;
}

}  // namespace

std::vector<Segment> read_inp_steps(InpLines& lines, const InpFile& file,
                                    std::vector<std::string>& files,
                                    std::vector<std::string>& warnings) {
  std::vector<Segment> segments;
  double time = 0;
  while (const auto line = lines.next()) {
    const std::string keyword = folded(inp_before(*line, "?#!"));
    if (keyword.empty()) continue;
    if (keyword == "*end") break;
    int repetitions = 1;
    std::vector<InpStep> group;
    if (keyword == "*repetition") {
      const auto counts = lines.numbers(2, "the number of steps and of repetitions");
      const int steps = lines.as_whole(counts[0], "the number of steps", 1, 1000);
      repetitions = lines.as_whole(counts[1], "the number of repetitions", 1, kMostRepetitions);
      for (int i = 0; i < steps; ++i)
        group.push_back(
            read_inp_step(lines.required("a step to be repeated"), lines, file, files, warnings));
    } else {
      group.push_back(read_inp_step(*line, lines, file, files, warnings));
    }
    append_group(group, repetitions, time, lines, segments);
  }
  if (segments.empty()) lines.fail("no step is given; a step begins with *LinearLoad");
  return segments;
}

}  // namespace triax::lab
