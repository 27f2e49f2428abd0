// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/domain/domain_counts.hpp"

#include <catch2/catch.hpp>

#include <numeric>

#include "tests/src/sample_domain.hpp"

using namespace triax;

TEST_CASE("the kinds of states are counted; a map of refusals has no answer") {
  auto domain = study::sample_domain();
  const auto counts = study::counts_of_kinds(domain);
  CHECK(std::accumulate(counts.begin(), counts.end(), 0) == 36);
  using enum sim::DomainStateKind;
  int stable_states = 0;
  for (const auto& column : domain.columns)
    for (const auto& state : column.states) stable_states += state.kind == stable;
  CHECK(stable_states > 0);
  CHECK(counts.at(static_cast<std::size_t>(stable)) == stable_states);
  CHECK(study::any_answer(domain));
  for (auto& column : domain.columns)
    for (auto& state : column.states) state.kind = refused;
  CHECK_FALSE(study::any_answer(domain));
  CHECK(study::counts_of_kinds(domain).at(static_cast<std::size_t>(refused)) == 36);
}
