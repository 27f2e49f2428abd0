// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/triaxial/read_again.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

namespace triax::study {

std::set<std::int64_t> read_again(const std::vector<TestResult>& tests) {
  using Rank = std::pair<bool, std::int64_t>;  // complete, id: the greatest counts
  std::map<std::string, std::vector<Rank>> readings;
  for (const auto& [test, curves] : tests)
    if (!test.header.digest.empty())
      readings[test.header.digest].emplace_back(test.status == db::TestStatus::complete, test.id);
  std::set<std::int64_t> left_out;
  for (const auto& [digest, ranks] : readings) {
    const Rank counted = *std::ranges::max_element(ranks);
    for (const Rank& rank : ranks)
      if (rank != counted) left_out.insert(rank.second);
  }
  return left_out;
}

}  // namespace triax::study
