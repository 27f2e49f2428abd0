// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/export/workbook/work_windows.hpp"

#include <bit>
#include <cmath>

namespace triax::src {

WorkWindows::WorkWindows(const lab::RecordHeader& header)
    : header_(header), volume_(header.specimen), sampler_(header.has_time) {
  rates_.on_point = [this](const lab::PathPoint& point) { take(point); };
}

void WorkWindows::add(const lab::State& state, std::size_t row) {
  if (!lab::complete(state)) return;
  if (!stage_ || *stage_ != state.stage) {
    end_stage();
    stage_ = state.stage;
  }
  const lab::State with = volume_.with_fluid(state, header_.stage(state.stage));
  if (!lab::is_watched(header_.stage(state.stage))) return;
  const auto sample = sampler_.sample(with);
  if (!sample) return;
  using S = lab::PathSample;
  const auto& s = sample->signal;
  close_blocks({s[S::progress], s[S::q], s[S::p_eff], s[S::axial_strain], s[S::volumetric_strain]},
               row);
  readings_.push_back(state.reading);
  rates_.add(*sample);
}

void WorkWindows::close_blocks(const Block& sample, std::size_t row) {
  rows_.push_back(row);
  Block block = sample;
  for (std::size_t level = 0;; ++level) {
    if (level == blocks_.size()) {
      blocks_.emplace_back();
      halves_.emplace_back();
      begun_.push_back(0);
    }
    auto& all = blocks_[level];
    all.push_back(block);
    if (level > 0) halves_[level].push_back(blocks_[level - 1].size() - 2);
    if ((all.size() - begun_[level]) % 2 != 0) return;
    const Block& first = all[all.size() - 2];
    for (std::size_t k = 0; k < kBlockSignals; ++k) block[k] = 0.5 * (first[k] + block[k]);
  }
}

void WorkWindows::take(const lab::PathPoint& point) {
  WorkWindow window{.reading = std::llround(point.reading)};
  window.level = std::countr_zero(
      static_cast<std::uint64_t>(point.window_readings / lab::BlockPyramid::kBlocks));
  const bool of_the_last = ending_ && !windows_.empty() && windows_.back().level == window.level;
  window.first = of_the_last ? windows_.back().first
                             : blocks(window.level).size() - lab::BlockPyramid::kBlocks;
  if (ending_)
    window.offset =
        static_cast<int>(std::lround(std::ldexp(point.reading - middle_of(window), -window.level)));
  windows_.push_back(window);
}

/// Number of the reading at the middle of a window.
double WorkWindows::middle_of(const WorkWindow& window) const {
  std::size_t first = window.first + lab::BlockPyramid::kBlocks / 2;
  for (int level = window.level; level > 0; --level) first = first_half(level, first);
  const std::size_t last = first + (std::size_t{1} << window.level) - 1;
  return (static_cast<double>(readings_[first]) + static_cast<double>(readings_[last])) / 2;
}

void WorkWindows::end_stage() {
  ending_ = true;
  rates_.finish();
  ending_ = false;
  for (std::size_t level = 0; level < blocks_.size(); ++level)
    begun_[level] = blocks_[level].size();
}

void WorkWindows::finish() { end_stage(); }

}  // namespace triax::src
