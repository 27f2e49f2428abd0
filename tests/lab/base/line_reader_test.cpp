// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/base/line_reader.hpp"

#include <catch2/catch.hpp>

#include "lab/base/bad_input.hpp"

using namespace triax::lab;

namespace {
std::vector<std::string> lines_of(const std::string& bytes) {
  const auto source = open_memory("m", bytes);
  LineReader reader(*source);
  std::vector<std::string> lines;
  std::string_view line;
  while (reader.next(line)) {
    lines.emplace_back(line);
    CHECK(reader.line_number() == static_cast<std::int64_t>(lines.size()));
  }
  CHECK(reader.position() == bytes.size());
  return lines;
}
}  // namespace

TEST_CASE("LF and CR LF end a line, a byte-order mark is no text") {
  CHECK(lines_of("a\nb\r\n\nc") == std::vector<std::string>{"a", "b", "", "c"});
  CHECK(lines_of("\xEF\xBB\xBFtime_s\n1\n") == std::vector<std::string>{"time_s", "1"});
  CHECK(lines_of("").empty());
}

TEST_CASE("a last line without an end is known as cut off") {
  const auto source = open_memory("m", "a\nb");
  LineReader reader(*source);
  std::string_view line;
  REQUIRE(reader.next(line));
  CHECK_FALSE(reader.cut_off());
  REQUIRE(reader.next(line));
  CHECK(reader.cut_off());
}

TEST_CASE("lines that lie across blocks come whole, whatever their length") {
  std::string bytes;
  std::vector<std::string> expected;
  for (std::size_t i = 0; i < 3000; ++i) {
    expected.emplace_back(i % 977, static_cast<char>('a' + i % 26));
    bytes += expected.back() + (i % 3 ? "\n" : "\r\n");
  }
  expected.emplace_back(900'000, 'x');
  bytes += expected.back();
  CHECK(lines_of(bytes) == expected);
}

TEST_CASE("no text: NUL bytes and endless lines are refused") {
  CHECK_THROWS_WITH(lines_of(std::string(100, '\0')), Catch::Contains("m:1: NUL bytes"));
  std::string workbook(100, '\0');
  workbook.replace(0, 4, "PK\3\4");
  CHECK_THROWS_WITH(lines_of(workbook), Catch::Contains("workbook") && Catch::Contains("CSV"));
  CHECK_THROWS_WITH(lines_of("a\n" + std::string(3 * kMaxLine_bytes, '1')),
                    Catch::Contains("m:2: the line is longer than 1 MB"));
}
