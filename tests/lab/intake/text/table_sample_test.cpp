// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/intake/text/table_sample.hpp"

#include <catch2/catch.hpp>

#include "lab/base/bad_input.hpp"

using namespace triax::lab;

namespace {
TableSample sample_of(const std::string& text) { return read_sample(*open_memory("m", text)); }
std::string lines(std::size_t count) {
  std::string text;
  for (std::size_t i = 1; i <= count; ++i) text += std::to_string(i) + "\n";
  return text;
}
}  // namespace

TEST_CASE("Table sample: a short file is held whole") {
  const auto sample = sample_of(lines(7));
  CHECK(sample.whole);
  CHECK(sample.size() == 7);
  CHECK(sample.last.empty());
  CHECK(sample.number(6) == 7);
  CHECK(sample_of("").size() == 0);
}

TEST_CASE("Table sample: a long file is held at its ends, with line numbers") {
  const auto sample = sample_of(lines(5000));
  CHECK_FALSE(sample.whole);
  CHECK(sample.first.size() == kSampleLines);
  CHECK(sample.last.size() == kSampleLines);
  CHECK(sample.last_line_number == 4001);
  for (const std::size_t i :
       {std::size_t{0}, std::size_t{999}, std::size_t{1000}, std::size_t{1999}})
    CHECK(sample.line(i) == std::to_string(sample.number(i)));
  const auto both = sample_of(lines(1500));
  CHECK(both.whole);
  CHECK(both.number(1499) == 1500);
}

TEST_CASE("Table sample: long lines do not fill the memory") {
  std::string text;
  for (int i = 0; i < 20; ++i) text += std::string(900'000, 'x') + "\n";
  const auto sample = sample_of(text);
  CHECK(sample.first.size() == 1);
  CHECK(sample.last.size() == 1);
  CHECK(sample.last_line_number == 20);
  CHECK_THROWS_AS(sample_of(std::string(10, '\0')), BadInput);
}
