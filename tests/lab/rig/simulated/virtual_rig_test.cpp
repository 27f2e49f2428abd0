// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/rig/simulated/virtual_rig.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "lab/base/bad_input.hpp"
#include "lab/programmes/programme_reader.hpp"
#include "sim/point/point_driver.hpp"
#include "tests/lab/programmes/programme_text.hpp"

using namespace triax;
using Catch::Contains;
using lab::Quantity;

namespace {

std::vector<lab::Reading> run(lab::VirtualRig& rig) {
  std::vector<lab::Reading> readings;
  for (lab::Reading reading; rig.next(reading);) readings.push_back(reading);
  return readings;
}

lab::Programme programme(const std::string& text) { return lab::read_programme(text, "p.toml"); }

lab::Programme noisy() {
  return programme(lab::test::programme_text({}, R"(back_pressure_kPa = 300.0
[rig.transducers.axial_force]
range_N = 2000.0
bits = 16
noise_N = 0.3
[rig.transducers.pore_pressure]
range_kPa = 1000.0
bits = 16
noise_kPa = 0.05
[[stages]]
name = "undrained compression"
role = "shear"
drainage = "closed"
axial = "displacement"
axial_rate_mm_per_min = 1.0
end = [{quantity = "axial_strain_pct", above = 1.0}]
)"));
}

}  // namespace

TEST_CASE("with every imperfection zero the readings are those of the bare material point") {
  const lab::Programme p = programme(lab::test::programme_text());
  lab::VirtualRig rig(p);
  const auto readings = run(rig);
  REQUIRE(readings.size() > 80);
  const auto& law = *p.material.material.axisymmetric;
  const double area_0 = std::numbers::pi / 4 * 0.07 * 0.07;
  for (const auto& r : readings) {
    const double strain = r[Quantity::axial_displacement] / 0.14;
    const double area = area_0 / (1 - strain);  // right cylinder, no volume change
    const double q = r[Quantity::axial_force] / area;
    const double p_eff = r[Quantity::cell_pressure] - r[Quantity::pore_pressure] + q / 3;
    const auto point =
        sim::advance_point(law, law.isotropic(100e3, 1.086),
                           sim::MixedControl<sim::Axisymmetric>::strain_path(-std::log1p(-strain)));
    CHECK(q == Approx(point.state.q()).epsilon(1e-9).margin(1e-6));
    CHECK(p_eff == Approx(point.state.p()).epsilon(1e-9));
    CHECK(r[Quantity::back_volume] == 0);
    CHECK(r[Quantity::back_pressure] == 300e3);
    CHECK(r[Quantity::axial_displacement] ==
          Approx(static_cast<double>(r.number) * 1e-3 / 60).epsilon(1e-9).margin(1e-15));
  }
  CHECK(*rig.truth()->axial_strain * 100 == Approx(0.517).margin(0.005));
}

TEST_CASE("a reading is a number of the field, bit for bit") {
  lab::VirtualRig rig(noisy());
  for (const auto& r : run(rig))
    for (const Quantity channel : rig.header().columns) {
      const sim::Unit unit = *sim::find_unit(lab::info(channel).unit);
      const double si = r[channel];
      REQUIRE(std::isfinite(si));
      REQUIRE(sim::to_si(sim::to_field(si, unit), unit) == si);
    }
}

TEST_CASE("the same seed gives the same readings, another seed others of the same specimen") {
  lab::VirtualRig first(noisy()), second(noisy()), other(noisy(), 99);
  const auto a = run(first), b = run(second), c = run(other);
  REQUIRE(a.size() == b.size());
  REQUIRE(a.size() == c.size());
  bool differs = false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    CHECK(a[i].time_s == static_cast<double>(i) * 1.0);
    for (const Quantity q : first.header().columns) CHECK(a[i][q] == b[i][q]);
    differs = differs || a[i][Quantity::axial_force] != c[i][Quantity::axial_force];
  }
  CHECK(differs);
  CHECK(first.specimen_state().material.q() == other.specimen_state().material.q());
  CHECK(other.header().seed == 99);
}

TEST_CASE("the header says what was simulated") {
  lab::VirtualRig rig(noisy());
  const lab::RecordHeader& h = rig.header();
  CHECK(h.origin == lab::Origin::simulated);
  CHECK(h.programme == "ICU");
  CHECK(h.seed == 3);
  CHECK(h.is_raw());
  CHECK(h.columns.size() == 7);
  CHECK(h.specimen.material == "sanisand/S28-general");
  CHECK(sim::degrees(*h.specimen.limit_friction_angle_rad) == Approx(32).margin(0.01));
  REQUIRE(h.stage(1) != nullptr);
  CHECK(h.stage(1)->role == lab::StageRole::shear);
  CHECK(h.stage(1)->drainage == lab::Drainage::closed);
  CHECK(h.stage(1)->control == lab::AxialControl::displacement);
}

TEST_CASE("the load servo follows its force until the specimen cannot carry it and runs away") {
  lab::VirtualRig rig(programme(lab::test::programme_text(R"([[stages]]
name = "load"
role = "shear"
drainage = "closed"
axial = "load"
load_rate_N_per_min = 30.0
end = [{quantity = "axial_force_N", above = 5000.0}]
)")));
  const auto readings = run(rig);
  const lab::Truth truth = *rig.truth();
  const double collapse_s = *truth.time_s;
  for (const auto& r : readings)
    if (r.time_s < collapse_s - 1)
      CHECK(r[Quantity::axial_force] == Approx(0.5 * r.time_s).margin(1e-6));
  // The undrained peak of q, which load control comes to as to a limit point: q/p' rises steeply.
  CHECK(*truth.q_pa / *truth.p_eff_pa == Approx(0.588).margin(0.006));
  REQUIRE(truth.run_aways.size() == 1);
  const lab::RunAwayTruth& fall = truth.run_aways[0];
  CHECK(fall.start_s == Approx(collapse_s).margin(0.5));
  CHECK(fall.end == lab::RunAwayEnd::end_of_travel);
  CHECK(*fall.end_s - fall.start_s < 2);
  CHECK(fall.largest_kinetic_energy_j > 0.1);
  CHECK(fall.largest_at_s == Approx(*fall.end_s).margin(0.01));
  REQUIRE(fall.expected_ratio);
  CHECK(2 * *fall.kinetic_energy_j / -*fall.second_order_work_j ==
        Approx(*fall.expected_ratio).epsilon(0.15));  // what lies beyond third order
  // Ten readings of a cap that lies on the stop.
  REQUIRE(readings.size() > 20);
  const auto lies = readings.end() - lab::VirtualRig::kSafeReadings;
  CHECK(lies[-1].time_s < *fall.end_s + 1);
  CHECK((lies[-2][Quantity::axial_displacement]) < 5e-3);
  for (auto r = lies; r != readings.end(); ++r) {
    CHECK((*r)[Quantity::axial_displacement] == Approx(0.05).epsilon(1e-9));
    CHECK(r->stage == 1);
  }
  REQUIRE(rig.header().warnings.size() == 1);
  CHECK_THAT(rig.header().warnings[0].text, Contains("travel limit of 50 mm reached"));
}

TEST_CASE("a stage that does not reach its end says so and ends the test") {
  lab::VirtualRig rig(programme(lab::test::programme_text(R"([[stages]]
name = "rest"
role = "consolidation"
drainage = "open"
axial = "free"
time_limit_min = 1.0
end = [{quantity = "q_kPa", above = 30.0}]
)")));
  CHECK(rig.progress() == 0);
  CHECK(run(rig).size() == 61);
  CHECK(rig.progress() == 1);
  REQUIRE(rig.header().warnings.size() == 1);
  CHECK_THAT(rig.header().warnings[0].text, Contains("did not reach its end within 1 min"));
  CHECK_FALSE(rig.truth()->lost_sustainability);
}

TEST_CASE("a saturated transducer is said once") {
  lab::VirtualRig rig(programme(lab::test::programme_text(
      {},
      "back_pressure_kPa = 300.0\n[rig.transducers.pore_pressure]\nrange_kPa = 310.0\n"
      "[[stages]]\nname = \"s\"\nrole = \"shear\"\ndrainage = \"closed\"\naxial = "
      "\"displacement\"\naxial_rate_mm_per_min = 1.0\n"
      "end = [{quantity = \"axial_strain_pct\", above = 1.0}]\n")));
  CHECK(run(rig).back()[Quantity::pore_pressure] == 310e3);
  REQUIRE(rig.header().warnings.size() == 2);
  CHECK_THAT(rig.header().warnings[0].text, Contains("pore_pressure left its range"));
  CHECK_THAT(rig.header().warnings[1].text, Contains("pore_pressure is at the end of its range"));
}

TEST_CASE("a free specimen that is unloaded to nothing ends in words") {
  lab::VirtualRig rig(programme(lab::test::programme_text(R"([[stages]]
name = "too far"
role = "consolidation"
drainage = "open"
axial = "free"
cell_rate_kPa_per_min = -60.0
end = [{quantity = "cell_pressure_kPa", below = 200.0}]
)")));
  CHECK(run(rig).size() > 50);
  REQUIRE_FALSE(rig.header().warnings.empty());
  CHECK_THAT(rig.header().warnings.back().text,
             Contains("too far") && Contains("the law gives no result from there on"));
}

TEST_CASE("any law can be the specimen; where one ends the test ends with its readings") {
  using lab::test::replaced;
  const std::string longer = replaced(lab::test::programme_text(), "above = 1.0}", "above = 10.0}");
  lab::VirtualRig inl2(programme(replaced(longer, "sanisand/S28-general", "inl2/S28-general")));
  run(inl2);
  CHECK(*inl2.truth()->axial_strain * 100 == Approx(0.414).margin(0.005));
  CHECK(inl2.header().warnings.empty());
  CHECK(inl2.header().cut_short.empty());

  lab::VirtualRig liquefied(
      programme(replaced(longer, "sanisand/S28-general", "hypoplastic/S28-MT")));
  CHECK(run(liquefied).size() > 100);
  REQUIRE(liquefied.header().warnings.size() == 1);
  CHECK_THAT(liquefied.header().warnings[0].text,
             Contains("the law gives no result from there on") && Contains("liquefied"));
  CHECK(liquefied.header().cut_short == liquefied.header().warnings[0].text);
  CHECK(liquefied.truth()->lost_sustainability);
}

TEST_CASE("each stage is read at its own interval, from where it begins") {
  const lab::Programme slow = lab::load_programme("samples/programmes/csu_31.toml");
  lab::VirtualRig rig(slow);
  lab::Reading last, reading;
  std::size_t compared = 0;
  REQUIRE(rig.next(last));
  for (; compared < 3900 && rig.next(reading); last = reading) {
    if (reading.stage > static_cast<int>(slow.stages.size())) break;
    const double interval = slow.stages[std::size_t(reading.stage - 1)].logging.interval_s;
    CHECK(reading.time_s - last.time_s == Approx(interval).epsilon(1e-9));
    ++compared;
  }
  CHECK(last.stage == static_cast<int>(slow.stages.size()));
}
