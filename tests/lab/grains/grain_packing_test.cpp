// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/grains/grain_packing.hpp"

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "lab/base/bad_input.hpp"

using namespace triax;
using namespace triax::lab;

namespace {

const std::string kTwo = "2 0 1 0 2 -3 3\n 0.5 1.5 -2 0.1\r\n\n0.25 0.5 2.5\t0.2";

void packing_refused(const std::string& text, const std::string& because) {
  INFO(text);
  CHECK_THROWS_WITH(read_packing(text, "p.txt", 2),
                    Catch::StartsWith("p.txt") && Catch::Contains(because));
  CHECK_THROWS_AS(read_packing(text, "p.txt", 2), BadInput);
}

}  // namespace

TEST_CASE("a packing of others is read; the axis that is asked for becomes the third") {
  const GrainPacking z = read_packing(kTwo, "p.txt", 2);
  REQUIRE(z.spheres.size() == 2);
  CHECK(z.box.low_m == std::array<double, 3>{0, 0, -3});
  CHECK(z.box.high_m == std::array<double, 3>{1, 2, 3});
  CHECK(z.spheres[1].centre_m == std::array<double, 3>{0.25, 0.5, 2.5});
  CHECK(z.spheres[1].radius_m == 0.2);
  const GrainPacking y = read_packing(kTwo, "p.txt", 1);
  CHECK(y.box.high_m == std::array<double, 3>{3, 1, 2});
  CHECK(y.spheres[0].centre_m == std::array<double, 3>{-2, 0.5, 1.5});
  const GrainPacking x = read_packing(kTwo, "p.txt", 0);
  CHECK(x.box.high_m == std::array<double, 3>{2, 3, 1});
}

TEST_CASE("a text that is no packing is refused with its line") {
  packing_refused("", "is empty");
  packing_refused("\n \n", "is empty");
  packing_refused("2 0 1 0 1\n", "p.txt:1: '2 0 1 0 1' is not 'N x0 x1 y0 y1 z0 z1'");
  packing_refused("1.5 0 1 0 1 0 1\n", "not a number of grains");
  packing_refused("1e9 0 1 0 1 0 1\n", "not a number of grains");
  packing_refused("1 0 1 1 1 0 1\n", "edge");
  packing_refused("1 0 1 0 1 0 1\n0.5 0.5 x 0.1\n", "p.txt:2");
  packing_refused("1 0 1 0 1 0 1\n0.5 0.5 nan 0.1\n", "p.txt:2");
  packing_refused("1 0 1 0 1 0 1\n0.5 0.5 0.5 0.1 7\n", "p.txt:2");
  packing_refused("1 0 1 0 1 0 1\n0.5 0.5 0.5 0\n", "radius");
  packing_refused("1 0 1 0 1 0 1\n0.5 0.5 1.5 0.1\n", "outside");
  packing_refused("2 0 1 0 1 0 1\n0.5 0.5 0.5 0.1\n", "ends after 1 of 2");
  packing_refused("1 0 1 0 1 0 1\n0.5 0.5 0.5 0.1\n0.5 0.5 0.5 0.1\n", "p.txt:3: more grains");
}

TEST_CASE("a packing from a file") {
  const auto file = std::filesystem::temp_directory_path() / "triax-packing-test.txt";
  std::ofstream(file) << kTwo;
  CHECK(load_packing(file.string(), 2).spheres.size() == 2);
  std::filesystem::remove(file);
  CHECK_THROWS_AS(load_packing(file.string(), 2), BadInput);
}
