// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/paths/path_table.hpp"

#include <unistd.h>
#include <catch2/catch.hpp>

#include <cstdio>
#include <fstream>

#include "lab/base/bad_input.hpp"

using namespace triax::lab;

namespace {

struct TableFile {
  std::string path = "path_table_test_" + std::to_string(::getpid()) + ".csv";
  explicit TableFile(const std::string& text) { std::ofstream(path) << text; }
  ~TableFile() { std::remove(path.c_str()); }
};

void table_refused(const std::string& text, const std::string& because) {
  const TableFile file(text);
  CHECK_THROWS_WITH(read_path_table(file.path), Catch::Contains(because));
}

}  // namespace

TEST_CASE("a table of steps: headings, rows, remarks") {
  const TableFile file("# steps\naxial_strain, q_kPa\n0,0\n\n0.001,5\n# more\n0.002,-1.5e1\n");
  const auto table = read_path_table(file.path);
  CHECK(table.headings == std::vector<std::string>{"axial_strain", "q_kPa"});
  CHECK(table.rows == std::vector<std::vector<double>>{{0, 0}, {0.001, 5}, {0.002, -15}});
  CHECK(table.lines == std::vector<std::int64_t>{3, 5, 7});
}

TEST_CASE("what is no table of steps is refused with its line") {
  table_refused("", "no row of numbers");
  table_refused("a,b\n", "no row of numbers");
  table_refused("a,b\n1,2\n3\n", ":3: 1 cells");
  table_refused("a,b\n1,x\n", ":2: column 'b': 'x' is not a number");
  table_refused("a,b\n1,\n", "not a number");
  table_refused("a,b\n1,inf\n", "not a number");
}
