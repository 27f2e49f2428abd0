// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/triaxial/read_again.hpp"

#include "src/study/triaxial/tests_origin.hpp"

#include <catch2/catch.hpp>

#include "tests/src/sample_tests.hpp"

using namespace triax;
using namespace triax::study;
namespace sample = triax::src::test;

namespace {

TestResult reading_of(const std::string& digest, std::int64_t id,
                      db::TestStatus status = db::TestStatus::complete) {
  auto test = sample::simulated_test();
  test.stored.id = id;
  test.stored.status = status;
  test.stored.header.digest = digest;
  return test;
}

using Ids = std::set<std::int64_t>;

}  // namespace

TEST_CASE("of several readings of one file the latest that is complete counts") {
  using enum db::TestStatus;
  CHECK(read_again(std::vector<TestResult>{}).empty());
  CHECK(read_again({reading_of("", 1), reading_of("", 2), reading_of("a", 3)}).empty());
  CHECK(read_again({reading_of("a", 1), reading_of("b", 2), reading_of("a", 3)}) == Ids{1});
  CHECK(read_again({reading_of("a", 3), reading_of("a", 1)}) == Ids{1});
  CHECK(read_again({reading_of("a", 1), reading_of("a", 2, interrupted),
                    reading_of("a", 3, running)}) == Ids{2, 3});
  CHECK(read_again({reading_of("a", 1, interrupted), reading_of("a", 2, running)}) == Ids{1});
  CHECK(read_again({reading_of("a", 1), reading_of("a", 1)}).empty());  // one test, asked for twice
}

TEST_CASE("counts and origins are those of the tests that count") {
  const std::vector<TestResult> tests{reading_of("a", 1),
                                      reading_of("a", 2, db::TestStatus::interrupted),
                                      reading_of("", 3, db::TestStatus::interrupted)};
  const TestCounts counts = counts_of(tests);
  CHECK(counts.tests == 2);
  CHECK(counts.simulated == 2);
  CHECK(counts.interrupted == 1);
  CHECK(counts.read_again == 1);
  CHECK(origin_of(tests).tests == 2);
}
