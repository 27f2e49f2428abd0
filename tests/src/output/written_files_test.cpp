// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/output/written_files.hpp"

#include <catch2/catch.hpp>

#include "src/output/output.hpp"
#include "tests/db/temporary_folder.hpp"

using namespace triax;
using namespace triax::src;

TEST_CASE("what is written is told once, and what it replaced") {
  const testing::TemporaryFolder folder;
  static_cast<void>(take_announcement());
  const std::string a = folder.file("a"), b = folder.file("b"), c = folder.file("c");
  write_file(a, "1");
  write_file(a, "2");  // of the same command
  write_file(b, "3");
  write_file("/dev/null", "4");
  CHECK(take_announcement() == "wrote " + a + " and " + b);
  CHECK(take_announcement().empty());
  write_file(b, "5");
  write_file(c, "6");
  CHECK(take_announcement() == "wrote " + c + ", replaced " + b);
}

TEST_CASE("a file that was not asked for is none") {
  static_cast<void>(take_announcement());
  WrittenFile("").is_there();
  CHECK(take_announcement().empty());
}

TEST_CASE("many files are a number and two names") {
  const testing::TemporaryFolder folder;
  static_cast<void>(take_announcement());
  for (int i = 10; i < 30; ++i) write_file(folder.file(std::to_string(i)), "x");
  CHECK(take_announcement() == "wrote 20 files: " + folder.file("10") + " to " + folder.file("29"));
}
