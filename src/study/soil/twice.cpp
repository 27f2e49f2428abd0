// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/soil/twice.hpp"

#include <fmt/format.h>

#include <cmath>

#include "src/study/triaxial/read_again.hpp"

namespace triax::study {
namespace {

/// A value that is not known in either is no difference.
bool same_value(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

bool same_states(const ShearedTest& a, const ShearedTest& b) {
  if (a.states.size() != b.states.size() || a.states.empty()) return false;
  for (std::size_t i = 0; i < a.states.size(); ++i)
    if (!same_value(a.states[i].q, b.states[i].q) ||
        !same_value(a.states[i].p_eff, b.states[i].p_eff) ||
        !same_value(a.states[i].strain.axial, b.states[i].strain.axial))
      return false;
  return true;
}

bool same(const ShearedTest& a, const ShearedTest& b) {
  return a.id == b.id || (!a.digest.empty() && a.digest == b.digest) || same_states(a, b);
}

bool counts_before(const ShearedTest& a, const ShearedTest& b) {
  return RankOfReading(a.complete, a.id) > RankOfReading(b.complete, b.id);
}

}  // namespace

void leave_out_twice(const std::vector<ShearedTest>& tests, std::vector<TestPoints>& points) {
  for (std::size_t i = 0; i < tests.size(); ++i)
    for (std::size_t j = 0; j < tests.size(); ++j) {
      if (i == j || !points[i].used || !points[j].used || !same(tests[i], tests[j])) continue;
      if (!counts_before(tests[j], tests[i]) && !(tests[i].id == tests[j].id && j < i)) continue;
      points[i].used = false;
      points[i].reason =
          fmt::format("the same test as {} ({}), which replaces it", tests[j].id, tests[j].name);
    }
}

}  // namespace triax::study
