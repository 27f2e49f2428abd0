// SPDX-License-Identifier: GPL-3.0-or-later
// The law of docs/how-to/laws.md, as it stands there.
#include <catch2/catch.hpp>
#include <fstream>
#include <sstream>

#include "sim/law/parameters.hpp"
#include "sim/point/point_driver.hpp"

namespace triax::sim {
namespace {

// snippet
struct FourTermsParameters {
  double c1 = 0, c2 = 0, c3 = 0, c4 = 0;  // dσ = c₁ p dε + c₂ (σ:dε) σ/p − (c₃ σ² + c₄ s²) |dε|/p
};

template <class Space>
class FourTerms : public Law<Space> {
 public:
  explicit FourTerms(const FourTermsParameters& c) : c_(c) {}
  void response(const PointState<Space>& state, Response<Space>& out) const override {
    StiffnessForm<Space>& form = stiffness_form(out);
    const Vector<Space>& s = state.stress;
    const double p = state.p();
    form.stiffness = c_.c1 * p * Matrix<Space>::Identity() + c_.c2 / p * s * s.transpose();
    form.nonlinear = true;
    form.norm_term = (c_.c3 * square<Space>(s) + c_.c4 * square<Space>(deviator<Space>(s))) / p;
  }

 private:
  FourTermsParameters c_;
};
// end of snippet

}  // namespace
}  // namespace triax::sim

using namespace triax::sim;

TEST_CASE("the law in ten lines runs under the driver in both spaces") {
  const FourTermsParameters c{320, 240, 270, -380};
  const FourTerms<Axisymmetric> two(c);
  const FourTerms<Tensor> six(c);
  const auto a = advance_point(two, two.isotropic(100e3, 0.8),
                               MixedControl<Axisymmetric>::drained_compression(0.01));
  const auto b = advance_point(six, six.isotropic(100e3, 0.8),
                               MixedControl<Tensor>::drained_compression(0.01));
  REQUIRE(a.outcome == StepOutcome::accepted);
  CHECK(a.state.q() > 10e3);
  CHECK(b.state.q() == Approx(a.state.q()).epsilon(1e-9));
  CHECK(b.state.void_ratio == Approx(a.state.void_ratio).epsilon(1e-12));
  // q asked for beyond its strength: told, not computed.
  const auto beyond = advance_point(two, two.isotropic(100e3, 0.8),
                                    MixedControl<Axisymmetric>::stress_path(0, 1e6));
  CHECK(beyond.outcome == StepOutcome::lost_control);
}

TEST_CASE("the page on adding a law shows the code that is tested here") {
  const auto read = [](const char* path) {
    std::ifstream file(path);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
  };
  const std::string source = read("tests/sim/materials/law_in_ten_lines_test.cpp");
  const std::string begin = "// snippet\n", end = "// end of snippet";
  const auto from = source.find(begin) + begin.size();
  const std::string snippet = source.substr(from, source.find(end, from) - from);
  REQUIRE(snippet.size() > 400);
  CHECK(read("docs/how-to/laws.md").find(snippet) != std::string::npos);
}
