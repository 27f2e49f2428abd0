// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/grains/vtk_document.hpp"

#include <catch2/catch.hpp>

#include "tests/lab/grains/vtk_reading.hpp"

using namespace triax;
using namespace triax::lab;

TEST_CASE("a VTK array has the digits that mean the same number") {
  const std::vector<double> exact{0.1, 1.0 / 3, -2.5e-300};
  CHECK(vtk_array("a", exact).text == "0.1 0.3333333333333333 -2.5e-300 ");
  CHECK(vtk_array("a", std::vector<float>{0.1F}).text == "0.1 ");
  CHECK(std::string(vtk_array("a", exact).type) == "Float64");
  CHECK(std::string(vtk_array("a", std::vector<std::int32_t>{1}).type) == "Int32");
}

TEST_CASE("a VTK document is well-formed whatever its names hold") {
  VtkPolyData data;
  data.comment = "simulated <&> -- with dashes ---";
  data.time_s = 0.125;
  data.points_m = {0, 0, 0, 1, 2, 3};
  data.connectivity = {0, 1};
  data.offsets = {2};
  data.lines = true;
  data.field = {vtk_array("of the whole", std::vector<double>{1, 2, 3})};
  data.cell_data = {vtk_array("a \"quoted\" <name>", std::vector<float>{7})};
  const auto read = lab::test::read_vtk(vtk_document(data));
  CHECK(read.well_formed);
  CHECK(read.type == "PolyData");
  CHECK(read.comment.find("simulated") != std::string::npos);
  CHECK(read.piece.at("NumberOfPoints") == "2");
  CHECK(read.piece.at("NumberOfLines") == "1");
  CHECK(read.piece.at("NumberOfVerts") == "0");
  CHECK(read.arrays.at("TimeValue") == std::vector<double>{0.125});
  CHECK(read.arrays.at("of the whole") == std::vector<double>{1, 2, 3});
  CHECK(read.array_attributes.at("of the whole").at("NumberOfTuples") == "3");
  CHECK(read.arrays.at("a \"quoted\" <name>") == std::vector<double>{7});
  CHECK(read.parents.at("a \"quoted\" <name>") == "CellData");
  CHECK(read.arrays.at("position_m") == data.points_m);
  CHECK(read.parents.at("connectivity") == "Lines");
}

TEST_CASE("a VTK collection gives each file its time, files of one time as parts") {
  const auto read = lab::test::read_vtk(
      vtk_collection({{0, "a&b.vtp"}, {0, "b.vtp"}, {0.5, "c.vtp"}}, "simulated"));
  CHECK(read.well_formed);
  CHECK(read.type == "Collection");
  REQUIRE(read.data_sets.size() == 3);
  CHECK(read.data_sets[0].at("file") == "a&b.vtp");
  CHECK(read.data_sets[0].at("part") == "0");
  CHECK(read.data_sets[1].at("part") == "1");
  CHECK(read.data_sets[1].at("timestep") == "0");
  CHECK(read.data_sets[2].at("timestep") == "0.5");
  CHECK(read.data_sets[2].at("part") == "0");
}
