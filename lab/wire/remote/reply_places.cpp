// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/wire/remote/reply_places.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace triax::lab {
namespace {

using Range = std::pair<double, double>;

/// A range of calibrated values as the instrument says them.
Range raw_range(const Calibration& calibration, const Range& range) {
  return std::minmax({calibration.raw_of(range.first), calibration.raw_of(range.second)});
}

Range overlap(const Range& one, const Range& other) {
  return {std::max(one.first, other.first), std::min(one.second, other.second)};
}

void limit_by_channel(ReplyPlace& place, const RigChannel& channel) {
  place.name = channel.name;
  if (channel.calibration.range)
    place.calibrated = raw_range(channel.calibration, *channel.calibration.range);
  if (!channel.quantity) return;
  const QuantityInfo& row = info(*channel.quantity);
  const double largest = row.raw.absurd * sim::find_unit(row.unit)->scale / channel.scale;
  place.possible = overlap(place.possible, raw_range(channel.calibration, {-largest, largest}));
}

}  // namespace

std::vector<ReplyPlace> reply_places(const RigInstrument& instrument,
                                     const std::vector<AskedValue>& asked) {
  const Personality& personality = instrument.personality;
  std::vector<ReplyPlace> places;
  for (std::size_t i = 0; i < asked.size(); ++i) {
    ReplyPlace& place = places.emplace_back();
    place.name = asked[i].point;
    const auto& range = asked[i].point.empty()
                            ? (personality.scan ? personality.scan->range : std::nullopt)
                            : personality.at(asked[i].point).range;
    if (range) place.possible = *range;
    if (i < instrument.channels.size()) limit_by_channel(place, instrument.channels[i]);
  }
  return places;
}

}  // namespace triax::lab
