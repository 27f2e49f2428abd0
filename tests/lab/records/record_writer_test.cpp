// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/records/record_writer.hpp"

#include <unistd.h>
#include <bit>
#include <catch2/catch.hpp>

#include <filesystem>
#include <random>

#include "lab/base/bad_input.hpp"
#include "lab/base/toml_reader.hpp"
#include "lab/rig/recorded.hpp"

using namespace triax::lab;

namespace {
struct Folder {
  std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("triax_writer_" + std::to_string(::getpid()));
  Folder() { std::filesystem::create_directories(path); }
  ~Folder() { std::filesystem::remove_all(path); }
  std::string operator/(const char* name) const { return (path / name).string(); }
  std::ptrdiff_t files() const {
    return std::distance(std::filesystem::directory_iterator(path), {});
  }
};

RecordHeader header_with_all_columns() {
  RecordHeader header;
  header.name = "random";
  header.origin = Origin::simulated;
  header.seed = 42;
  header.specimen.height_m = 0.14;
  header.stages = {{1, "", StageRole::consolidation, Drainage::open, AxialControl::load},
                   {2, "", StageRole::shear, Drainage::closed, AxialControl::constant_q}};
  for (const QuantityInfo& row : quantities()) header.columns.push_back(row.quantity);
  return header;
}

bool is_strain(Quantity quantity) {
  return quantity == Quantity::axial_strain || quantity == Quantity::shear_strain ||
         quantity == Quantity::axial_displacement;
}

// What an instrument of finite resolution, or a parsed file, gives: field values through to_si.
std::vector<Reading> random_readings(std::size_t count) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<Reading> readings(count);
  double time = 0;
  for (std::size_t i = 0; i < count; ++i) {
    readings[i].number = static_cast<std::int64_t>(i);
    readings[i].time_s = time += 0.1 + std::abs(uniform(random));
    readings[i].stage = i < count / 2 ? 1 : 2;
    for (const QuantityInfo& row : quantities()) {
      if (random() % 10 == 0 && i > 0) continue;
      const double mantissa = uniform(random);
      double value = std::ldexp(mantissa, static_cast<int>(random() % 43) - 30);
      // A strain that went back to its first value would begin a second test.
      if (is_strain(row.quantity)) value = 1e-4 * (static_cast<double>(i) + mantissa / 2);
      readings[i][row.quantity] = triax::sim::to_si(value, *triax::sim::find_unit(row.unit));
    }
  }
  return readings;
}
}  // namespace

TEST_CASE("a simulation says in its first line that it is one and how it is repeated") {
  const Folder folder;
  const auto path = folder / "s.csv";
  auto header = header_with_all_columns();
  header.source = "some/folder/csu_26.toml";
  const auto first_line = [&] {
    RecordWriter writer(path, header);
    writer.write(random_readings(1).front());
    writer.finish(header, {});
    const auto text = read_text_file(path);
    return text.substr(0, text.find('\n'));
  };
  CHECK(first_line() == "## simulated, not measured: triax simulate \"csu_26.toml\" --seed 42");
  header.dialect = "triax";  // replayed from a record: the source is no programme
  CHECK(first_line() == "# [test]");
  header.dialect.clear();
  header.origin = Origin::recorded;
  CHECK(first_line() == "# [test]");
}

TEST_CASE("what is written reads back to the bit, missing stays missing") {
  const Folder folder;
  const auto path = folder / "r.csv";
  const auto header = header_with_all_columns();
  const auto readings = random_readings(3000);
  Truth truth;
  truth.lost_sustainability = true;
  truth.time_s = 0.1 + 0.2;
  {
    RecordWriter writer(path, header);
    for (const Reading& reading : readings) writer.write(reading);
    CHECK_FALSE(std::filesystem::exists(path));
    writer.finish(header, truth);
  }
  CHECK(folder.files() == 1);
  const auto rig = open_record(path, {});
  CHECK(rig->header().origin == Origin::simulated);
  CHECK(rig->header().seed == 42U);
  CHECK(rig->header().columns == header.columns);
  Reading found;
  for (const Reading& reading : readings) {
    REQUIRE(rig->next(found));
    REQUIRE(found.number == reading.number);
    REQUIRE(found.stage == reading.stage);
    REQUIRE(found.time_s == reading.time_s);
    for (const QuantityInfo& row : quantities()) {
      INFO(row.name << " in line " << found.line);
      REQUIRE(found.has(row.quantity) == reading.has(row.quantity));
      if (reading.has(row.quantity))
        REQUIRE(std::bit_cast<std::uint64_t>(found[row.quantity]) ==
                std::bit_cast<std::uint64_t>(reading[row.quantity]));
    }
  }
  CHECK_FALSE(rig->next(found));
  REQUIRE(rig->truth());
  CHECK(rig->truth()->lost_sustainability);
  CHECK(rig->truth()->time_s == truth.time_s);
}

TEST_CASE("a record that is not finished leaves nothing behind, not even over an older one") {
  const Folder folder;
  const auto path = folder / "r.csv";
  const auto header = header_with_all_columns();
  const auto readings = random_readings(2);
  {
    RecordWriter writer(path, header);
    writer.write(readings[0]);
    writer.finish(header, {});
  }
  const auto size = std::filesystem::file_size(path);
  {
    RecordWriter writer(path, header);
    for (int i = 0; i < 5000; ++i) writer.write(readings[1]);
    CHECK(std::filesystem::file_size(path) == size);
  }
  CHECK(folder.files() == 1);
  CHECK(std::filesystem::file_size(path) == size);
}

TEST_CASE("a record without time has no time column; a folder that is not there is an error") {
  const Folder folder;
  auto header = header_with_all_columns();
  header.has_time = false;
  RecordWriter writer(folder / "r.csv", header);
  writer.write(random_readings(1)[0]);
  writer.finish(header, {});
  CHECK_FALSE(open_record(folder / "r.csv", {})->header().has_time);
  CHECK_THROWS_AS(RecordWriter(folder / "none/r.csv", header), BadInput);
  CHECK_THROWS_AS(RecordWriter("/dev/null", header), BadInput);
}
