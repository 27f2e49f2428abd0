// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/grains/grain_data.hpp"

#include <catch2/catch.hpp>

#include "tests/src/contains.hpp"
#include "tests/src/sample_grains.hpp"

using namespace triax;
using namespace triax::src;

namespace {

std::size_t column(const FigureData& data, const std::string& name) {
  for (std::size_t i = 0; i < data.columns.size(); ++i)
    if (data.columns[i].name == name) return i;
  FAIL("no column " << name);
  return 0;
}

void check_rows(const FigureData& data, std::size_t count) {
  CHECK(data.origin == "simulated");
  CHECK(data.rows.size() == count);
  for (const auto& row : data.rows) REQUIRE(row.size() == data.columns.size());
}

}  // namespace

TEST_CASE("the data of paths hold all points, with the work of each increment") {
  const lab::GrainReport report = test::sample_run();
  const FigureData data = paths_data(report, {&report.stages[2], &report.stages[3]});
  check_rows(data, 82);
  CHECK(*data.rows[0][column(data, "stage")] == 3);
  CHECK(*data.rows[41][column(data, "stage")] == 4);
  CHECK_FALSE(data.rows[0][column(data, "w2_J_per_m3")]);
  CHECK_FALSE(data.rows[41][column(data, "w2_J_per_m3")]);
  CHECK(*data.rows[5][column(data, "w2_J_per_m3")] == Approx(0.1));
  CHECK(*data.rows[20][column(data, "path_stress_kPa")] == Approx(20));
  CHECK(std::ranges::count(data.remarks, "stage 3: R-0.8, strain_path from the specimen as made") ==
        1);
}

TEST_CASE("the data of a rose hold every probe and the null probe without a direction") {
  lab::GrainReport report = test::sample_run();
  std::get<lab::ReportedGrainRose>(report.stages[5].came).made.rose.probes[2].stopped = true;
  const FigureData data = rose_data(report, report.stages[5]);
  check_rows(data, 37);
  CHECK(*data.rows[9][column(data, "alpha_deg")] == Approx(90));
  CHECK(*data.rows[9][column(data, "w2_microscopic_J_per_m3")] == Approx(0.012));
  CHECK(*data.rows[14][column(data, "at_rest")] == 0);
  CHECK(*data.rows[2][column(data, "alpha_deg")] == Approx(20));
  CHECK_FALSE(data.rows[2][column(data, "axial_strain_increment")]);
  CHECK_FALSE(data.rows[36][column(data, "alpha_deg")]);
  CHECK(*data.rows[36][column(data, "axial_strain_increment")] == 1e-8);
}

TEST_CASE("each stage but a rest has a file, named after it, with full digits") {
  lab::GrainReport report = test::sample_run();
  std::get<lab::ReportedGrainPath>(report.stages[2].came).points[1].strain.axial = 1.0 / 3;
  const auto files = grain_csvs(report);
  REQUIRE(files.size() == 8);
  CHECK(files[2].suffix == "_R-0.8_points.csv");
  CHECK(files[4].suffix == "_probes_probes.csv");
  CHECK(files[5].suffix == "_load_a_points.csv");
  CHECK(test::contains(files[2].bytes, "0.3333333333333333"));
  CHECK(test::contains(files[2].bytes, "# origin = \"simulated\""));
  CHECK(test::contains(files[2].bytes, "sample, 4 grains"));
}

TEST_CASE("the data of perturbations hold all points") {
  const lab::GrainReport report = test::sample_run();
  const FigureData data = perturbations_data(report, {&report.stages[6], &report.stages[7]});
  check_rows(data, 22);
  CHECK(*data.rows[21][column(data, "chi")] == Approx(0.05));
  CHECK(*data.rows[21][column(data, "path_stress_kPa")] == Approx(1.25));
}

TEST_CASE("the data of a rose hold the parts of the gap, the boundary term and the ledger") {
  lab::GrainReport report = test::sample_run();
  const FigureData data = rose_data(report, report.stages[5]);
  const auto& row = data.rows[9];
  CHECK(*row[column(data, "gap_grains_turning_J_per_m3")] == Approx(0.0018));
  CHECK(*row[column(data, "gap_contacts_turning_J_per_m3")] == Approx(0.00012));
  CHECK(*row[column(data, "gap_out_of_balance_J_per_m3")] == Approx(0.00006));
  CHECK(*row[column(data, "gap_left_J_per_m3")] == Approx(0.00002));
  CHECK(*row[column(data, "boundary_part_J_per_m3")] == Approx(-0.03));
  CHECK(*row[column(data, "walls_J")] == 2e-6);
  CHECK(*row[column(data, "elastic_change_J")] == Approx(1e-6));
  CHECK(*row[column(data, "friction_J")] == 9e-7);
  CHECK(*row[column(data, "damping_J")] == 9e-8);
  CHECK(*row[column(data, "ledger_error_J")] == Approx(1e-8));
  CHECK_FALSE(row[column(data, "norm_strain")]);
  auto& rose = std::get<lab::ReportedGrainRose>(report.stages[5].came);
  rose.kind = sim::ProbeKind::strain;
  rose.made.rose.probes[9].norm_strain = 3e-6;
  const FigureData by_strain = rose_data(report, report.stages[5]);
  CHECK_FALSE(by_strain.rows[9][column(data, "norm_kPa")]);
  CHECK(*by_strain.rows[9][column(data, "norm_strain")] == 3e-6);
}
