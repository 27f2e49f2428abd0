// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/soil/limit.hpp"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>

namespace triax::bench {
namespace {

struct Stresses {
  double q = 0, radial = 0;
  double axial() const { return radial + q; }
  double eta() const { return std::abs(q) / (radial + q / 3); }
};

Stresses read_by(Spoilt spoilt, Stresses s) {
  if (spoilt == Spoilt::load_cell) s.q *= kSpoiltForce;
  if (spoilt == Spoilt::cell_pressure) s.radial += kSpoiltCellPressure;
  return s;
}

}  // namespace

SpoiltSize size_of(Spoilt spoilt, bool strength_set, const std::vector<lab::State>& truth,
                   const OwnScatter& own) {
  if (spoilt == Spoilt::void_ratio) return {kSpoiltVoidRatio / own.void_ratio, 2};
  if (truth.empty()) return {0, 1};
  const auto eta = [](const lab::State& s) { return s.p_eff > 0 ? std::abs(s.q) / s.p_eff : 0; };
  const auto failure = std::ranges::max_element(truth, {}, eta);
  const Stresses is{failure->q, failure->effective_stress.radial}, read = read_by(spoilt, is);
  if (!(is.eta() > 0 && read.eta() > 0)) return {0, 1};  // a test that the law refused at once
  if (!strength_set) return {std::abs(std::log(read.eta() / is.eta())) / own.strength, 1};
  // Beside the line through what is true, of which K is a little less than σ₁′/σ₃′.
  const double expected = is.axial() * read.radial / is.radial;
  return {std::abs(std::log(read.axial() / expected)) / own.strength, 2};
}

double could_be_named(const SpoiltSize& size, int n, int alike, double level) {
  if (alike < size.numbers + 2) return 0;
  const boost::math::normal normal;
  const double z = boost::math::quantile(boost::math::complement(normal, level / (2 * n)));
  const double d = size.deviations / std::sqrt(1 + size.numbers / (alike - 1.0));
  return boost::math::cdf(boost::math::complement(normal, z - d)) +
         boost::math::cdf(normal, -z - d);
}

}  // namespace triax::bench
