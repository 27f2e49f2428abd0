// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/records/dialect_memory.hpp"

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>

#include "lab/base/bad_input.hpp"
#include "lab/rig/recorded.hpp"
#include "tests/db/temporary_folder.hpp"

using namespace triax::lab;

namespace {

constexpr const char* kDialect =
    "name = \"mine\"\n[columns]\naxial_strain = { column = 1, unit = \"%\" }\n"
    "deviator_stress = { column = 2, unit = \"kPa\" }\n"
    "mean_effective_stress = { column = 3, unit = \"kPa\" }\n";

TableStructure table_of(std::vector<std::string> headings, std::vector<std::string> units = {}) {
  TableStructure structure;
  structure.headings = std::move(headings);
  structure.units = std::move(units);
  structure.heading_lines = {1};
  return structure;
}

std::string rows(const std::string& headings) {
  std::string text = headings + "\n";
  for (int i = 0; i < 40; ++i)
    text += std::to_string(0.1 * i) + ',' + std::to_string(2.5 * i) + ',' +
            std::to_string(100 - 0.5 * i) + '\n';
  return text;
}

}  // namespace

TEST_CASE("DialectMemory: finds what it stored for the same headings only", "[records]") {
  const triax::testing::TemporaryFolder folder;
  const DialectMemory memory(DialectMemory::folder_of(folder.file("lab.db")));
  const TableStructure table = table_of({"a", "b", "c"}, {"%", "kPa", "kPa"});
  CHECK_FALSE(memory.find(table));
  const std::string file = memory.store(DialectMemory::key_of(table), kDialect);
  CHECK(std::filesystem::path(file).parent_path() == folder.file("lab.db.dialects"));
  const auto found = memory.find(table_of({" a", "b ", "c"}, {"%", "kPa", "kPa"}));
  REQUIRE(found);
  CHECK(found->dialect.name == "mine");
  CHECK(found->file == file);
  CHECK_FALSE(memory.find(table_of({"a", "b"}, {"%", "kPa", "kPa"})));
  CHECK_FALSE(memory.find(table_of({"a", "b", "c"}, {"%", "kPa", "MPa"})));
  CHECK_FALSE(memory.find(table_of({"b", "a", "c"}, {"%", "kPa", "kPa"})));
  CHECK_FALSE(memory.find(table_of({"ab", "", "c"}, {"%", "kPa", "kPa"})));
  CHECK_FALSE(DialectMemory("").find(table));
}

TEST_CASE("DialectMemory: a later dialect replaces the earlier one", "[records]") {
  const triax::testing::TemporaryFolder folder;
  const DialectMemory memory(folder.file("d"));
  const TableStructure table = table_of({"a", "b"});
  const std::string key = DialectMemory::key_of(table);
  memory.store(key, kDialect);
  memory.store(key, std::string(kDialect).replace(8, 4, "late"));
  CHECK(memory.find(table)->dialect.name == "late");
}

TEST_CASE("DialectMemory: no heading, no key", "[records]") {
  CHECK(DialectMemory::key_of(table_of({})).empty());
  CHECK(DialectMemory::key_of(table_of({"", " "})).empty());
  TableStructure bare = table_of({"1", "2"});
  bare.heading_lines.clear();
  CHECK(DialectMemory::key_of(bare).empty());
  CHECK(DialectMemory::key_of(table_of({std::string(1 << 20, 'x')})).size() == 32);
}

TEST_CASE("DialectMemory: a key cannot be a path", "[records]") {
  const triax::testing::TemporaryFolder folder;
  const DialectMemory memory(folder.file("d"));
  for (const char* key :
       {"", "..", "../../etc/cron.d/x", "/etc/passwd", "ABCDEFABCDEFABCDEFABCDEFABCDEF12",
        "0123456789abcdef0123456789abcde/", "0123456789abcdef0123456789abcdef0"})
    CHECK_THROWS_AS(memory.store(key, kDialect), BadInput);
  CHECK_THROWS_AS(memory.store(std::string(32, 'a'), "name = "), BadInput);
  CHECK(folder.is_empty());
}

TEST_CASE("DialectMemory: a spoilt file is named", "[records]") {
  const triax::testing::TemporaryFolder folder;
  const DialectMemory memory(folder.file("d"));
  const TableStructure table = table_of({"a", "b"});
  const std::string file = memory.store(DialectMemory::key_of(table), kDialect);
  std::ofstream(file) << "name = \"mine\"\n[columns]\nnothing = { column = 1 }\n";
  CHECK_THROWS_WITH(memory.find(table), Catch::Contains(file + ":3"));
}

TEST_CASE("open_record: a remembered dialect reads a table, and says so", "[records]") {
  const triax::testing::TemporaryFolder folder;
  const std::string record = rows("kolonne A,kolonne B,kolonne C");
  const DialectMemory memory(folder.file("d"));
  RecordOptions options;
  options.dialect_folder = folder.file("d");
  CHECK_THROWS_AS(open_record(open_memory("x.csv", record), options), BadInput);
  memory.store(DialectMemory::key_of(table_of({"kolonne A", "kolonne B", "kolonne C"})), kDialect);
  const auto rig = open_record(open_memory("x.csv", record), options);
  CHECK(rig->header().dialect == "mine");
  CHECK(rig->header().has(Quantity::deviator_stress));
  REQUIRE_FALSE(rig->header().warnings.empty());
  CHECK(rig->header().warnings.front().text.find("remembered") != std::string::npos);
  Reading reading;
  REQUIRE(rig->next(reading));
  REQUIRE(rig->next(reading));
  CHECK(reading.si[index(Quantity::deviator_stress)] == Approx(2500));
}

TEST_CASE("open_record: a dialect that is given comes before a remembered one", "[records]") {
  const triax::testing::TemporaryFolder folder;
  const DialectMemory memory(folder.file("d"));
  memory.store(DialectMemory::key_of(table_of({"q1", "q2", "q3"})), kDialect);
  RecordOptions options;
  options.dialect_folder = folder.file("d");
  options.dialect_text = std::string(kDialect).replace(8, 4, "text");
  CHECK(open_record(open_memory("x.csv", rows("q1,q2,q3")), options)->header().dialect == "text");
}
