// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/triaxial/tests_of_file.hpp"

#include <catch2/catch.hpp>
#include <string>
#include <vector>

using namespace triax;
using namespace triax::study;

namespace {

lab::TestsInFile file_with(std::size_t tests, bool is_beside = false) {
  lab::TestsInFile out;
  for (std::size_t i = 0; i < tests; ++i) {
    out.names.push_back("test " + std::to_string(i + 1));
    out.tables.push_back({.block = is_beside ? i + 1 : 0, .name = out.names.back()});
  }
  return out;
}

struct Reader {
  std::size_t in_sample = 0, in_all_rows = 0;
  std::vector<std::size_t> read{};
  std::vector<std::string> faults{};

  template <class Read>
  void run(Read read_one) {
    read_tests(
        [this](lab::Extent extent) {
          return file_with(extent == lab::Extent::sample ? in_sample : in_all_rows);
        },
        [&](const TestOfFile& test) {
          read_one(test);
          read.push_back(test.number);
        },
        [this](const lab::BadInput& error) { faults.emplace_back(error.what()); });
  }
};

}  // namespace

TEST_CASE("read_tests: each test of a file, in order") {
  Reader several{.in_sample = 3};
  several.run([](const TestOfFile& test) { CHECK(test.all->names.size() == 3); });
  CHECK(several.read == std::vector<std::size_t>{1, 2, 3});
  Reader one{};
  one.run([](const TestOfFile& test) { CHECK(test.options({}).test == 0); });
  CHECK(one.read == std::vector<std::size_t>{0});
}

TEST_CASE("read_tests: a later test that the sample does not show") {
  Reader late{.in_all_rows = 2};
  late.run([](const TestOfFile& test) {
    if (test.number == 0) throw lab::SeveralTests("f", 9, "a second test");
  });
  CHECK(late.read == std::vector<std::size_t>{1, 2});
  Reader single{.in_all_rows = 1};
  CHECK_THROWS_AS(
      single.run([](const TestOfFile&) { throw lab::SeveralTests("f", 9, "a second test"); }),
      lab::SeveralTests);
}

TEST_CASE("read_tests: a fault of one of several is reported, of the only one thrown") {
  Reader several{.in_sample = 3};
  several.run([](const TestOfFile& test) {
    if (test.number == 2) throw lab::BadInput("no height");
  });
  CHECK(several.read == std::vector<std::size_t>{1, 3});
  CHECK(several.faults == std::vector<std::string>{"no height"});
  Reader one{};
  CHECK_THROWS_AS(one.run([](const TestOfFile&) { throw lab::BadInput("no height"); }),
                  lab::BadInput);
}

TEST_CASE("test_of_block: the table that is chosen, else the first test") {
  const auto beside = tests_of(file_with(3, true));
  CHECK(test_of_block(beside, 2).number == 2);
  CHECK(test_of_block(beside, 9).number == 1);
  CHECK(test_of_block(tests_of(file_with(2)), 0).number == 1);
  CHECK(test_of_block(tests_of({}), 2).number == 0);
}
