// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/collapse/fall_watch.hpp"

#include <catch2/catch.hpp>
#include <vector>

using namespace triax::lab;

namespace {

RecordHeader header_of(AxialControl control) {
  RecordHeader h;
  h.stages = {{.number = 1,
               .name = "shear",
               .role = StageRole::shear,
               .drainage = Drainage::closed,
               .control = control,
               .strain_path_R = {}}};
  return h;
}

/// Reading, strain in % and q in kPa.
State state_of_fall(std::int64_t reading, double strain, double q) {
  State s;
  s.reading = reading;
  s.time_s = 10.0 * static_cast<double>(reading);
  s.stage = 1;
  s.strain = {strain / 100, -strain / 200};
  s.q = q * 1e3;
  s.effective_stress = {100e3 + s.q, 100e3};
  s.pore_pressure = 300e3;
  s.p_eff = 100e3 + s.q / 3;
  return s;
}

struct Told {
  std::int64_t from, known;
};
/// A stage of 60 readings that creeps and is loaded on, then what is given.
std::optional<Told> told(AxialControl control, double q_per_reading,
                         const std::vector<std::pair<double, double>>& then) {
  FallWatch watch(header_of(control));
  std::optional<Told> first;
  std::int64_t reading = 0;
  const auto add = [&](double strain, double q) {
    const auto fall = watch.watch(state_of_fall(reading, strain, q));
    if (fall && !first) first = Told{fall->instant.reading, reading};
    ++reading;
  };
  for (int i = 0; i < 60; ++i) add(0.005 * i, 40 + q_per_reading * i);
  for (const auto& [strain, q] : then) add(strain, q);
  return first;
}

const auto kLoad = AxialControl::load, kHeldQ = AxialControl::constant_q;

}  // namespace

TEST_CASE("a fall under a load or a held q is known at its second reading") {
  const std::vector<std::pair<double, double>> fall = {{16, 34}, {16, 34}, {16, 34}};
  for (const auto control : {kLoad, kHeldQ}) {
    const auto found = told(control, 0, fall);
    REQUIRE(found);
    CHECK(found->from == 59);
    CHECK(found->known == 61);
  }
  // A load that stays on an area that grows takes q down with it.
  CHECK(told(kLoad, 0, {{1.5, 39.5}, {3, 38.9}}));
  CHECK_FALSE(told(AxialControl::displacement, 0, fall));
}

TEST_CASE("a spike of the displacement is no fall") {
  CHECK_FALSE(told(kLoad, 0, {{16, 34}, {0.3, 40}, {0.305, 40}}));
  CHECK_FALSE(told(kHeldQ, 0, {{16, 40}, {0.3, 40}, {0.305, 40}}));
}

TEST_CASE("a step of the load that the specimen carries is no fall, and the next fall is known") {
  std::vector<std::pair<double, double>> step;
  for (int i = 0; i < 40; ++i) step.emplace_back(1.3 + 0.005 * i, 60);
  CHECK_FALSE(told(kLoad, 0, step));
  step.emplace_back(9, 57);
  step.emplace_back(9, 57);
  const auto found = told(kLoad, 0, step);
  REQUIRE(found);
  CHECK(found->from == 99);
  CHECK(found->known == 101);
}

TEST_CASE("a specimen that quickens below half a per cent has not been lost") {
  std::vector<std::pair<double, double>> quick;
  for (int i = 1; i <= 6; ++i) quick.emplace_back(0.3 + 0.06 * i, 40);
  for (int i = 1; i <= 30; ++i) quick.emplace_back(0.66 + 0.005 * i, 40);
  CHECK_FALSE(told(kHeldQ, 0, quick));
}
