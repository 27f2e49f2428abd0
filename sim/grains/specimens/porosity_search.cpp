// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/grains/specimens/porosity_search.hpp"

#include <cmath>
#include <stdexcept>
#include <utility>

namespace triax::sim {
namespace {

/// Bracketed secant for a rising function of x; halving the kept end's value (Illinois) keeps it
/// from creeping.
class Bracket {
 public:
  Bracket(double x0, double y0, double x1, double y1) : x0_(x0), y0_(y0), x1_(x1), y1_(y1) {}

  double next() const { return x0_ - y0_ * (x1_ - x0_) / (y1_ - y0_); }
  void add(double x, double y) {
    const bool low = y < 0;
    if (low == last_low_ && again_) (low ? y1_ : y0_) *= 0.5;
    (low ? x0_ : x1_) = x;
    (low ? y0_ : y1_) = y;
    again_ = true;
    last_low_ = low;
  }

 private:
  double x0_, y0_, x1_, y1_;
  bool last_low_ = false, again_ = false;
};

class Trials {
 public:
  Trials(const Cloud& cloud, const ContactLaw& law, const Compaction& how,
         const PorositySearch& search, int threads, const GrainProgress& progress)
      : cloud_(cloud),
        law_(law),
        how_(how),
        search_(search),
        threads_(threads),
        progress_(progress) {}

  /// Porosity over what is wanted.
  double excess(double log_friction) {
    how_.friction_angle = std::exp(log_friction);
    const double part = 1.0 / search_.most_trials, before = part * found_.trials;
    Compacted one =
        compact(cloud_, law_, how_, threads_, [&](double done, const std::string& what) {
          return goes_on(progress_, before + part * done, what);
        });
    ++found_.trials;
    const double over = one.porosity - search_.porosity;
    const bool nearer = std::abs(over) < std::abs(found_.best.porosity - search_.porosity);
    if (one.stopped || !one.calm || found_.trials == 1 || nearer) {
      found_.friction_angle = how_.friction_angle;
      found_.best = std::move(one);
    }
    found_.reached = found_.best.calm && std::abs(over) <= search_.tolerance;
    return over;
  }
  bool done() const {
    return found_.reached || !found_.best.calm || found_.trials >= search_.most_trials;
  }
  PorosityFound& found() { return found_; }

 private:
  const Cloud& cloud_;
  const ContactLaw& law_;
  Compaction how_;
  const PorositySearch& search_;
  int threads_;
  const GrainProgress& progress_;
  PorosityFound found_;
};

}  // namespace

PorosityFound seek_porosity(const Cloud& cloud, const ContactLaw& law, const Compaction& how,
                            const PorositySearch& search, int threads,
                            const GrainProgress& progress) {
  if (!(search.lowest_friction > 0 && search.lowest_friction < search.highest_friction) ||
      !(search.tolerance > 0) || search.most_trials < 1)
    throw std::invalid_argument(
        "porosity search: 0 < lowest friction < highest, a tolerance above 0 and a trial are "
        "needed");
  Trials trials(cloud, law, how, search, threads, progress);
  const double low = std::log(search.lowest_friction), high = std::log(search.highest_friction);
  const double over_low = trials.excess(low);
  if (trials.done() || over_low > 0) {
    trials.found().below_bracket = !trials.found().reached && over_low > 0;
    return std::move(trials.found());
  }
  const double over_high = trials.excess(high);
  if (trials.done() || over_high < 0) {
    trials.found().above_bracket = !trials.found().reached && over_high < 0;
    return std::move(trials.found());
  }
  Bracket bracket(low, over_low, high, over_high);
  while (!trials.done()) {
    const double x = bracket.next();
    bracket.add(x, trials.excess(x));
  }
  return std::move(trials.found());
}

}  // namespace triax::sim
