// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/triaxial/read_again.hpp"

#include <algorithm>
#include <map>
#include <string>

namespace triax::study {

std::set<std::int64_t> read_again(const std::vector<const db::StoredTest*>& tests) {
  std::map<std::string, std::vector<RankOfReading>> readings;
  for (const db::StoredTest* const test : tests)
    if (!test->header.digest.empty())
      readings[test->header.digest].emplace_back(test->status == db::TestStatus::complete,
                                                 test->id);
  std::set<std::int64_t> left_out;
  for (const auto& [digest, ranks] : readings) {
    const RankOfReading counted = *std::ranges::max_element(ranks);
    for (const RankOfReading& rank : ranks)
      if (rank != counted) left_out.insert(rank.second);
  }
  return left_out;
}

std::set<std::int64_t> read_again(const std::vector<TestResult>& tests) {
  std::vector<const db::StoredTest*> stored;
  stored.reserve(tests.size());
  for (const auto& test : tests) stored.push_back(&test.stored);
  return read_again(stored);
}

}  // namespace triax::study
