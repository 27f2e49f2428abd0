// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/paths/inp_frame.hpp"

#include <catch2/catch.hpp>

using namespace triax::lab;
namespace sim = triax::sim;

TEST_CASE("stress and strain of every frame are conjugate: they give the work") {
  sim::Vector<sim::Tensor> stress, strain;
  stress << 310e3, 120e3, 90e3, 25e3, -14e3, 8e3;
  strain << 0.01, -0.003, -0.002, 0.004, 0.001, -0.006;
  for (const char* keyword : {"*Cartesian", "*Roscoe", "*RoscoeIsomorph", "*Rendulic"}) {
    const auto frame = find_inp_frame(keyword);
    REQUIRE(frame);
    CHECK((frame->stress * stress).dot(frame->strain * strain) * 1e3 ==
          Approx(stress.dot(strain)).epsilon(1e-12));
  }
  CHECK_FALSE(find_inp_frame("*Polar"));
}

TEST_CASE("Roscoe's components are p, q and the strains that go with them, compression positive") {
  sim::Vector<sim::Tensor> a;
  a << 300e3, 100e3, 100e3, 0, 0, 0;
  const auto roscoe = *find_inp_frame("*roscoe");
  const sim::Vector<sim::Tensor> s = roscoe.stress * a;
  CHECK(s(0) == Approx(500.0 / 3));
  CHECK(s(1) == Approx(200));
  CHECK(s(2) == Approx(0).margin(1e-12));
  a << 0.03, -0.01, -0.01, 0, 0, 0;
  const sim::Vector<sim::Tensor> e = roscoe.strain * a;
  CHECK(e(0) == Approx(0.01));
  CHECK(e(1) == Approx(2 * 0.04 / 3));
  CHECK(roscoe.stress_labels[1] == "q_kPa");
  CHECK(roscoe.strain_labels[1] == "shear_strain");
}

TEST_CASE("Cartesian components are those of the files: tension positive, γ = 2 ε") {
  sim::Vector<sim::Tensor> a;
  a << 1e3, 2e3, 3e3, 4e3 * std::sqrt(2.0), 0, 0;
  const auto frame = *find_inp_frame("*Cartesian");
  CHECK((frame.stress * a)(0) == Approx(-1));
  CHECK((frame.stress * a)(3) == Approx(-4));
  CHECK((frame.strain * a)(3) == Approx(-8e3));
  CHECK((inp_stress_row(3) * a)(0) == Approx(-4));
  CHECK((inp_strain_row(3) * a)(0) == Approx(-8e3));
}
