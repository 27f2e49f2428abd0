// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/triaxial/tests_origin.hpp"

#include <algorithm>

#include "src/study/triaxial/read_again.hpp"
#include "src/study/triaxial/test_result.hpp"

namespace triax::study {

void TestsOrigin::add(const db::StoredTest& test) {
  const auto& header = test.header;
  ++tests;
  if (last_believed_reading(test)) cut.push_back(header.name);
  if (header.origin != lab::Origin::simulated) return;
  simulated.push_back(header.name);
  const auto& material = header.specimen.material;
  if (!material.empty() &&
      std::find(materials.begin(), materials.end(), material) == materials.end())
    materials.push_back(material);
}

TestsOrigin origin_of(const std::vector<TestResult>& tests) {
  TestsOrigin origin;
  const auto left_out = read_again(tests);
  for (const auto& test : tests)
    if (!left_out.contains(test.stored.id)) origin.add(test.stored);
  return origin;
}

}  // namespace triax::study
