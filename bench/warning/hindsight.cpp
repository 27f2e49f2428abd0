// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/warning/hindsight.hpp"

#include <algorithm>
#include <cmath>

#include "lab/measured/path_sampler.hpp"
#include "lab/warning/driven_fit.hpp"

namespace triax::bench {
namespace {

constexpr double kTenth = 0.1;

}  // namespace

Hindsight::Hindsight(const AlarmTest& test)
    : test_(test),
      then_s_(*test.truth->time_s - kTenth * test.trial.stage_s),
      volume_(test.header.specimen) {}

lab::SessionListener Hindsight::listener() {
  lab::SessionListener listener;
  listener.scanned = [this](const lab::Reading&, const lab::State& measured) {
    if (measured.time_s > then_s_ || !lab::complete(measured)) return;
    const lab::StageInfo* stage = test_.header.stage(measured.stage);
    const lab::State state = volume_.with_fluid(measured, stage);
    if (!lab::is_watched(stage)) return;
    if (stage_ != state.stage) path_.start_stage(stage, true, volume_);
    stage_ = state.stage;
    path_.add(state);
  };
  return listener;
}

Members Hindsight::members() const {
  const auto& means = path_.means();
  const bool on_path = path_.control() == lab::DrivenPath::Control::strain_path;
  Members all;
  for (const double reach : kReaches)
    for (const int terms : {3, 4}) {
      std::optional<double> root, second;
      if (means.size() > 8) {
        const double now = means.back().eta;
        const double distance = std::max(test_.trial.eta - now, 0.005);
        const auto first = std::min<std::size_t>(
            static_cast<std::size_t>(std::ranges::find_if(means,
                                                          [&](const lab::PathMean& m) {
                                                            return m.eta >=
                                                                   now - (reach - 1) * distance;
                                                          }) -
                                     means.begin()),
            means.size() - 8);
        if (auto fit = lab::fit_driven(means, first, now, distance, terms)) {
          if (on_path)
            fit->give_way(path_.compliance() * std::sqrt(means.back().p), path_.ratio(),
                          path_.in_extension() ? -1 : 1);
          const auto eta = [&](std::optional<double> xi) {
            return xi ? std::optional(now + *xi * distance) : std::nullopt;
          };
          root = eta(fit->root());
          second = eta(on_path ? fit->root_of_slope() : fit->root_of_work());
        }
      }
      all.insert(all.end(), {root, second});
    }
  if (path_.in_extension())
    for (auto& eta : all)
      if (eta) eta = -*eta;
  return all;
}

}  // namespace triax::bench
