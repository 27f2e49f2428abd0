// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/verdicts/traits.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace triax::bench {
namespace {

using lab::Quantity;

void cut(SimulatedTest& test, std::size_t size) {
  test.readings.resize(size);
  test.states.resize(size);
  if (test.lost && *test.lost >= size) test.lost.reset();
}

bool by_displacement(const SimulatedTest& test, std::size_t at) {
  const lab::StageInfo* stage = test.header.stage(test.readings[at].stage);
  return stage && stage->control == lab::AxialControl::displacement && !stage->strain_path_R;
}

bool as_recorded(SimulatedTest&, std::uint64_t) { return true; }

/// The record stops before the specimen does: at 30 to 80 % of what there was of shear until then.
bool ends_early(SimulatedTest& test, std::uint64_t seed) {
  const std::size_t until = test.lost.value_or(test.readings.size());
  const double share = 0.3 + 0.5 * choice(seed, 10);
  const auto kept = static_cast<std::size_t>(share * static_cast<double>(until - test.shear));
  if (kept < 10) return false;
  cut(test, test.shear + kept);
  return true;
}

/// The record stops some readings after the loss, with a fifth of q gone at least.
bool ends_soon_after(SimulatedTest& test, std::uint64_t) {
  if (!test.lost || test.header.programme == "CYC") return false;  // there q falls in each cycle
  const double q = std::fabs(test.states[*test.lost].q);
  for (std::size_t i = *test.lost; i < test.states.size(); ++i)
    if (std::fabs(test.states[i].q) < 0.8 * q) {
      cut(test, std::min(i + 3, test.readings.size()));
      return true;
    }
  return false;
}

/// Half a step of an ordinary instrument either way, so that no sensor looks dead.
void add_noise(lab::Reading& reading, std::uint64_t seed, std::size_t i) {
  struct Noise {
    Quantity quantity;
    double size;
  };
  static constexpr auto kNoise = std::to_array<Noise>({{Quantity::axial_displacement, 1e-6},
                                                       {Quantity::axial_force, 0.5},
                                                       {Quantity::cell_pressure, 100},
                                                       {Quantity::back_pressure, 100},
                                                       {Quantity::pore_pressure, 100},
                                                       {Quantity::back_volume, 1e-9}});
  for (std::size_t k = 0; k < kNoise.size(); ++k)
    reading[kNoise[k].quantity] += kNoise[k].size * (choice(seed, 1000 + 8 * i + k) - 0.5);
}

/// Stands from reading `at` on for `count` readings, in which q falls by `share` a decade.
void stand(SimulatedTest& test, std::size_t at, std::size_t count, double share,
           std::uint64_t seed) {
  const auto where = static_cast<std::ptrdiff_t>(at);
  const double step = test.readings[at].time_s - test.readings[at - 1].time_s;
  std::vector<lab::Reading> rest(count, test.readings[at]);
  std::vector<lab::State> states(count, test.states[at]);
  for (std::size_t i = 0; i < count; ++i) {
    const double fall = share * std::log10(2.0 + static_cast<double>(i));
    add_noise(rest[i], seed, i);
    rest[i].time_s += step * static_cast<double>(i + 1);
    rest[i][Quantity::axial_force] *= 1 - fall;
    states[i].time_s = rest[i].time_s;
    states[i].volumetric_strain += 2e-6 * (choice(seed, 4000 + 8 * i) - 0.5);
    states[i].pore_pressure += 100 * (choice(seed, 3000 + 8 * i) - 0.5);
    states[i].strain.axial += 1e-5 * (choice(seed, 2000 + 8 * i) - 0.5);
    const double lost_q = fall * states[i].q;
    states[i].q -= lost_q;
    states[i].p_eff -= lost_q / 3;
    states[i].effective_stress.axial -= lost_q;
  }
  for (std::size_t i = at + 1; i < test.readings.size(); ++i) {
    test.readings[i].time_s += step * static_cast<double>(count);
    test.states[i].time_s = test.readings[i].time_s;
  }
  test.readings.insert(test.readings.begin() + where + 1, rest.begin(), rest.end());
  test.states.insert(test.states.begin() + where + 1, states.begin(), states.end());
  for (std::size_t i = 0; i < test.readings.size(); ++i)
    test.readings[i].number = test.states[i].reading = static_cast<std::int64_t>(i);
  if (test.lost && *test.lost > at) *test.lost += count;
}

/// The drive stops where the test ends, and the logger goes on.
bool relaxes_at_the_end(SimulatedTest& test, std::uint64_t seed) {
  const std::size_t last = test.readings.size() - 1;
  if (!by_displacement(test, last) || last < test.shear + 20) return false;
  stand(test, last, static_cast<std::size_t>(20 + 300 * choice(seed, 20)),
        0.02 + 0.03 * choice(seed, 21), seed);
  return true;
}

/// Three times the drive stands for a while.
bool pauses(SimulatedTest& test, std::uint64_t seed) {
  const std::size_t until = test.lost.value_or(test.readings.size() - 1);
  if (until < test.shear + 80 || !by_displacement(test, until)) return false;
  for (const double share : {0.75, 0.5, 0.25}) {
    const auto at =
        test.shear + static_cast<std::size_t>(share * static_cast<double>(until - test.shear));
    if (!by_displacement(test, at)) continue;
    stand(test, at, static_cast<std::size_t>(10 + 40 * choice(seed, 30)),
          0.02 + 0.03 * choice(seed, 31), seed);
  }
  return true;
}

/// The back-pressure controller holds its volume instead of its pressure, which follows u.
bool holds_volume(SimulatedTest& test, std::uint64_t) {
  bool any = false;
  for (lab::Reading& reading : test.readings) {
    const lab::StageInfo* stage = test.header.stage(reading.stage);
    if (!stage || stage->role != lab::StageRole::shear || stage->drainage != lab::Drainage::closed)
      continue;
    reading[Quantity::back_pressure] = reading[Quantity::pore_pressure];
    any = true;
  }
  return any;
}

void leave_out(SimulatedTest& test, Quantity quantity) {
  std::erase(test.header.columns, quantity);
  for (lab::Reading& reading : test.readings) reading[quantity] = lab::kMissing;
}

bool without_back_pressure(SimulatedTest& test, std::uint64_t) {
  leave_out(test, Quantity::back_pressure);
  return true;
}

bool load_cell_not_zeroed(SimulatedTest& test, std::uint64_t seed) {
  const double diameter = *test.header.specimen.diameter_m;
  const double area = std::numbers::pi / 4 * diameter * diameter;
  const double offset = (choice(seed, 40) < 0.5 ? -1 : 1) * 5e3 * area;
  for (std::size_t i = 0; i < test.readings.size(); ++i) {
    test.readings[i][Quantity::axial_force] += offset;
    test.states[i].q += offset / area;
    test.states[i].p_eff += offset / area / 3;
  }
  return true;
}

bool coarse_steps(SimulatedTest& test, std::uint64_t) {
  struct Step {
    Quantity quantity;
    double size;
  };
  for (const Step& step : {Step{Quantity::axial_displacement, 1e-5},
                           {Quantity::axial_force, 1},
                           {Quantity::cell_pressure, 1e3},
                           {Quantity::back_pressure, 1e3},
                           {Quantity::pore_pressure, 1e3},
                           {Quantity::back_volume, 1e-8}})
    for (lab::Reading& reading : test.readings)
      reading[step.quantity] = std::round(reading[step.quantity] / step.size) * step.size;
  return true;
}

/// Whether a fifth of q is gone after the loss.
bool shows_the_loss(const SimulatedTest& test) {
  const double q = std::fabs(test.states[*test.lost].q);
  return std::any_of(test.states.begin() + static_cast<std::ptrdiff_t>(*test.lost),
                     test.states.end(),
                     [q](const lab::State& s) { return std::fabs(s.q) < 0.8 * q; });
}

/// 20 to 60 rows of shear, as somebody reads them off: spaced along the curves of q and of u over
/// the axial strain.
bool few_rows(SimulatedTest& test, std::uint64_t seed) {
  constexpr std::size_t kFewest = 20;
  if (test.header.programme == "CYC") return false;
  const std::size_t size = test.readings.size();
  const auto rows = static_cast<std::size_t>(kFewest + 40 * choice(seed, 50));
  if (size < test.shear + 4 * rows) return false;
  SimulatedTest thin = test;
  thin.readings.clear();
  thin.states.clear();
  lab::State low = test.states[test.shear], high = low;
  for (std::size_t i = test.shear; i < size; ++i) {
    const lab::State& s = test.states[i];
    low.q = std::min(low.q, s.q), high.q = std::max(high.q, s.q);
    low.p_eff = std::min(low.p_eff, s.p_eff), high.p_eff = std::max(high.p_eff, s.p_eff);
  }
  const double strains = std::fabs(test.states.back().strain.axial - low.strain.axial);
  lab::State last = test.states[test.shear];
  const auto way = [&](std::size_t i) {
    const lab::State& s = test.states[i];
    const double gone = std::hypot((s.strain.axial - last.strain.axial) / strains,
                                   (s.q - last.q) / (high.q - low.q),
                                   (s.p_eff - last.p_eff) / (high.p_eff - low.p_eff));
    if (gone < 0.01) return 0.0;  // noise
    last = s;
    return gone;
  };
  double whole = 0, done = 0;
  for (std::size_t i = test.shear + 1; i < size; ++i) whole += way(i);
  last = test.states[test.shear];
  std::optional<std::size_t> lost;
  std::size_t kept = 0;
  for (std::size_t i = test.shear; i < size; ++i) {
    if (i > test.shear) done += way(i);
    if (test.lost && i >= *test.lost && !lost) lost = thin.readings.size();
    if (done < whole * static_cast<double>(kept) / static_cast<double>(rows)) continue;
    while (done >= whole * static_cast<double>(kept) / static_cast<double>(rows)) ++kept;
    thin.readings.push_back(test.readings[i]);
    thin.states.push_back(test.states[i]);
    thin.readings.back().number = thin.states.back().reading =
        static_cast<std::int64_t>(thin.readings.size() - 1);
  }
  thin.shear = 0;
  thin.lost = lost && *lost < thin.readings.size() ? lost : std::nullopt;
  if (thin.states.size() < kFewest || test.lost.has_value() != thin.lost.has_value()) return false;
  if (thin.lost && !shows_the_loss(thin)) return false;
  test = std::move(thin);
  return true;
}

constexpr auto kTraits = std::to_array<Trait>({
    {"as recorded", as_recorded},
    {"ends early", ends_early},
    {"ends soon after the loss", ends_soon_after},
    {"late end with relaxation", relaxes_at_the_end},
    {"pauses", pauses},
    {"volume-held controller", holds_volume},
    {"no back pressure", without_back_pressure},
    {"load cell not zeroed", load_cell_not_zeroed},
    {"coarse resolution", coarse_steps},
    {"20 to 60 rows", few_rows},
});

}  // namespace

std::span<const Trait> traits() { return kTraits; }

}  // namespace triax::bench
