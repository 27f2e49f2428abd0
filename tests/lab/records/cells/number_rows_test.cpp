// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/records/cells/number_rows.hpp"

#include <catch2/catch.hpp>

using namespace triax::lab;

namespace {

bool looks(const std::string& bytes) {
  const auto source = open_memory("m", bytes);
  return looks_like_readings(*source);
}

}  // namespace

TEST_CASE("looks_like_readings: three rows of two numbers, in any table") {
  CHECK(looks("a,b\n0,1\n1,2\n2,3\n"));
  CHECK(looks("Zeit;q\n0,5;1\n1,5;2\n2,5;3"));
  CHECK(looks("1\t2\r\n3\t4\r\n5\t6\r\n"));
  CHECK(looks("  1.5   2e3\n  2.5 3e3\n 3 4\n"));
  CHECK(
      looks(std::string("\xFF\xFE"
                        "1\0,\0002\0\n\0001\0,\0002\0\n\0001\0,\0002\0",
                        24)));
  CHECK(looks("PK\3\4..."));
}

TEST_CASE("looks_like_readings: not in letters, pictures and short lists") {
  CHECK_FALSE(looks(""));
  CHECK_FALSE(looks("Dear client,\non 3 May we tested 2 specimens.\n"));
  CHECK_FALSE(looks("a,b\n1,2\n1,2\n"));
  CHECK_FALSE(looks("1\n2\n3\n4\n"));
  CHECK_FALSE(looks(std::string("\x89PNG\r\n1,2\n1,2\n1,2\n\0\0", 20)));
  CHECK_FALSE(looks("%PDF-1.4\n%\xE2\xE3\n"));
  CHECK_FALSE(looks(std::string(300'000, ',')));
}
