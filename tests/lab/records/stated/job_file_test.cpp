// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/records/stated/job_file.hpp"

#include <catch2/catch.hpp>
#include <fstream>

#include "lab/base/bad_input.hpp"
#include "tests/db/temporary_folder.hpp"

using namespace triax::lab;
using Catch::Contains;
using Texts = std::vector<std::string>;

namespace {

JobFile job_of(const std::string& text) {
  const triax::testing::TemporaryFolder folder;
  const std::string path = folder.file("job.toml");
  std::ofstream(path, std::ios::binary) << text;
  return JobFile::read(path);
}

Texts texts_of(const std::vector<SetValue>& values) {
  Texts all;
  for (const SetValue& value : values)
    all.push_back(value.where.substr(value.where.rfind("job.toml")) + " " + value.key + "=" +
                  value.value);
  return all;
}

constexpr const char* kJob = R"([test]
programme = "CU"
[labels]
client = "A"
depth = 4.5
[specimen]
height_mm = 140
[stages.2]
role = "shear"
[[file]]
match = ["ICU-?.csv", "x*"]
specimen.height_mm = 100
[file.labels]
borehole = "B1"
[[file]]
match = "*-7.csv"
[file.stages.1]
drainage = "open"
)";

}  // namespace

TEST_CASE("JobFile: common values first, then those of each section that matches") {
  const JobFile job = job_of(kJob);
  const Texts common = {"job.toml:2 test.programme=CU", "job.toml:7 specimen.height_mm=140",
                        "job.toml:4 labels.client=A", "job.toml:5 labels.depth=4.5",
                        "job.toml:9 stages.2.role=shear"};
  CHECK(texts_of(job.values_for("folder/other.csv")) == common);
  Texts of_seven = common;
  for (const char* one : {"job.toml:12 specimen.height_mm=100", "job.toml:14 labels.borehole=B1",
                          "job.toml:18 stages.1.drainage=open"})
    of_seven.emplace_back(one);
  CHECK(texts_of(job.values_for("ICU-?.csv/ICU-7.csv")) == of_seven);
  CHECK(texts_of(job.values_for("xx")).size() == common.size() + 2);
}

TEST_CASE("JobFile: a section that no record matches is named") {
  const JobFile job = job_of(kJob);
  const auto unmatched = job.unmatched({"a.csv", "x"});
  REQUIRE(unmatched.size() == 1);
  CHECK_THAT(unmatched[0], Contains("job.toml:15: no record matches '*-7.csv'"));
  CHECK(JobFile().unmatched({}).empty());
  CHECK(JobFile().values_for("a").empty());
}

TEST_CASE("JobFile: mistakes are reported with file, line and the nearest key") {
  const auto fails = [](const std::string& text) {
    try {
      job_of(text);
    } catch (const BadInput& error) {
      const std::string what = error.what();
      return what.substr(what.rfind("job.toml", what.find(' ')));
    }
    return std::string();
  };
  CHECK_THAT(fails("[specimen]\nhight_mm = 1\n"),
             Contains("job.toml:2: unknown key 'specimen.hight_mm'; did you mean "
                      "'specimen.height_mm'"));
  CHECK_THAT(fails("[specimem]\nheight_mm = 100\n"), Contains("specimen"));
  CHECK_THAT(fails("[[file]]\nmatch = \"a\"\n[file.labels]\nbore = 1\n"), Contains("job.toml:4:"));
  CHECK_THAT(fails("[[file]]\nmatch = \"a\"\nmatsch = 1\n"), Contains("job.toml:3"));
  CHECK_THAT(fails("[[file]]\n[file.labels]\nborehole = \"1\"\n"), Contains("pattern"));
  CHECK_THAT(fails("[specimen]\nheight_mm = -4\n"), Contains("job.toml:2:"));
  CHECK_THAT(fails("[stages]\nrole = \"shear\"\n"), Contains("[stages.1]"));
  CHECK_THAT(fails("[stages.x]\nrole = \"shear\"\n"), Contains("unknown key"));
  CHECK_THAT(fails("[test]\norigin = \"recorded\"\n"), Contains("cannot be set"));
  CHECK_THAT(fails("[test\n"), Contains("job.toml:1"));
  CHECK_FALSE(fails(std::string("\0\xff", 2)).empty());
  CHECK_FALSE(fails(std::string(2'000'000, 'a')).empty());
  CHECK_THROWS_AS(JobFile::read("/nowhere/job.toml"), BadInput);
}
