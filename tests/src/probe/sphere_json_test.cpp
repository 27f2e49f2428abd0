// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/probe/sphere_json.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "src/probe/sphere_figures.hpp"
#include "src/probe/sphere_text.hpp"
#include "src/study/probe/run_probe.hpp"

using namespace triax;
using nlohmann::json;

namespace {

study::SphereResult sphere_result_of(const std::string& material, const std::vector<double>& etas,
                                     const study::SphereProbing& probing = {}) {
  study::GivenStates states{.stress_kPa = {}, .void_ratio = 1.086};
  for (const double eta : etas) states.stress_kPa.push_back(study::triaxial_stress(70, 70 * eta));
  return study::run_sphere(
      {.material = lab::find_material(material), .states = states, .probing = probing});
}

}  // namespace

TEST_CASE("in space INL2 is unstable where it is in the axisymmetric plane, by as much") {
  const json d = json::parse(src::sphere_json(sphere_result_of("inl2/S28-general", {0.6})));
  CHECK(d["origin"] == "simulated");
  CHECK(d["probing"]["plane"] == "3d");
  CHECK(d["unstable_regions"] == 1);
  CHECK(d["unstable_share"].get<double>() > 0);
  CHECK(d["unstable_share"].get<double>() < 0.05);
  // -0.0833 at 228.72 degrees of the Rendulic plane
  CHECK(d["least"]["w2_normalised"].get<double>() == Approx(-0.08333).margin(1e-5));
  CHECK(d["least"]["direction"][0].get<double>() ==
        Approx(std::sin(sim::radians(228.718))).margin(1e-4));
  CHECK(d["least_of_all_components"]["w2_normalised"].get<double>() <=
        d["least"]["w2_normalised"].get<double>() + 1e-9);
  CHECK(d["least_of_all_components"]["direction"].size() == 6);
}

TEST_CASE("increments have the norm that is asked for, in the units of their keys") {
  const json d = json::parse(
      src::sphere_json(sphere_result_of("inl2/S28-general", {0.6}, {.norm = 2e3, .rings = 6})));
  CHECK(d["probes"].size() == 72);
  CHECK(d["probing"]["step_deg"] == 30.0);
  for (const auto& probe : d["probes"]) {
    double square = 0, work = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const double stress = probe["stress_kPa"][i];
      square += stress * stress;
      work += 1e3 * stress * probe["strain"][i].get<double>();
    }
    CHECK(std::sqrt(square) == Approx(2));
    CHECK(probe["w2_Pa"].get<double>() == Approx(work).margin(1e-12));
    CHECK((probe["w2_normalised"].get<double>() < 0) == (work < 0));
  }
}

TEST_CASE("elasticity is stable in every direction; several states are a list") {
  const auto result = sphere_result_of("elastic/linear", {0.2, 0.4}, {.rings = 6});
  const json d = json::parse(src::sphere_json(result));
  REQUIRE(d["states"].size() == 2);
  for (const auto& state : d["states"]) {
    CHECK(state["unstable_share"] == 0.0);
    CHECK(state["unstable_regions"] == 0);
    CHECK(state["least"]["w2_normalised"].get<double>() > 0);
  }
  CHECK(src::sphere_data(result).rows.size() == 144);
  for (const auto& row : src::sphere_data(result).rows)
    CHECK(row.size() == src::sphere_data(result).columns.size());
  CHECK(src::sphere_text(result).find("(simulated)") != std::string::npos);
  CHECK(src::sphere_drawing(result).plot);
  CHECK_FALSE(src::sphere_drawing({}).plot);
}

TEST_CASE("strain probes of space give their norm as a strain") {
  const auto result = sphere_result_of("inl2/S28-general", {0.6},
                                       {.kind = sim::ProbeKind::strain, .norm = 1e-5, .rings = 6});
  const json d = json::parse(src::sphere_json(result));
  CHECK(d["probing"]["norm_strain"] == 1e-5);
  CHECK(d["probing"]["norm_kPa"].is_null());
  double square = 0;
  for (const auto& part : d["probes"][3]["strain"]) square += std::pow(part.get<double>(), 2);
  CHECK(std::sqrt(square) == Approx(1e-5));
}
