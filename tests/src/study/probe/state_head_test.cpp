// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/probe/state_head.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "lab/paths/path_reader.hpp"
#include "src/study/probe/states_to_probe.hpp"

using namespace triax;
using sim::Axisymmetric;
using sim::Tensor;

namespace {

double deviator(double s1, double s2, double s3) {
  sim::PointState<Tensor> state;
  state.stress << s1, s2, s3, 0, 0, 0;
  return study::deviator_stress(state);
}

/// q of the rows of an undrained path at constant radial total stress, kPa.
template <class Space>
std::vector<double> undrained(double axial_strain) {
  auto path = lab::read_path(
      "[path]\nname = \"a\"\nmaterial = \"octolinear/S28-general\"\n"
      "[start]\np_eff_kPa = 300.0\nvoid_ratio = 1.02\n"
      "[[segments]]\nname = \"b\"\ndrainage = \"undrained\"\n"
      "conditions = [\"axial_strain = " +
          std::to_string(axial_strain) + "\", \"radial_stress_kPa = 0\"]\nrows = 10\n",
      "a.toml");
  const auto material = path.material;
  std::vector<double> q;
  for (const auto& what :
       study::states_to_probe<Space>(material, study::StatesOfPath{std::move(path), 2}).states)
    q.push_back(study::head_of(material, what).q / 1e3);
  return q;
}

}  // namespace

TEST_CASE("q is the invariant with the sign of compression or extension along axis 1") {
  CHECK(deviator(160, 70, 70) == Approx(90));
  CHECK(deviator(40, 130, 130) == Approx(-90));
  // Whether two stresses are equal to the last digit has no say.
  CHECK(deviator(40, 130, 130 * (1 + 1e-15)) == Approx(-90));
  CHECK(deviator(40, 130 * (1 + 1e-15), 130) == Approx(-90));
  CHECK(deviator(120, 100, 80) == Approx(std::sqrt(3.0) * 20));
  CHECK(deviator(80, 100, 120) == Approx(-std::sqrt(3.0) * 20));
  CHECK(deviator(100, 100, 100) == 0);
}

TEST_CASE("an axisymmetric path has the same q in either plane, negative in extension") {
  for (const double axial_strain : {-0.04, 0.02}) {
    CAPTURE(axial_strain);
    const auto triaxial = undrained<Axisymmetric>(axial_strain);
    const auto plane = undrained<Tensor>(axial_strain);
    REQUIRE(triaxial.size() == plane.size());
    REQUIRE(triaxial.size() > 4);
    for (std::size_t i = 0; i < plane.size(); ++i) {
      CHECK(plane[i] == Approx(triaxial[i]).epsilon(1e-4).margin(1e-3));
      if (i > 0) CHECK((plane[i] < 0) == (axial_strain < 0));
    }
  }
}
