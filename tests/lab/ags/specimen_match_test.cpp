// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/ags/specimen_match.hpp"

#include <catch2/catch.hpp>

using namespace triax::lab;

namespace {
ReferenceResult general(const std::string& location, const std::string& reference,
                        std::optional<double> depth, const std::string& type) {
  ReferenceResult row;
  row.specimen.location = location;
  row.specimen.specimen_reference = reference;
  row.specimen.specimen_depth_m = depth;
  row.test_type = type;
  return row;
}
ReferenceSpecimen key(const std::string& location, const std::string& reference,
                      std::optional<double> depth) {
  return general(location, reference, depth, "").specimen;
}
}  // namespace

TEST_CASE("the general row of a specimen: the same keys, or the only one that does not differ") {
  SpecimenMatch rows;
  rows.add(general("BH1", "1", 2.0, "CD"));
  rows.add(general("BH1", "", 3.0, "CU"));
  rows.add(general("BH1", "1", std::nullopt, "UU"));
  rows.add(general("BH2", "1", 2.0, "CIUC"));
  CHECK(rows.find(key("BH1", "1", 2.0))->test_type == "CD");
  CHECK(rows.find(key("BH1", "2", 3.0))->test_type == "CU");
  CHECK(rows.find(key("BH2", "", std::nullopt))->test_type == "CIUC");
  CHECK(rows.find(key("BH1", "", std::nullopt)) == nullptr);  // three fit
  CHECK(rows.find(key("BH1", "2", 4.0)) == nullptr);
  CHECK(rows.find(key("BH3", "1", 2.0)) == nullptr);
  std::vector<ReferenceResult> rest;
  rows.append_unmatched(rest);
  REQUIRE(rest.size() == 1);
  CHECK(rest[0].test_type == "UU");
}
