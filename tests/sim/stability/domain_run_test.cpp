// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/stability/domain_run.hpp"

#include <atomic>
#include <catch2/catch.hpp>
#include <numeric>
#include <set>
#include <stdexcept>

#include "sim/stability/domain_criteria.hpp"
#include "tests/sim/stability/domain_laws.hpp"

using namespace triax::sim;
using namespace triax::sim::test;

namespace {

const DomainGrid kGrid{.p_from = 20e3,
                       .p_to = 200e3,
                       .columns = 11,
                       .q_from = -80e3,
                       .q_to = 160e3,
                       .rows = 16,
                       .void_ratio = 1.05,
                       .directions = 36};

Material material() { return {std::make_shared<Interpolated<Axisymmetric>>(inl2()), {}, {}, {}}; }

std::vector<int> all_columns() {
  std::vector<int> columns(static_cast<std::size_t>(kGrid.columns));
  std::iota(columns.begin(), columns.end(), 0);
  return columns;
}

std::vector<std::optional<double>> numbers(const DomainColumn& c) {
  std::vector<std::optional<double>> all{static_cast<double>(c.column), c.p};
  for (const DomainBoundary& b : {c.compression, c.extension})
    all.insert(all.end(), {b.first_unstable_q, b.first_unstable_angle, b.isotropic_unloading_q,
                           b.other_q("determinant"), b.other_q("localisation"), b.limit_q});
  for (const DomainState& s : c.states) {
    all.insert(all.end(), {s.q, static_cast<double>(s.kind), s.least_work, s.least_angle,
                           static_cast<double>(s.refused_directions)});
    for (const Sector& cone : s.cones) all.insert(all.end(), {cone.from, cone.to});
  }
  return all;
}

/// Throws where a column of one p′ is asked for.
class Failing : public Interpolated<Axisymmetric> {
 public:
  Failing() : Interpolated(inl2()) {}
  State start(const Vector<Axisymmetric>& stress, double e) const override {
    if (mean_stress<Axisymmetric>(stress) > 100e3) throw std::logic_error("no such state");
    return Interpolated::start(stress, e);
  }
};

}  // namespace

TEST_CASE("the number of threads does not show in a single bit", "[threads]") {
  // Localisation is dear, so that it is looked for in two of the columns only.
  const std::vector<int> few{4, 9};
  const auto run = [](const std::vector<int>& columns, int threads,
                      const std::vector<std::string>& criteria) {
    return run_domain(kGrid, columns,
                      [&] {
                        DomainWorker worker{interpolated(Interpolation::inl2, kInl2), {}};
                        worker.criteria = domain_criteria(worker.material, kGrid, criteria);
                        return worker;
                      },
                      {.threads = threads, .progress = {}});
  };
  const auto same = [](const std::vector<DomainColumn>& a, const std::vector<DomainColumn>& b) {
    REQUIRE(a.size() == b.size());
    for (std::size_t i = 0; i < a.size(); ++i) CHECK(numbers(a[i]) == numbers(b[i]));
  };
  const auto one = run(all_columns(), 1, {});
  REQUIRE(one.size() == 11);
  for (const int threads : {2, 3, 64}) same(run(all_columns(), threads, {}), one);
  const auto localised = run(few, 1, {"localisation"});
  same(run(few, 2, {"localisation"}), localised);
  CHECK(localised[0].compression.other_q("determinant"));

  // And every column is what it is alone.
  const Material alone = interpolated(Interpolation::inl2, kInl2);
  for (std::size_t i = 0; i < one.size(); ++i)
    CHECK(numbers(one[i]) == numbers(domain_column(alone, kGrid, static_cast<int>(i),
                                                   domain_criteria(alone, kGrid, {}))));
  CHECK(numbers(localised[0]) ==
        numbers(domain_column(alone, kGrid, 4, domain_criteria(alone, kGrid, {"localisation"}))));
}

TEST_CASE("each thread gets a material of its own, and no more threads than columns are started",
          "[threads]") {
  int made = 0;
  const auto factory = [&made] {
    ++made;
    return DomainWorker{material(), {}};
  };
  CHECK(run_domain(kGrid, {1, 5, 7}, factory, {.threads = 2, .progress = {}}).size() == 3);
  CHECK(made == 2);
  made = 0;
  CHECK(run_domain(kGrid, {3}, factory, {.threads = 8, .progress = {}}).front().column == 3);
  CHECK(made == 1);
  CHECK(run_domain(kGrid, {}, factory, {.threads = 8, .progress = {}}).empty());
}

TEST_CASE("an error of a column reaches the caller", "[threads]") {
  const auto factory = [] { return DomainWorker{{std::make_shared<Failing>(), {}, {}, {}}, {}}; };
  CHECK_THROWS_WITH(run_domain(kGrid, all_columns(), factory, {.threads = 3, .progress = {}}),
                    "no such state");
}

TEST_CASE("a run can be ended on the way, and tells how far it is", "[threads]") {
  DomainGrid large = kGrid;
  large.rows = 4000;
  std::vector<double> shares;
  const auto columns = run_domain(large, all_columns(),
                                  [] {
                                    return DomainWorker{material(), {}};
                                  },
                                  {.threads = 2, .progress = [&](double share) {
                                     shares.push_back(share);
                                     return shares.size() < 2;
                                   }});
  CHECK(columns.empty());
  REQUIRE(shares.size() == 2);
  CHECK(shares[0] >= 0);
  CHECK(shares[1] < 1);
}

TEST_CASE("the pieces of a domain are all of its columns, each once, of even number") {
  for (const int count : {1, 2, 3, 7, 11}) {
    std::multiset<int> found;
    for (int index = 1; index <= count; ++index) {
      const auto columns = columns_of_piece(kGrid, index, count);
      CHECK(columns.size() >= static_cast<std::size_t>(kGrid.columns / count));
      CHECK(columns.size() <= static_cast<std::size_t>(kGrid.columns / count + 1));
      found.insert(columns.begin(), columns.end());
    }
    const auto all = all_columns();
    CHECK(found == std::multiset<int>(all.begin(), all.end()));
  }
  CHECK_THROWS_AS(columns_of_piece(kGrid, 0, 3), std::invalid_argument);
  CHECK_THROWS_AS(columns_of_piece(kGrid, 4, 3), std::invalid_argument);
}
