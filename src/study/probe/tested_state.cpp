// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/probe/tested_state.hpp"

#include <fmt/format.h>

#include <cmath>

#include "lab/base/bad_input.hpp"
#include "lab/base/text.hpp"
#include "src/study/triaxial/collapse_increments.hpp"
#include "src/study/triaxial/test_result.hpp"

namespace triax::study {
namespace {

bool known(const lab::State& s) {
  return std::isfinite(s.effective_stress.axial) && std::isfinite(s.effective_stress.radial);
}

/// The reading that `at` means; empty: the last with known stresses.
std::optional<std::int64_t> reading_of(const db::StoredTest& test, const std::string& at,
                                       const std::string& name,
                                       std::vector<std::string>& warnings) {
  if (at == "end") return std::nullopt;
  if (at == "peak") {
    if (test.summary.peak) return test.summary.peak->reading;
    throw lab::BadInput(fmt::format("{} has no peak of q; use --at end or --at READING", name));
  }
  if (at == "collapse") {
    if (const auto onset = collapse_onset(test)) return onset->reading;
    if (const auto onset = failure_onset(test)) {
      const bool on_limit = test.summary.collapse.inside_limit_surface == false;
      warnings.push_back(fmt::format("{} failed {}, without collapse: its onset", name,
                                     on_limit ? "on the limit surface" : "with the drainage open"));
      return onset->reading;
    }
    throw lab::BadInput(
        fmt::format("{} has no collapse; use --at peak, --at end or --at READING", name));
  }
  const auto reading = lab::whole_text_as<std::int64_t>(at);
  if (!reading || *reading < 0)
    throw lab::BadInput(fmt::format(
        "--at {}: expected collapse, peak, end or the number of a reading", lab::excerpt(at)));
  return *reading;
}

struct Readings {
  std::int64_t first = 0, last = -1;
  bool any() const { return last >= first; }
};

}  // namespace

TestedState tested_state(const db::Store& store, const std::string& test, const std::string& at,
                         const std::optional<double>& void_ratio) {
  const std::int64_t id = store.find({test}).front();
  const db::StoredTest stored = store.load(id);
  const std::string name = fmt::format("test {} ({})", id, stored.header.name);
  TestedState result{.id = id,
                     .name = stored.header.name,
                     .origin = stored.header.origin,
                     .at = at,
                     .has_time = stored.header.has_time,
                     .state = {},
                     .increment = {},
                     .warnings = {}};
  std::optional<std::int64_t> wanted = reading_of(stored, at, name, result.warnings);
  Readings readings;
  bool found = false;
  store.for_each_scan(id, 1, [&](const lab::Reading&, const lab::State& state) {
    if (!readings.any()) readings.first = state.reading;
    readings.last = state.reading;
    if (wanted ? state.reading != *wanted : !known(state)) return;
    result.state = state;
    found = true;
  });
  if (!found)
    throw lab::BadInput(wanted && readings.any()
                            ? fmt::format("{} has no reading {}; must be {} to {}", name, *wanted,
                                          readings.first, readings.last)
                            : fmt::format("{} has no reading with known effective stresses", name));
  if (!known(result.state))
    throw lab::BadInput(
        fmt::format("{} has no effective stresses at reading {}", name, result.state.reading));
  if (void_ratio) result.state.void_ratio = *void_ratio;
  if (!std::isfinite(result.state.void_ratio))
    throw lab::BadInput(fmt::format("{} has no void ratio at reading {}; give --void-ratio E", name,
                                    result.state.reading));

  const auto onset = collapse_onset(stored);
  if (onset && onset->reading == result.state.reading) {
    result.increment = increment_towards(store, stored, onset->reading);
  } else {
    lab::IncrementWatch watch(stored.header, result.state.reading);
    store.for_each_scan(id, 1,
                        [&](const lab::Reading&, const lab::State& state) { watch.watch(state); });
    result.increment = watch.finish();
  }
  if (result.increment && result.increment->has_direction()) return result;
  result.warnings.push_back(
      fmt::format("the increment of {} at reading {} is unknown: {}", name, result.state.reading,
                  result.increment ? "its direction is within the noise"
                                   : "no window of shear readings includes it"));
  result.increment.reset();
  return result;
}

std::vector<TestedState> tested_states(const std::string& db, const std::vector<std::string>& tests,
                                       const std::string& at,
                                       const std::optional<double>& void_ratio) {
  std::vector<TestedState> states;
  states.reserve(tests.size());
  const db::Store store(db);
  for (const auto& name : tests) states.push_back(tested_state(store, name, at, void_ratio));
  return states;
}

}  // namespace triax::study
