// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/calibrate/implied_domain.hpp"

#include <algorithm>
#include <atomic>
#include <stdexcept>
#include <thread>

#include "src/study/calibrate/implied_answers.hpp"
#include "src/study/calibrate/parameter_draws.hpp"

namespace triax::study {
namespace {

constexpr int kDrawsOfRates = 200, kDrawsOfFinite = 10;

Answers answers_of(const sim::Law<sim::Axisymmetric>& law, const ImpliedStates& at,
                   const std::function<bool()>& go_on) {
  Answers found;
  for (const double p : at.pressures) {
    if (!go_on()) break;
    found.compression.push_back(implied_column(law, p, at.void_ratio, kLargestRatioOfDomain));
    if (at.extension)
      found.extension.push_back(implied_column(law, p, at.void_ratio, kLeastRatioOfDomain));
    found.refusal = refused_direction(law, found.compression.back(), at.void_ratio);
    if (!found.refusal.empty()) break;  // no domain can be told, wherever else it is asked
  }
  return found;
}

}  // namespace

std::optional<ImpliedDomain> implied_domain(const Misfit& misfit, const Unknowns& x,
                                            const Uncertainty& sure, const ImpliedOptions& options,
                                            const std::function<bool(double)>& go_on) {
  const SearchSpace& space = misfit.space();
  const auto& law = space.start().material.axisymmetric;
  const bool finite = law != nullptr && law->finite();
  const ImpliedStates at = implied_states(misfit.paths(), finite);
  const int count = options.draws > 0 ? options.draws : finite ? kDrawsOfFinite : kDrawsOfRates;
  ParameterDraws drawn = draw_parameters(space, x, sure, count, options.seed);

  std::vector<Answers> all(1 + drawn.points.size());  // the best set first
  const auto caller = std::this_thread::get_id();
  std::atomic<bool> stopped = false;
  std::atomic<std::size_t> done = 0;
  const auto still = [&] {
    if (std::this_thread::get_id() == caller && !stopped &&
        !go_on(static_cast<double>(done) / static_cast<double>(all.size())))
      stopped = true;
    return !stopped;
  };
  const auto ask = [&](std::size_t k) {
    if (!still()) return;
    // Every set has a law of its own: a UMAT's process serves one thread.
    try {
      const auto material = space.material(k == 0 ? x : drawn.points[k - 1], Imposed::drained);
      if (material) all[k] = answers_of(*material->axisymmetric, at, still);
    } catch (const std::runtime_error&) {  // a plug-in that fails answers nothing
    }
    ++done;
  };
  ask(0);
  if (!all.front().refusal.empty()) drawn.points.clear();
  misfit.each(drawn.points.size(), [&](std::size_t k) { ask(k + 1); });
  if (stopped || !go_on(1)) return std::nullopt;

  ImpliedDomain found{.void_ratio = at.void_ratio,
                      .of_collapsed = at.of_collapsed,
                      .draws = static_cast<int>(drawn.points.size()),
                      .asked = count,
                      .refused = drawn.refused};
  const Answers best = std::move(all.front());
  all.erase(all.begin());
  all.resize(drawn.points.size());
  tell_answers(at, best, all, found);
  return found;
}

}  // namespace triax::study
