#include "src/probe/probe_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <set>

using namespace triax;

namespace {

src::ProbeReport report_of(const std::vector<double>& etas, const study::Probing& probing = {}) {
  src::ProbeReport report;
  report.material = lab::find_material("inl2/S28-general");
  report.probing = probing;
  for (const double eta : etas) {
    study::StateToProbe<sim::Axisymmetric> what;
    what.state = report.material.material.axisymmetric->start(
        sim::components(sim::AxisymmetricStress{70e3 * (1 + 2 * eta / 3), 70e3 * (1 - eta / 3)}),
        1.086);
    report.states.push_back(study::probe_state(report.material, what, probing));
  }
  return report;
}

std::set<std::string> names(const src::ProbeReport& report) {
  std::set<std::string> all;
  for (const auto& figure : src::probe_figures(report)) {
    CHECK(figure.drawing.plot);
    CHECK(figure.drawing.caption.find("inl2/S28-general") != std::string::npos);
    CHECK(figure.data.origin == "simulated");
    all.insert(figure.name);
  }
  return all;
}

}  // namespace

TEST_CASE("stress probes of the axisymmetric plane have all figures, others none of cones") {
  CHECK(names(report_of({0.5, 0.6})) == std::set<std::string>{"circular", "polar", "work",
                                                              "envelope", "control", "cones_pq",
                                                              "cones_rendulic"});
  CHECK(names(report_of({0.6}, {.kind = sim::ProbeKind::strain, .norm = 1e-5})) ==
        std::set<std::string>{"circular", "polar", "work", "control", "envelope"});
  auto silent = report_of({0.6});
  for (sim::Probe& probe : silent.states[0].circle.probes) probe.answered = false;
  silent.states[0].circle.least.answered = false;
  CHECK(src::probe_figures(silent).empty());
}

TEST_CASE("the data hold every direction of every state, in the units of their columns") {
  auto report = report_of({0.5, 0.6}, {.norm = 2e3});
  report.states[1].circle.probes[3].answered = false;
  const auto data = src::probes_data(report);
  const std::size_t first = report.states[0].circle.probes.size();
  REQUIRE(data.rows.size() == first + report.states[1].circle.probes.size());
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
  const auto data = src::cones_data(report_of({0.5, 0.6}));
  REQUIRE(data.rows.size() == 2);
  CHECK_FALSE(data.rows[0][5]);
  CHECK(*data.rows[1][6] == Approx(214.835).margin(1e-3));
  CHECK(*data.rows[1][7] == Approx(237.585).margin(1e-3));
  CHECK(*data.rows[1][8] == Approx(*data.rows[1][7] - *data.rows[1][6]));
}

TEST_CASE("of many states a few are drawn") {
  std::vector<double> etas;
  for (int i = 0; i < 20; ++i) etas.push_back(0.03 * i);
  const auto figures = src::probe_figures(report_of(etas));
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
  const auto report = report_of({0.6});
  const auto figures = src::probe_figures(report);
  CHECK(report.states[0].circle.probes.size() < 60);
  CHECK(figures.at(0).data.rows.size() >= 360);
  const auto& remarks = figures.at(0).data.remarks;
  CHECK(std::ranges::any_of(
      remarks, [](const auto& words) { return words.find("every 1°") != std::string::npos; }));
  CHECK(src::probes_data(report).rows.size() == report.states[0].circle.probes.size());
  const auto fine = report_of({0.6}, {.directions = 200});
  CHECK(src::probe_figures(fine).at(0).data.rows.size() == fine.states[0].circle.probes.size());
}

TEST_CASE("the limits of control in the figure are those isolated by the report") {
  const auto report = report_of({0.6});
  REQUIRE(report.states[0].control.lost.size() == 1);
  for (const auto& figure : src::probe_figures(report))
    if (figure.name == "control")
      CHECK(figure.drawing.caption.find(
                fmt::format("R = {:.4g} and {:.4g})", report.states[0].control.lost[0].from,
                            report.states[0].control.lost[0].to)) != std::string::npos);
}
