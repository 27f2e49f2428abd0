// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/stability/cones.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace triax::sim {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

bool unstable(const Probe& probe) { return probe.answered && probe.normalised < kUnstable; }

/// The circle under refinement: probes by angle, all within [0, 2π).
class Refinement {
 public:
  Refinement(const Prober& prober, const CircleOptions& options)
      : prober_(prober), precision_(options.precision) {
    for (int i = 0; i < options.directions; ++i)
      probes_.push_back(prober_(kTurn * i / options.directions));
  }

  std::vector<Probe>& probes() { return probes_; }

  /// Puts the last answered direction beside every one without an answer.
  void find_limits() {
    between([](const Probe& a, const Probe& b) { return a.answered != b.answered; },
            [](const Probe& p) { return p.answered; });
  }

  /// Puts the local minima of the normalised work between the steps, and the local maxima that part
  /// a cone in two.
  void find_extrema() {
    const std::size_t n = probes_.size();
    std::vector<Probe> found;
    for (std::size_t i = 0; i < n; ++i) {
      const Probe &before = at(i + n - 1), &here = at(i), &after = at(i + 1);
      if (!before.answered || !here.answered || !after.answered) continue;
      const double from = angle(i + n - 1) - kTurn, to = angle(i + 1);
      if (here.normalised <= before.normalised && here.normalised < after.normalised)
        found.push_back(extremum(1, from, to));
      if (here.normalised < before.normalised || here.normalised <= after.normalised) continue;
      if (!unstable(here)) continue;
      if (const Probe most = extremum(-1, from, to); !unstable(most)) found.push_back(most);
    }
    insert(found);
  }

  /// Puts the last stable direction beside every edge of a cone.
  void find_edges() {
    between([](const Probe& a,
               const Probe& b) { return a.answered && b.answered && unstable(a) != unstable(b); },
            [](const Probe& p) { return p.answered && !unstable(p); });
  }

 private:
  const Probe& at(std::size_t i) const { return probes_[i % probes_.size()]; }
  /// Angle of probe i, growing beyond 2π with i.
  double angle(std::size_t i) const {
    const std::size_t turns = i / probes_.size();
    return at(i).angle + kTurn * static_cast<double>(turns);
  }

  void insert(std::vector<Probe>& found) {
    if (found.empty()) return;
    std::ranges::sort(found, {}, &Probe::angle);
    const auto circle = static_cast<std::ptrdiff_t>(probes_.size());
    probes_.insert(probes_.end(), found.begin(), found.end());
    std::ranges::inplace_merge(probes_, probes_.begin() + circle, {}, &Probe::angle);
    const auto same = [](const Probe& a, const Probe& b) { return a.angle == b.angle; };
    probes_.erase(std::unique(probes_.begin(), probes_.end(), same), probes_.end());
  }

  /// Wherever neighbours differ, inserts the last direction on the side that `wanted` names.
  template <class Differ, class Wanted>
  void between(const Differ& differ, const Wanted& wanted) {
    std::vector<Probe> found;
    for (std::size_t i = 0; i < probes_.size(); ++i) {
      if (!differ(at(i), at(i + 1))) continue;
      double in = angle(i), out = angle(i + 1);
      Probe last = at(i);
      if (!wanted(last)) {
        std::swap(in, out);
        last = at(i + 1);
      }
      while (std::abs(out - in) > precision_) {
        const double middle = (in + out) / 2;
        const Probe probe = probed(middle);
        (wanted(probe) ? in : out) = middle;
        if (wanted(probe)) last = probe;
      }
      found.push_back(last);
    }
    insert(found);
  }

  Probe probed(double angle) const {
    const double turns = std::floor(angle / kTurn);
    return prober_(angle - turns * kTurn);
  }

  /// The least of `sign` times the normalised work by golden section, on an interval with one
  /// minimum of that, as far as the square root of round-off allows.
  Probe extremum(double sign, double low, double high) const {
    const auto less = [sign](const Probe& one, const Probe& other) {
      return one.answered && sign * one.normalised < sign * other.normalised;
    };
    static const double kGolden = (std::sqrt(5.0) - 1) / 2;
    double a = high - kGolden * (high - low), b = low + kGolden * (high - low);
    Probe pa = probed(a), pb = probed(b);
    while (high - low > std::max(precision_, 1e-8)) {
      const bool lower_part = !pb.answered || less(pa, pb);
      if (lower_part) {
        high = b;
        b = a;
        pb = pa;
        pa = probed(a = high - kGolden * (high - low));
      } else {
        low = a;
        a = b;
        pa = pb;
        pb = probed(b = low + kGolden * (high - low));
      }
    }
    return less(pa, pb) ? pa : pb;
  }

  const Prober& prober_;
  double precision_;
  std::vector<Probe> probes_;
};

/// The run of unstable probes that begins at `first`.
Cone cone_from(const std::vector<Probe>& probes, std::size_t first) {
  const std::size_t n = probes.size();
  const auto at = [&](std::size_t i) -> const Probe& { return probes[i % n]; };
  const auto angle = [&](std::size_t i) {
    const std::size_t turns = i / n;
    return at(i).angle + kTurn * static_cast<double>(turns);
  };
  std::size_t last = first;
  Cone cone{.strongest = at(first)};
  for (; last - first < n && unstable(at(last)); ++last)
    if (at(last).normalised < cone.strongest.normalised) cone.strongest = at(last);
  // An edge lies at the last stable direction, or at the last that was answered.
  const Probe& before = at(first + n - 1);
  cone.from = before.answered ? angle(first + n - 1) - kTurn : angle(first);
  cone.to = at(last).answered ? angle(last) : angle(last - 1);
  if (cone.from < 0) {
    cone.from += kTurn;
    cone.to += kTurn;
  }
  return cone;
}

std::vector<Cone> cones_of(const std::vector<Probe>& probes) {
  if (std::ranges::all_of(probes, unstable))
    return {{0, kTurn, std::ranges::min(probes, {}, &Probe::normalised)}};
  std::vector<Cone> cones;
  for (std::size_t i = 0; i < probes.size(); ++i)
    if (unstable(probes[i]) && !unstable(probes[(i + probes.size() - 1) % probes.size()]))
      cones.push_back(cone_from(probes, i));
  std::ranges::sort(cones, {}, &Cone::from);
  return cones;
}

}  // namespace

bool Cone::contains(double angle) const {
  const double beyond = std::fmod(angle - from, kTurn);
  return (beyond < 0 ? beyond + kTurn : beyond) <= opening();
}

Circle probe_circle(const Prober& prober, const CircleOptions& options) {
  if (options.directions < 8) throw std::invalid_argument("a circle needs at least 8 directions");
  Refinement refinement(prober, options);
  Circle circle;
  circle.unanswered = static_cast<int>(
      std::ranges::count_if(refinement.probes(), [](const Probe& p) { return !p.answered; }));
  circle.refused = static_cast<int>(
      std::ranges::count_if(refinement.probes(), [](const Probe& p) { return p.refused; }));
  refinement.find_limits();
  refinement.find_extrema();
  refinement.find_edges();
  circle.cones = cones_of(refinement.probes());
  // Four directions of an isotropic elastic answer are alike: the first, whatever round-off says.
  constexpr double kAlike = 1e-12;
  bool any = false;
  for (const Probe& p : refinement.probes())
    if (p.answered &&
        (!std::exchange(any, true) || p.normalised < circle.least.normalised - kAlike))
      circle.least = p;
  if (options.keep_probes) circle.probes = std::move(refinement.probes());
  return circle;
}

}  // namespace triax::sim
