#include "lab/collapse/onset_refiner.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace triax::lab {
namespace {

constexpr double kGrowth = std::numbers::sqrt2;

}  // namespace

void OnsetRefiner::begin(double reading, Witness witness, const PathHistory& history) {
  *this = OnsetRefiner();
  active_ = true;
  witness_ = witness;
  centre_ = reading;
  last_age_ = history.last_reading() - reading;
  sweep(history, history.last_reading());
}

void OnsetRefiner::follow(const PathHistory& history) {
  if (!active_) return;
  const double age = history.last_reading() - centre_;
  if (age < kGrowth * last_age_) return;
  last_age_ = age;
  const double before = best_ ? best_->error : std::numeric_limits<double>::infinity();
  sweep(history, history.last_reading());
  if (best_ && best_->error >= before) ++idle_;
  if (idle_ >= 2) active_ = false;
}

void OnsetRefiner::finish(const PathHistory& history, double last_reading) {
  if (active_) {
    best_.reset();
    sweep(history, last_reading);
  }
  active_ = false;
}

void OnsetRefiner::sweep(const PathHistory& history, double last_reading) {
  for (int pass = 0; pass < 2; ++pass) {
    const double age = std::max(last_reading - centre_, 8.0);
    const double centre = std::min(centre_, last_reading - 8);
    for (double right = age; right > age / 9; right /= kGrowth)
      for (double left = right; left < 4.1 * right; left *= kGrowth)
        try_window(centre - left, centre + right, history);
  }
}

void OnsetRefiner::try_window(double first, double last, const PathHistory& history) {
  const auto fit = fit_onset(history.between(first, last), witness_, centre_);
  if (!fit || (best_ && best_->error <= fit->error)) return;
  best_ = fit;
  centre_ = fit->point.reading;
}

}  // namespace triax::lab
