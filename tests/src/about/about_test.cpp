// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/about/about.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <iterator>
#include <set>
#include <sstream>
#include <string>

#include "lab/health/sensor_limits.hpp"
#include "lab/measured/assessment_limits.hpp"
#include "lab/warning/warning_limits.hpp"

using namespace triax;

namespace {

/// The table below a title.
std::string table_of(const std::string& text, const std::string& title) {
  const auto begin = text.find("\n" + title + "\n");
  REQUIRE(begin != std::string::npos);
  return text.substr(begin, text.find("\nLimits of ", begin + 1) - begin);
}

std::multiset<std::string> words(std::string_view text) {
  std::istringstream in{std::string(text)};
  return {std::istream_iterator<std::string>(in), {}};
}

template <std::size_t N>
void check_printed(const char* title, const std::array<lab::Limit, N>& limits) {
  const std::string table = table_of(src::rules_text(), title);
  std::multiset<std::string> expected;
  for (const lab::Limit& limit : limits) {
    INFO(limit.name);
    CHECK(!limit.name.empty());
    CHECK(!limit.reason.empty());
    CHECK(limit.value > 0);
    expected.merge(words(limit.name));
    expected.merge(words(limit.unit));
    expected.merge(words(limit.reason));
    if (!limit.origin.empty()) expected.merge(words("(" + std::string(limit.origin) + ")"));
  }
  const auto printed = words(table);
  for (const std::string& word : expected) {
    INFO(word);
    CHECK(printed.count(word) >= expected.count(word));
  }
}

}  // namespace

TEST_CASE("about --rules: prints each limit with unit, reason and origin") {
  check_printed("Limits of the assessment", lab::assessment_limits::kAll);
  check_printed("Limits of sensors and states", lab::sensor_limits::kAll);
  check_printed("Limits of warnings", lab::warning_limits::kAll);
}

TEST_CASE("about --rules: prints values in their units") {
  const std::string text = src::rules_text();
  for (const char* line : {"double amplitude of axial strain", "5 %", "2000 MPa", "50 °", "1e-09"})
    CHECK(text.find(line) != std::string::npos);
}

TEST_CASE("about --rules: no two limits have the same name") {
  std::set<std::string_view> names;
  const auto add = [&](const auto& limits) {
    for (const lab::Limit& limit : limits) {
      INFO(limit.name);
      CHECK(names.insert(limit.name).second);
    }
  };
  add(lab::assessment_limits::kAll);
  add(lab::sensor_limits::kAll);
  add(lab::warning_limits::kAll);
}
