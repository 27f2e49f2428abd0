// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/domain/usual_grid.hpp"

#include <catch2/catch.hpp>

#include "lab/base/bad_input.hpp"

using namespace triax;

TEST_CASE("the usual grid stays within what a set is for, up to its limit surface") {
  auto material = lab::find_material("inl2/S28-general");
  material.p_eff_range_kPa = lab::ValidRange{50, 200};
  const auto p = study::usual_p(material);
  CHECK(p.from == 50);
  CHECK(p.to == 200);
  CHECK(p.count == 200);
  const auto q = study::usual_q(material, p);
  CHECK(q.from == 0);
  const double M = material.material.axisymmetric->limit_stress_ratio().value();
  CHECK(q.to >= M * 200);
  CHECK(q.to < M * 200 + 10);
  material.p_eff_range_kPa.reset();
  CHECK(study::usual_p(material).from == 10);
  CHECK(study::usual_p(material).to == 300);
}

TEST_CASE("localisation is possible for a law with tangents of the full tensor, where asked for") {
  const auto inl2 = lab::find_material("inl2/S28-general");
  const auto norsand = lab::find_material("norsand/S28-MT");
  const auto wish = [](std::vector<std::string> criteria) {
    return study::GridWish{.p = {10, 300, 4},
                           .q = {0, 400, 4},
                           .void_ratio = 0.9,
                           .plane = "axisymmetric",
                           .directions = 0,
                           .criteria = std::move(criteria)};
  };
  using Names = std::vector<std::string>;
  CHECK(study::asked_grid(inl2, wish({}), {}).criteria == Names{"determinant"});
  CHECK(study::asked_grid(inl2, wish({"localisation"}), {}).criteria ==
        Names{"determinant", "localisation"});
  CHECK(study::asked_grid(norsand, wish({}), {}).criteria == Names{"determinant"});
  CHECK_THROWS_WITH(study::asked_grid(norsand, wish({"localisation"}), {"--plane ", "--"}),
                    Catch::Contains("--localisation needs the full tensor"));
}
