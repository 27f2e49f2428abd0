// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/soil/campaign.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bench/soil/limit.hpp"
#include "bench/soil/sands.hpp"
#include "bench/soil/virtual_test.hpp"
#include "lab/collapse/monitor.hpp"
#include "lab/devices/noise.hpp"
#include "lab/programmes/programme_reader.hpp"

namespace triax::bench {
namespace {

constexpr std::uint64_t kPlanStream = 901, kSpecimenStream = 902, kCalibrationStream = 903;
constexpr double kOwnLine = 0.005, kOwnFriction = 0.01;

double uniform(std::uint64_t seed, std::uint64_t number, double low, double high) {
  return low + (high - low) * lab::standard_uniform(seed, kPlanStream, number);
}

/// q at its largest, where the specimen can be held no longer by its load: undrained and
/// displacement-controlled, second-order work vanishes there.
std::optional<double> true_onset(const std::vector<lab::State>& states) {
  const auto peak = std::ranges::max_element(states, {}, &lab::State::q);
  if (peak == states.end() || states.end() - peak < 3) return std::nullopt;
  return peak->eta();
}

void judge(study::ShearedTest& test) {
  lab::RecordHeader header;
  header.name = test.name;
  header.stages = {{.number = 1,
                    .name = "shear",
                    .role = lab::StageRole::shear,
                    .drainage = test.drainage,
                    .control = lab::AxialControl::displacement}};
  lab::CollapseMonitor monitor(header);
  for (const auto& s : test.states) monitor.watch(s);
  const lab::Collapse collapse = monitor.finish();
  if (!collapse.judged) return;
  test.collapse = collapse.kind;
  if (collapse.detected()) test.onset = collapse.onset;
}

/// Test i of the campaign.
TestPlan plan_of(const Campaign& c, std::uint64_t seed, std::uint64_t i, double strain) {
  TestPlan plan{.axial_strain = strain};
  plan.p_eff_pa = 50e3 * std::pow(10.0, uniform(seed, 100 + 4 * i, 0, 1));
  if (c.sand == Sand::mohr_coulomb) {
    plan.axial_strain = 0.1;
    return plan;
  }
  plan.undrained = uniform(seed, 101 + 4 * i, 0, 1) < 0.5;
  plan.extension = c.sand == Sand::sanisand && uniform(seed, 102 + 4 * i, 0, 1) < 0.35;
  const double psi = plan.undrained ? uniform(seed, 103 + 4 * i, 0.02, 0.12)
                                    : uniform(seed, 103 + 4 * i, -0.15, 0.1);
  plan.void_ratio = c.truth.critical_void_ratio(plan.p_eff_pa / 1e3) + psi;
  return plan;
}

}  // namespace

std::vector<InstrumentClass> instrument_classes() {
  std::vector<InstrumentClass> classes;
  for (const auto& [name, error] :
       {std::pair("ideal", 0.001), std::pair("advanced", 0.004), std::pair("standard", 0.008)}) {
    const auto programme = lab::load_programme(
        "samples/programmes/icu_42.toml",
        {{"rig.instruments", name}, {"rig.transducers.axial_force.range_N", "10000"}});
    classes.push_back({name, programme.transducers, error});
  }
  return classes;
}

std::string to_string(Sand sand) {
  constexpr std::array names = {"NorSand, e over ln p'", "NorSand, power line", "SANISAND",
                                "Mohr-Coulomb"};
  return names.at(static_cast<std::size_t>(sand));
}

std::string to_string(Spoilt spoilt) {
  constexpr std::array names = {"none", "void ratio 0.08 off", "load cell reads 15 % high",
                                "cell pressure reads 25 kPa high"};
  return names.at(static_cast<std::size_t>(spoilt));
}

Campaign make_campaign(std::uint64_t seed, Sand sand, const InstrumentClass& instruments,
                       Spoilt spoilt) {
  const VirtualSand virtual_sand = draw_sand(sand, seed);
  Campaign c{.sand = sand,
             .instruments = instruments.name,
             .truth = virtual_sand.truth,
             .tests = {},
             .spoilt = spoilt,
             .spoilt_test = {}};
  const double strain = uniform(seed, 0, 0.15, 0.30);
  const int count = sand == Sand::mohr_coulomb ? 3 + static_cast<int>(uniform(seed, 1, 0, 6))
                                               : 4 + static_cast<int>(uniform(seed, 1, 0, 17));
  std::array<double, lab::kRawQuantityCount> calibration{};
  for (std::size_t i = 0; i < calibration.size(); ++i)
    calibration[i] = 2 * lab::standard_uniform(seed, kCalibrationStream, i) - 1;
  c.truth.onset = [virtual_sand, strain](double psi, double p_kPa) -> std::optional<double> {
    const TestPlan plan{.undrained = true,
                        .p_eff_pa = p_kPa * 1e3,
                        .void_ratio = virtual_sand.truth.critical_void_ratio(p_kPa) + psi,
                        .axial_strain = strain};
    return true_onset(true_states(*virtual_sand.law({.undrained = true}), plan));
  };
  SpoiltSize spoilt_size;
  bool spoilt_extension = false;
  int in_extension = 0;
  const auto spoilt_index = static_cast<std::uint64_t>(uniform(seed, 2, 0, count));
  for (std::uint64_t i = 0; i < static_cast<std::uint64_t>(count); ++i) {
    const TestPlan plan = plan_of(c, seed, i, strain);
    const Specimen specimen{
        .void_ratio_shift = kOwnLine * lab::standard_normal(seed, kSpecimenStream, 3 * i),
        .friction_factor =
            1 + kOwnFriction * lab::standard_normal(seed, kSpecimenStream, 3 * i + 1),
        .undrained = plan.undrained};
    const bool this_one = spoilt != Spoilt::none && i == spoilt_index;
    study::ShearedTest test{.id = static_cast<std::int64_t>(i) + 1,
                            .name = fmt::format("T{}", i + 1)};
    test.drainage = plan.undrained ? lab::Drainage::closed : lab::Drainage::open;
    test.void_ratio = plan.void_ratio + instruments.void_ratio_error *
                                            lab::standard_normal(seed, kSpecimenStream, 3 * i + 2);
    if (this_one && spoilt == Spoilt::void_ratio) *test.void_ratio += kSpoiltVoidRatio;
    // As the same instruments have it.
    test.p_eff_pa =
        plan.p_eff_pa + (this_one && spoilt == Spoilt::cell_pressure ? kSpoiltCellPressure : 0.0);
    const auto truth = true_states(*virtual_sand.law(specimen), plan);
    test.states = measured_states(truth, instruments.transducers, calibration, 1000 * seed + i,
                                  this_one ? spoilt : Spoilt::none);
    if (plan.undrained) judge(test);
    if (this_one) {
      c.spoilt_test = test.name;
      c.spoilt_drained = !plan.undrained;
      spoilt_size = size_of(spoilt, sand == Sand::mohr_coulomb, truth,
                            {std::hypot(kOwnLine, instruments.void_ratio_error), kOwnFriction});
      spoilt_extension = plan.extension;
    }
    in_extension += plan.extension;
    c.tests.push_back(std::move(test));
  }
  c.spoilt_deviations = spoilt_size.deviations;
  const int same_way = spoilt_extension ? in_extension : count - in_extension;
  c.could_be_named =
      could_be_named(spoilt_size, count, spoilt == Spoilt::void_ratio ? count : same_way);
  return c;
}

}  // namespace triax::bench
