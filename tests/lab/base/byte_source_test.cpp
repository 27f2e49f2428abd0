// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/base/byte_source.hpp"

#include <array>
#include <catch2/catch.hpp>

#include "lab/base/bad_input.hpp"

using namespace triax::lab;

namespace {
std::string all_of(ByteSource& source) {
  std::string out;
  std::array<char, 7> block{};
  while (const auto count = source.read(block)) out.append(block.data(), count);
  return out;
}
}  // namespace

TEST_CASE("memory is read in blocks, to its end, and again after rewind") {
  const auto source = open_memory("m", "0123456789");
  CHECK(source->name() == "m");
  CHECK(source->size() == 10);
  CHECK(all_of(*source) == "0123456789");
  CHECK(all_of(*source).empty());
  source->rewind();
  CHECK(all_of(*source) == "0123456789");
}

TEST_CASE("a file is read like memory") {
  const auto file = open_file("samples/dialects/my_lab_record.txt");
  const auto text = all_of(*file);
  CHECK(text.starts_with("Probe;"));
  CHECK(text.size() == file->size());
  file->rewind();
  CHECK(all_of(*file) == text);
}

TEST_CASE("ByteSource: a duplicate of a file reads from the first byte by itself") {
  auto file = open_file("samples/dialects/my_lab_record.txt");
  file->skip(100);
  const auto duplicate = file->duplicate();
  REQUIRE(duplicate);
  CHECK(duplicate->name() == file->name());
  const auto text = all_of(*duplicate);
  CHECK(text.size() == file->size());
  CHECK(all_of(*file) == text.substr(100));
  file.reset();
  duplicate->rewind();
  CHECK(all_of(*duplicate) == text);
}

TEST_CASE("what is no readable file is refused with the reason") {
  CHECK_THROWS_WITH(open_file("samples"), Catch::Contains("samples: is a folder"));
  CHECK_THROWS_WITH(open_file("samples/none.csv"), Catch::Contains("file does not exist"));
  CHECK_THROWS_WITH(open_file("/dev/null"), Catch::Contains("not a regular file"));
  CHECK_THROWS_AS(open_file("samples"), BadInput);
}
