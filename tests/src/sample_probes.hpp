// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Probes of INL2, S28-general, e = 1.086, whose cones are printed.
#include "src/study/probe/run_probe.hpp"

namespace triax::src::test {

inline study::ProbeRequest inl2_request(const std::vector<double>& etas,
                                        const study::Probing& probing = {}, bool figures = false,
                                        double p_kPa = 70) {
  study::GivenStates states{.stress_kPa = {}, .void_ratio = 1.086};
  for (const double eta : etas)
    states.stress_kPa.push_back(study::triaxial_stress(p_kPa, eta * p_kPa));
  return {.material = lab::find_material("inl2/S28-general"),
          .states = std::move(states),
          .probing = probing,
          .figures = figures};
}

inline study::ProbeResult inl2_probes(const std::vector<double>& etas,
                                      const study::Probing& probing = {}) {
  return study::run_probe(inl2_request(etas, probing));
}

/// What a test had at its collapse, where its own increment had this angle.
inline study::TestedState tested(double angle) {
  study::TestedState test{.id = 26, .name = "CSU\n26", .at = "collapse"};
  test.state.reading = 812;
  test.state.time_s = 41;
  test.increment = lab::MeasuredIncrement{
      .angle = angle, .angle_error = 0.01, .normalised = -0.02, .normalised_error = 0.03};
  return test;
}

/// A state that a test was in, whose own increment had this angle.
inline study::ProbedState inl2_tested(double eta, const study::TestedState& test) {
  const auto set = lab::find_material("inl2/S28-general");
  auto states = study::states_to_probe<sim::Axisymmetric>(set, inl2_request({eta}).states).states;
  states.front().test = test;
  return study::probe_state(set, states.front(), {});
}

}  // namespace triax::src::test
