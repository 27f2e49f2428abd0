// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/probe/probe_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <set>

#include "src/probe/probe_data.hpp"
#include "tests/src/sample_probes.hpp"

using namespace triax;

namespace {

study::ProbeResult result_of(const std::vector<double>& etas, const study::Probing& probing = {}) {
  return study::run_probe(src::test::inl2_request(etas, probing, true));
}

std::set<std::string> names(const study::ProbeResult& result) {
  std::set<std::string> all;
  for (const auto& figure : src::probe_figures(result)) {
    CHECK(figure.drawing.plot);
    CHECK(figure.drawing.caption.find("inl2/S28-general") != std::string::npos);
    CHECK(figure.data.origin == "simulated");
    all.insert(figure.name);
  }
  return all;
}

}  // namespace

TEST_CASE("stress probes of the axisymmetric plane have all figures, others none of cones") {
  CHECK(names(result_of({0.5, 0.6})) == std::set<std::string>{"circular", "polar", "work",
                                                              "envelope", "control", "cones_pq",
                                                              "cones_rendulic"});
  CHECK(names(result_of({0.6}, {.kind = sim::ProbeKind::strain, .norm = 1e-5})) ==
        std::set<std::string>{"circular", "polar", "work", "control", "envelope"});
  CHECK(src::probe_figures(src::test::inl2_probes({0.6})).empty());  // none was asked for
}

TEST_CASE("the data hold every direction of every state, in the units of their columns") {
  auto result = result_of({0.5, 0.6}, {.norm = 2e3});
  result.states[1].circle.probes[3].answered = false;
  const auto data = src::probes_data(result);
  const std::size_t first = result.states[0].circle.probes.size();
  REQUIRE(data.rows.size() == first + result.states[1].circle.probes.size());
  for (const auto& row : data.rows) CHECK(row.size() == data.columns.size());
  const auto column = [&](const std::string& name) {
    return static_cast<std::size_t>(std::ranges::find(data.columns, name, &src::DataColumn::name) -
                                    data.columns.begin());
  };
  CHECK(data.rows[0][column("state")] == 1);
  CHECK(data.rows[first][column("state")] == 2);
  CHECK(*data.rows[first][column("q_kPa")] == Approx(42));
  const auto& row = data.rows[5];
  CHECK(std::hypot(*row[column("axial_stress_increment_kPa")],
                   std::sqrt(2) * *row[column("radial_stress_increment_kPa")]) == Approx(2));
  CHECK(data.rows[first + 3][column("alpha_deg")]);
  CHECK_FALSE(data.rows[first + 3][column("w2_normalised")]);
}

TEST_CASE("a state without a cone is a row without numbers") {
  const auto data = src::cones_data(result_of({0.5, 0.6}));
  REQUIRE(data.rows.size() == 2);
  CHECK_FALSE(data.rows[0][5]);
  CHECK(*data.rows[1][6] == Approx(214.835).margin(1e-3));
  CHECK(*data.rows[1][7] == Approx(237.585).margin(1e-3));
  CHECK(*data.rows[1][8] == Approx(*data.rows[1][7] - *data.rows[1][6]));
}

TEST_CASE("of many states a few are drawn") {
  std::vector<double> etas;
  for (int i = 0; i < 20; ++i) etas.push_back(0.03 * i);
  const auto figures = src::probe_figures(result_of(etas));
  CHECK(figures.at(0).drawing.caption.size() < 600);
  std::set<double> drawn;
  for (const auto& row : figures.at(0).data.rows) drawn.insert(*row.at(0));
  CHECK(drawn == std::set<double>{1, 5, 10, 15, 20});
  for (const auto& figure : figures) {
    if (figure.name == "cones_pq") CHECK(figure.data.rows.size() == 20);
    if (figure.name == "envelope")
      for (const auto& row : figure.data.rows) CHECK(row.at(0) == 20.0);
  }
}

TEST_CASE("diagrams of coarse probes are drawn every degree, and their data say so") {
  const auto result = result_of({0.6});
  const auto figures = src::probe_figures(result);
  CHECK(result.states[0].circle.probes.size() < 60);
  CHECK(figures.at(0).data.rows.size() >= 360);
  const auto& remarks = figures.at(0).data.remarks;
  CHECK(std::ranges::any_of(
      remarks, [](const auto& words) { return words.find("every 1°") != std::string::npos; }));
  CHECK(src::probes_data(result).rows.size() == result.states[0].circle.probes.size());
  const auto fine = result_of({0.6}, {.directions = 200});
  CHECK(src::probe_figures(fine).at(0).data.rows.size() == fine.states[0].circle.probes.size());
}

TEST_CASE("the limits of control in the figure are those isolated by the result") {
  const auto result = result_of({0.6});
  REQUIRE(result.states[0].control.lost.size() == 1);
  for (const auto& figure : src::probe_figures(result))
    if (figure.name == "control")
      CHECK(figure.drawing.caption.find(
                fmt::format("R = {:.4g} and {:.4g})", result.states[0].control.lost[0].from,
                            result.states[0].control.lost[0].to)) != std::string::npos);
}
