// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/probe/controllability.hpp"
#include "src/probe/control_text.hpp"

#include <catch2/catch.hpp>

#include "lab/materials/material_library.hpp"
#include "sim/stability/cones.hpp"

using namespace triax;
using sim::Axisymmetric;
using sim::Tensor;

namespace {

struct Seen {
  study::Controllability control;
  sim::Circle circle;
};

template <class Space>
Seen at(const std::string& material, double eta, const std::vector<double>& R = {1.0}) {
  const auto set = lab::find_material(material);
  const auto stress =
      sim::components(sim::AxisymmetricStress{70e3 * (1 + 2 * eta / 3), 70e3 * (1 - eta / 3)});
  const sim::Law<Space>& law = *set.material.law<Space>();
  sim::PointState<Space> state;
  if constexpr (Space::kSize == 2)
    state = law.start(stress, 1.086);
  else
    state = law.start(sim::as_tensor(stress), 1.086);
  const auto response = std::make_shared<const sim::IncrementalResponse<Space>>(law, state);
  const auto circle = sim::probe_circle(sim::make_prober(response, sim::ProbeKind::stress));
  return {study::control_of(*response, circle.least, R), circle};
}

}  // namespace

TEST_CASE("INL2 at eta 0.55: the printed roots of Eq. (34) in zone (-, -), and its determinant") {
  const auto control = at<Axisymmetric>("inl2/S28-general", 0.55).control;
  REQUIRE(control.roots.size() == 2);
  CHECK(control.roots[0].at.R == Approx(0.2537).margin(5e-5));
  CHECK(control.roots[1].at.R == Approx(1.3407).margin(5e-5));
  CHECK(1e6 * *control.symmetric_determinant == Approx(-3.617e-9).epsilon(2e-4));
  CHECK(control.compliance.find("zone (-, -) of the octolinear law") == 0);
  CHECK(control.lost.empty());  // INL2 itself still holds every R
  CHECK(src::lost_in_words(control) == "held for R 0.05 to 5, loading and unloading");
}

TEST_CASE("the roots are the edges of the cone where the zone holds it, and control ends there") {
  for (const char* name : {"octolinear/S28-general", "sanisand/S28-general"}) {
    INFO(name);
    const auto [control, circle] = at<Axisymmetric>(name, 0.6);
    REQUIRE(circle.cones.size() == 1);
    REQUIRE(control.roots.size() == 2);
    CHECK(control.roots[0].at.angle == Approx(circle.cones[0].to).epsilon(1e-7));
    CHECK(control.roots[1].at.angle == Approx(circle.cones[0].from).epsilon(1e-7));
    REQUIRE(control.lost.size() == 1);
    CHECK(control.lost[0].from == Approx(control.roots[0].at.R).epsilon(1e-6));
    CHECK(control.lost[0].to == Approx(control.roots[1].at.R).epsilon(1e-6));
    CHECK(*control.symmetric_determinant < 0);
  }
}

TEST_CASE("undrained control by load is the control of R = 1") {
  const auto control = at<Axisymmetric>("inl2/S28-general", 0.55).control;
  REQUIRE_FALSE(control.named.empty());
  CHECK(control.named[0].name.find("undrained") == 0);
  CHECK(*control.named[0].answer.index == Approx(*control.scan[0].loading.index));
  const auto lost = at<Axisymmetric>("inl2/S28-general", 0.65).control;
  CHECK_FALSE(lost.named[0].answer.held());
  CHECK_FALSE(lost.named[0].answer.index);  // no noise of a solution that does not exist
  CHECK_FALSE(lost.scan[0].index);
  CHECK_FALSE(lost.scan[0].controllable);
  CHECK(lost.scan[0].mode.normalised < 0);
}

TEST_CASE("Eq. (35) is written with the zone that its roots lie in, and says which") {
  const auto control = at<Tensor>("octolinear/S28-general", 0.68).control;
  REQUIRE(control.roots.size() == 2);
  REQUIRE(control.lost.size() == 1);
  CHECK(control.lost[0].from == Approx(control.roots[0].at.R).epsilon(1e-6));
  CHECK(control.lost[0].to == Approx(control.roots[1].at.R).epsilon(1e-6));
  CHECK(control.compliance == "zone (-, +, -)");
  CHECK(*control.symmetric_determinant < 0);
  const std::string words = src::roots_in_words(control);
  CHECK(words.find("R 0.6286 (") == 0);
  CHECK(words.find("1/kPa), zone (-, +, -)") != std::string::npos);

  // Of two zones each root says its own.
  auto mixed = control;
  mixed.roots[1].compliance = "zone (-, -, -)";
  CHECK(src::roots_in_words(mixed).find("1/kPa, zone (-, +, -)), R 1.108 (") != std::string::npos);
  CHECK(src::roots_in_words(at<Tensor>("octolinear/S28-general", 0.3).control) ==
        "no real root in any zone");
}

TEST_CASE("of an incrementally nonlinear law the roots are where its own control ends") {
  const auto control = at<Axisymmetric>("hypoplastic/S28-MT", 0.6).control;
  REQUIRE(control.roots.size() == 2);
  REQUIRE(control.lost.size() == 1);
  CHECK(control.roots[0].at.R == Approx(control.lost[0].from).epsilon(1e-6));
  CHECK(control.roots[1].at.R == Approx(control.lost[0].to).epsilon(1e-6));
  CHECK(src::roots_in_words(control).find("tangent of its own direction") != std::string::npos);
}

TEST_CASE("elasticity holds every R, in both planes, and Eq. (34) has no real root") {
  for (const auto& control : {at<Axisymmetric>("elastic/linear", 0.5).control,
                              at<Tensor>("elastic/linear", 0.5).control}) {
    CHECK(control.lost.empty());
    CHECK(control.roots.empty());
    CHECK(*control.symmetric_determinant > 0);
    CHECK(control.compliance == "tangent of the least direction");
    CHECK(control.scan[0].index > 0);
    CHECK(control.unanswered == 0);
  }
  CHECK(at<Tensor>("elastic/linear", 0.5).control.named.empty());
  CHECK(src::roots_in_words(at<Tensor>("elastic/linear", 0.5).control).find("no real root") == 0);
}

TEST_CASE("ranges that the search cuts off say so, and tables hold a row an R") {
  study::Controllability control;
  control.lost = {{0.05, 0.5, false, true},
                  {2, 5, true, false},
                  {0.6, 0.7, false, false, sim::ControlSense::unloading}};
  CHECK(src::lost_in_words(control) ==
        "loading lost for R 0.05 (and below) to 0.5, 2 to 5 (and above); unloading lost for R 0.6 "
        "(no answer below) to 0.7 (no answer above)");
  control.asked = control.unanswered = 402;
  CHECK(src::lost_in_words(control) == "unknown, no R was answered");
  const auto seen = at<Axisymmetric>("inl2/S28-general", 0.6, {0.5, 1, 2}).control;
  const auto table = src::scan_table(seen);
  REQUIRE(table.rows.size() == 3);
  CHECK(table.rows[0][1] == "lost");
  CHECK(table.rows[0][2] == "–");
  CHECK(table.rows[0][3] == "held");
  CHECK(table.rows[2][1] == "held");
  CHECK(src::named_controls_table(seen).rows.size() == seen.named.size());
  CHECK(study::usual_ratios().front() == 0.1);
  CHECK(study::usual_ratios().back() == 3.0);
}

TEST_CASE(
    "in extension the unloading of sigma1 - sigma3/R is lost, between the roots of Eq. (34)") {
  const auto control = at<Axisymmetric>("sanisand/S28-general", -0.7).control;
  REQUIRE(control.lost.size() == 1);
  CHECK(control.lost[0].sense == sim::ControlSense::unloading);
  CHECK(control.lost[0].from == Approx(0.778).margin(1e-3));
  CHECK(control.lost[0].to == Approx(1.96).margin(5e-3));
  CHECK(src::lost_in_words(control).find("unloading lost for R 0.77") == 0);
}

TEST_CASE("any two conditions have an index, or a limiting variable") {
  const auto undrained = sim::triaxial_controls()[0];
  sim::NamedControl asked{"q_kPa = 1, volume = 0", undrained.control, {"q_kPa", "volume"}};
  const auto set = lab::find_material("inl2/S28-general");
  const auto words_at = [&](double eta) {
    const auto stress =
        sim::components(sim::AxisymmetricStress{70e3 * (1 + 2 * eta / 3), 70e3 * (1 - eta / 3)});
    const auto& law = *set.material.axisymmetric;
    const sim::IncrementalResponse<Axisymmetric> response(law, law.start(stress, 1.086));
    const auto control = study::control_of(response, {}, {1.0}, {asked});
    REQUIRE(control.conditions.size() == 1);
    CHECK(control.conditions[0].answer.held() == control.named[0].answer.held());
    return src::condition_words(control.conditions[0]);
  };
  CHECK(words_at(0.3).find("q_kPa = 1, volume = 0: held, index 0.") == 0);
  CHECK(words_at(0.65) == "q_kPa = 1, volume = 0: lost, q_kPa cannot be held");
}
