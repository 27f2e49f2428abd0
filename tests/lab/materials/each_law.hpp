// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Every shipped set of every law, for tests of what all of them must hold: a new law is covered as
// soon as its parameter file is there.
#include <catch2/catch.hpp>
#include <map>
#include <string>

#include "lab/materials/material_library.hpp"
#include "sim/point/point_driver.hpp"

namespace triax::lab::test {

inline constexpr double kPressure = 100e3;  // Pa

/// The loosest state of a few that the law admits at this stress.
template <class Space>
std::optional<sim::PointState<Space>> admitted(const sim::Law<Space>& law,
                                               const sim::Vector<Space>& stress) {
  for (const double void_ratio : {1.05, 0.95, 0.85, 0.75, 0.65}) {
    auto state = law.start(stress, void_ratio);
    if (!law.objection(state)) return state;
  }
  return std::nullopt;
}

template <class Space>
sim::PointState<Space> isotropic_state(const sim::Law<Space>& law) {
  const auto state = admitted(law, sim::isotropic<Space>(kPressure));
  REQUIRE(state);
  return *state;
}

/// Calls `check` with the set and its law wherever there is one in this space.
template <class Space, class Check>
void each_law(const Check& check) {
  int found = 0;
  for (const auto& set : shipped_materials()) {
    INFO(set.name << (Space::kSize == 2 ? ", axisymmetric" : ", tensor"));
    const sim::Law<Space>* law = set.material.template law<Space>();
    if (law == nullptr) {
      WARN(set.name << " has no form in this space: " << set.material.no_tensor);
      continue;
    }
    check(set, *law);
    ++found;
  }
  REQUIRE(found > 0);
}

/// How often each law was really looked at; a test that skips states asks in the end.
class Counted {
 public:
  int& operator[](const std::string& law) { return count_[law]; }
  /// Fails for a law that has a form in the space and was never counted.
  template <class Space>
  void require_all() {
    for (const auto& set : shipped_materials()) {
      if (set.material.template law<Space>() == nullptr) continue;
      INFO(set.law->name << (Space::kSize == 2 ? ", axisymmetric" : ", tensor"));
      CHECK(count_[set.law->name] > 0);
    }
  }

 private:
  std::map<std::string, int> count_;
};

}  // namespace triax::lab::test
