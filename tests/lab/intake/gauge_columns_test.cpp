// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/intake/gauge_columns.hpp"

#include <string>

#include <fmt/format.h>
#include <catch2/catch.hpp>

using namespace triax::lab;

namespace {

/// A test with a dial and a ring; `label` is the line above.
Proposal proposal_of(const std::string& label, const std::string& headings,
                     const std::string& more = "") {
  std::string text = label + "\n" + headings + "\n";
  for (int i = 0; i < 20; ++i)
    text += fmt::format("{},{:.2f},{:.1f}{}\n", i, 0.4 * i, 80.0 * i / (i + 4), more);
  const auto source = open_memory("m.csv", text);
  return propose(*source, 0);
}

constexpr const char* kGauges = "Time (min),Dial reading (mm),Proving ring reading (div)";

}  // namespace

TEST_CASE("find_gauge_columns: the ring factor is a label with its unit") {
  const auto gauges = find_gauge_columns(proposal_of("Ring factor (kgf/div),0.25", kGauges));
  REQUIRE(gauges.size() == 2);
  CHECK_FALSE(gauges[0].is_force);
  CHECK(gauges[0].scale.value() == Approx(1e-3));
  CHECK(gauges[1].is_force);
  CHECK(gauges[1].scale.value() == Approx(0.25 * 9.80665));
}

TEST_CASE("find_gauge_columns: a ring in inches needs a factor per length") {
  const std::string headings = "Time (min),Dial reading (mm),Proving ring dial (in.)";
  const auto gauges = find_gauge_columns(proposal_of("Proving ring (lb/in.),6000", headings));
  REQUIRE(gauges.size() == 2);
  CHECK(gauges[1].scale.value() == Approx(6000 * 4.4482216152605));
  CHECK_FALSE(find_gauge_columns(proposal_of("Ring factor (N/div),2", headings))[1].scale);
}

TEST_CASE("find_gauge_columns: the factor may be a column that does not change") {
  const std::string headings = std::string(kGauges) + ",Ring factor (N/div)";
  CHECK(find_gauge_columns(proposal_of("x,y", headings, ",2.5"))[1].scale.value() == Approx(2.5));
}

TEST_CASE("find_gauge_columns: labels state the factors of ring and dial in any form") {
  const std::string headings = "Time (min),Dial gauge (div),Load ring (div)";
  for (const char* const label :
       {"Load ring constant 1.25 N/div\nDial gauge 0.01 mm/div", "LRC,1.25,N/div\nDGC,0.01,mm/div",
        "LRC = 1.25 N/div; Dial gauge factor = 0.01 mm/div",
        "Load ring constant (N/div): 1.25\nDial gauge (mm/div): 0.01",
        "Strain dial 0.01 mm per division\nProving ring 1.25 N per division",
        "Ring factor: 0.00125 kN/div\nLeast count of dial gauge: 0.01 mm"}) {
    INFO(label);
    const auto gauges = find_gauge_columns(proposal_of(label, headings));
    REQUIRE(gauges.size() == 2);
    CHECK(gauges[0].scale.value_or(0) == Approx(1e-5));
    CHECK(gauges[1].scale.value_or(0) == Approx(1.25));
  }
}

TEST_CASE("find_gauge_columns: a factor without a unit or an unusual one is none") {
  const std::string headings = "Time (min),Dial gauge (div),Load ring (div)";
  for (const char* const label : {"LRC: 1.25\nDial gauge: 0.01", "Dial gauge: 25 mm"}) {
    const auto gauges = find_gauge_columns(proposal_of(label, headings));
    REQUIRE(gauges.size() == 2);
    CHECK_FALSE(gauges[0].scale);
    CHECK_FALSE(gauges[1].scale);
  }
}

TEST_CASE("find_gauge_columns: a missing factor is a question") {
  const Proposal proposal = proposal_of("x,y", kGauges);
  CHECK_FALSE(find_gauge_columns(proposal)[1].scale);
  CHECK(std::ranges::any_of(proposal.questions, [](const TableQuestion& question) {
    return question.about == TableQuestion::About::unit &&
           question.text.starts_with("ring factor of Proving ring reading");
  }));
}

TEST_CASE("find_gauge_columns: a force and a strain in the file are enough") {
  const std::string headings = "Axial force (N),Axial strain (%),Proving ring reading (div)";
  CHECK(find_gauge_columns(proposal_of("Ring factor (N/div),2", headings)).empty());
}
