// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Differences between doubles in units in the last place, and small integers packed into one.
#include <bit>
#include <cstdint>
#include <limits>

namespace triax::db {

/// Doubles in their order as integers: neighbours differ by 1, and −0 lies just below +0.
constexpr std::int64_t ordinal(double value) {
  const auto bits = std::bit_cast<std::int64_t>(value);
  return bits >= 0 ? bits : ~(bits & std::numeric_limits<std::int64_t>::max());
}
constexpr double from_ordinal(std::int64_t n) {
  return std::bit_cast<double>(n >= 0 ? n : (~n | std::numeric_limits<std::int64_t>::min()));
}
/// How many representable numbers lie from `from` up to `to`; both finite. Wraps for numbers that
/// are further apart than an integer can say, which never looks like a small distance.
constexpr std::int64_t ulps_between(double from, double to) {
  return static_cast<std::int64_t>(static_cast<std::uint64_t>(ordinal(to)) -
                                   static_cast<std::uint64_t>(ordinal(from)));
}
constexpr double moved_by_ulps(double from, std::int64_t ulps) {
  return from_ordinal(ordinal(from) + ulps);
}

/// A signed field of `width` bits at `shift` in a packed integer.
struct BitField {
  int shift = 0;
  int width = 1;

  constexpr bool holds(std::int64_t n) const {
    const std::int64_t limit = std::int64_t{1} << (width - 1);
    return n >= -limit && n < limit;
  }
  constexpr std::int64_t packed(std::int64_t n) const {
    return (n & ((std::int64_t{1} << width) - 1)) << shift;
  }
  constexpr std::int64_t get(std::int64_t all) const {
    const auto raised = static_cast<std::uint64_t>(all) << (64 - shift - width);
    return static_cast<std::int64_t>(raised) >> (64 - width);
  }
};

}  // namespace triax::db
