// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/calibrate/computed_path.hpp"

#include <catch2/catch.hpp>
#include <stdexcept>

#include "lab/materials/material_library.hpp"

using namespace triax;
using namespace triax::study;

namespace {

using Space = sim::Axisymmetric;

/// Elastic, until its plug-in fails at one of its answers.
class Failing : public sim::Law<Space> {
 public:
  explicit Failing(int answers) : left_(answers) {}
  using sim::Law<Space>::response;
  void response(const State& state, sim::Response<Space>& out) const override {
    if (left_-- <= 0) throw std::runtime_error("the plug-in failed");
    elastic_->response(state, out);
  }

 private:
  std::shared_ptr<const sim::Law<Space>> elastic_ =
      lab::find_material("elastic/Hostun-loose").material.axisymmetric;
  mutable int left_;
};

MeasuredPath undrained() {
  MeasuredPath path;
  path.imposed = Imposed::undrained;
  path.void_ratio = 0.9;
  path.start.p_eff = 100e3;
  for (int i = 1; i <= 5; ++i) {
    PathKnot knot = path.start;
    knot.axial_strain = 1e-4 * i;
    path.knots.push_back(knot);
  }
  return path;
}

}  // namespace

TEST_CASE("a plug-in that fails at whichever answer predicts no collapse, and ends nothing") {
  for (int answers = 0; answers < 60; ++answers) {
    INFO(answers);
    std::optional<double> eta;
    CHECK_NOTHROW(eta = onset_eta(Failing(answers), undrained(), {}));
    CHECK_FALSE(eta);
  }
}
