// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/results/labels.hpp"

#include <catch2/catch.hpp>

#include "lab/base/bad_input.hpp"
#include "lab/records/metadata.hpp"

using namespace triax::lab;

TEST_CASE("set_label: replaces the note of its label and is stronger than a preamble") {
  RecordHeader header;
  header.notes = {{"Bohrung", "old"}, {"Borehole", "old"}, {"", "a remark"}};
  const LabelKey* const borehole = find_label("borehole");
  REQUIRE(borehole != nullptr);
  CHECK(label_text(header, *borehole) == "old");
  set_label(header, *borehole, " B3 ");
  CHECK(label_text(header, *borehole) == "B3");
  CHECK(header.notes.front().label == "Borehole");
  CHECK(header.notes.size() == 3);
  set_label(header, *borehole, "");
  CHECK(label_text(header, *borehole).empty());
  CHECK(header.notes.size() == 2);
}

TEST_CASE("labels: --set takes them, and unknown ones name the nearest") {
  RecordHeader header;
  set_metadata(header, "--set", "labels.ordered_by", "A. Person");
  set_metadata(header, "--set", "labels.depth_m", "4.55");
  CHECK(metadata_text(header, "labels.ordered_by") == "A. Person");
  CHECK(metadata_text(header, "labels.depth") == "4.55");
  CHECK(canonical_key("labels.depth_m") == "labels.depth");
  CHECK_THROWS_WITH(set_metadata(header, "job.toml:3", "labels.cliant", "X"),
                    Catch::Contains("job.toml:3: unknown key 'labels.cliant'; did you mean "
                                    "'labels.client'"));
  for (const std::string& bad : {std::string("a\nb"), std::string("a\0b", 3), std::string("\xff")})
    CHECK_THROWS_AS(set_metadata(header, "--set", "labels.client", bad), BadInput);
  CHECK(metadata_text(header, "labels.client").empty());
}
