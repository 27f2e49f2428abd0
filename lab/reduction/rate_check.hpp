// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <cstdint>
#include <optional>

#include "lab/results/reading.hpp"
#include "lab/results/state.hpp"
#include "lab/results/summary.hpp"

namespace triax::lab {

/// The pore-pressure transducer against the controller in drained shear, Darve et al. (2007),
/// section 2.1: what stands between them is the pressure that drives the water out, so that a large
/// difference means that the test runs faster than the specimen drains. Measured is the largest
/// |u − u_b − (u − u_b)_rest| / p′, of means over kMean readings; the difference at rest is that of
/// the end of consolidation, else that of the first reading of the shear. Judged up to the onset of
/// collapse, after which u rises for another reason.
class RateCheck {
 public:
  /// Usual practice asks that the excess pore pressure of a drained test stays below some 5 % of
  /// the effective stress; the paper gives no figure.
  static constexpr double kLimit = 0.05;
  static constexpr int kMean = 16;

  /// `rest_difference` is (u − u_b) at the end of consolidation, empty if unknown.
  void add(const Reading& reading, const State& state, bool drained_shear,
           std::optional<double> rest_difference);
  /// Empty where no drained shear with both sensors was seen before reading `before`.
  std::optional<Check> check(std::optional<std::int64_t> before) const;

 private:
  struct Maximum {
    std::int64_t reading = 0;
    double ratio = 0;
    double difference_pa = 0;
  };
  // A maximum is kept where it is a tenth above the one before: a few dozen reach from a thousandth
  // of p′ to all of it.
  std::array<Maximum, 96> maxima_{};
  std::size_t kept_ = 0;
  std::optional<std::int64_t> first_;  ///< reading of the first mean
  std::optional<double> at_start_;     ///< u − u_b of the first reading
  int count_ = 0;
  double difference_sum_ = 0, p_sum_ = 0;
};

}  // namespace triax::lab
