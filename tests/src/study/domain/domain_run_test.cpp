// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/domain/domain_run.hpp"

#include <catch2/catch.hpp>

#include "src/study/domain/domain_piece.hpp"
#include "tests/src/sample_domain.hpp"

using namespace triax;

namespace {

study::DomainRequest sample_request() {
  return {.material = study::sample_material(),
          .grid = study::sample_domain({}).settings.grid,
          .threads = 1};
}

}  // namespace

TEST_CASE("a domain run has the columns of its grid, whatever the number of threads") {
  auto request = sample_request();
  const auto one = study::run_domain(request, [&](const std::string& what, double share) {
    CHECK(what == "domain");
    CHECK(share <= 1);
  });
  CHECK(one.columns.size() == 3);
  const auto sample = study::sample_domain();  // the same columns, without further criteria
  for (std::size_t i = 0; i < 3; ++i)
    CHECK(one.columns[i].compression.first_unstable->q_kPa ==
          sample.columns[i].compression.first_unstable->q_kPa);
  request.threads = 3;
  CHECK(study::domain_json(study::run_domain(request)) == study::domain_json(one));
}

TEST_CASE("a piece of a domain run has every N-th column from its own on") {
  auto request = sample_request();
  request.piece = 2;
  request.pieces = 2;
  const auto second = study::run_domain(request);
  REQUIRE(second.columns.size() == 1);
  CHECK(second.columns[0].column == 1);
  request.piece = 1;
  const auto first = study::run_domain(request);
  REQUIRE(first.columns.size() == 2);
  CHECK(first.columns[1].column == 2);
}
