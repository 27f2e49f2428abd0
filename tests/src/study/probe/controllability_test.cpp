// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/probe/controllability.hpp"
#include "src/probe/control_text.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <variant>

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
sim::PointState<Space> state_of(const sim::Law<Space>& law, double p_kPa, double eta, double e) {
  const double p = 1e3 * p_kPa;
  const auto stress =
      sim::components(sim::AxisymmetricStress{p * (1 + 2 * eta / 3), p * (1 - eta / 3)});
  if constexpr (Space::kSize == 2)
    return law.start(stress, e);
  else
    return law.start(sim::as_tensor(stress), e);
}

template <class Space>
Seen at(const std::string& material, double eta, const std::vector<double>& R = {1.0}) {
  const auto set = lab::find_material(material);
  const sim::Law<Space>& law = *set.material.law<Space>();
  const auto state = state_of(law, 70, eta, 1.086);
  const auto response = std::make_shared<const sim::IncrementalResponse<Space>>(law, state);
  const auto circle = sim::probe_circle(sim::make_prober(response, sim::ProbeKind::stress));
  return {study::control_of(*response, circle.least, R), circle};
}

template <class Space>
study::Controllability control_at(const sim::IncrementalResponse<Space>& response) {
  const auto shared = std::make_shared<const sim::IncrementalResponse<Space>>(response);
  const auto prober = sim::make_prober(shared, sim::ProbeKind::stress);
  return study::control_of(response, sim::probe_circle(prober).least, {});
}

/// The rate of the stress increment ±(1, R), asked of the law under mixed control.
template <class Space>
sim::PointRate<Space> own_rate(const sim::IncrementalResponse<Space>& response,
                               const sim::ControlRoot& root) {
  const double axial = std::copysign(1, std::sin(root.angle));
  if constexpr (Space::kSize == 2) {
    return response.to(sim::MixedControl<Axisymmetric>::stresses(
        sim::components(sim::AxisymmetricStress{axial, axial * root.R})));
  } else {
    sim::MixedControl<Tensor> control;
    control.stress(0, 0) = control.stress(2, 2) = 1;
    for (const int fixed : {1, 3, 4, 5}) control.strain(fixed, fixed) = 1;
    control.increment << axial, 0, axial * root.R, 0, 0, 0;
    return response.to(control);
  }
}

/// Each root against the law itself, and the limits of what control loses against the roots; how
/// many roots there are.
template <class Space>
int roots_checked(const std::string& material) {
  const auto set = lab::find_material(material);
  const auto* law = set.material.law<Space>();
  if (law == nullptr) return 0;
  int roots = 0;
  for (const double p : {100.0, 200.0, 300.0, 400.0})
    for (const double eta : {-0.6, 0.6, 0.8, 1.0, 1.2})
      for (const double e : {0.8, 0.95, 1.05}) {
        CAPTURE(material, Space::kSize, p, eta, e);
        const auto state = state_of(*law, p, eta, e);
        if (law->objection(state)) continue;
        const sim::IncrementalResponse<Space> response(*law, state);
        const auto control = control_at(response);
        for (const auto& root : control.roots) {
          const auto rate = own_rate(response, root.at);
          REQUIRE(rate.controllable);
          CHECK(std::abs(rate.normalised_work()) < sim::kVanishing);
          ++roots;
        }
        if (control.unanswered_directions > 0 || control.unanswered > 0) continue;
        // Where N+ and N- are interpolated, control folds also where no direction loses its work.
        if (std::holds_alternative<sim::InterpolatedForm<Space>>(response.response())) continue;
        const auto is_root = [&](double R) {
          return std::ranges::any_of(control.roots, [R](const auto& root) {
            return std::abs(root.at.R - R) < 1e-5 * std::max(R, 1.0);
          });
        };
        for (const auto& lost : control.lost) {
          if (lost.begins) CHECK(is_root(lost.from));
          if (lost.ends) CHECK(is_root(lost.to));
        }
      }
  return roots;
}

}  // namespace

TEST_CASE("INL2 has no root before it loses control, whatever octolinear with its moduli has") {
  const auto control = at<Axisymmetric>("inl2/S28-general", 0.55).control;
  CHECK(control.roots.empty());
  CHECK(control.lost.empty());
  CHECK(*control.symmetric_determinant > 0);
  CHECK(src::roots_in_words(control) == "no real root");
  CHECK(src::lost_in_words(control) == "held for R 0.05 to 5, loading and unloading");
  // Frozen in zone (-, -) its moduli have two, 0.254 and 1.341: those of octolinear.
  CHECK(at<Axisymmetric>("octolinear/S28-general", 0.55).control.roots.size() == 2);
  // Just beyond, half the Hessian has its determinant below zero with the least W2.
  const auto beyond = at<Axisymmetric>("inl2/S28-general", 0.58).control;
  CHECK(beyond.roots.size() == 2);
  CHECK(*beyond.symmetric_determinant < 0);
  CHECK(beyond.compliance == "half the Hessian of W2 in the least direction");
}

TEST_CASE("where stress control has no answer in some directions, roots are those of the others") {
  const auto set = lab::find_material("hypoplastic/Karlsruhe-HG99");
  const auto& law = *set.material.axisymmetric;
  const sim::IncrementalResponse<Axisymmetric> response(law, state_of(law, 300, 1.2, 0.80));
  const auto control = control_at(response);
  CHECK(control.unanswered_directions > 30);
  REQUIRE(control.roots.size() == 1);  // not R 0.4785, where the answers end at W2 0.497
  CHECK(control.roots[0].at.R == Approx(0.3786).margin(1e-4));
  CHECK(control.lost.at(0).from == Approx(control.roots[0].at.R).epsilon(1e-6));
  const auto words = src::roots_in_words(control);
  CHECK(words.find("in the directions with a result") != std::string::npos);
}

TEST_CASE("a root of any law at any state has no second-order work in its own direction") {
  int all = 0;
  for (const char* name :
       {"inl2/S28-general", "octolinear/S28-general", "sanisand/S28-general", "hypoplastic/S28-MT",
        "hypoplastic/Karlsruhe-HG99", "hypoplastic/Toyoura-HG99", "cam_clay/Hostun-like",
        "norsand/S28-MT", "drucker_prager/Hostun-loose", "mohr_coulomb/Hostun-loose"})
    all += roots_checked<Axisymmetric>(name) + roots_checked<Tensor>(name);
  CHECK(all > 200);
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
  CHECK(src::roots_in_words(at<Tensor>("octolinear/S28-general", 0.3).control) == "no real root");
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
  CHECK(src::lost_in_words(control) == "unknown, no result for any R");
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
