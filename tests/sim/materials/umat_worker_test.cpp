// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/materials/umat_worker.hpp"

#include <catch2/catch.hpp>
#include <thread>
#include <vector>

#include "tests/sim/materials/umat_fixture.hpp"

using namespace triax::sim;
using namespace triax::sim::test;

namespace {

UmatPlugin cone(Misbehaviour misbehaviour = Misbehaviour::none) {
  const ParameterSet set = umat_fixture(misbehaviour);
  return {kUmatFixture, "CONE", set.lists.at("properties"), 12, 5};
}

}  // namespace

TEST_CASE("a call leaves in the arguments what the plug-in wrote, and nothing if it crashed") {
  if (!umat_fixture_is_there()) return;
  UmatWorker worker(cone());
  UmatCall call;
  call.strain_increment = {-1e-4, 0, 0, 2e-4, 0, 0};
  REQUIRE(worker.call(call).empty());
  CHECK(call.stress[0] == Approx(-1e-4 * (kBulk + 4 * kShear / 3)));
  CHECK(call.stress[3] == Approx(2e-4 * kShear));
  CHECK(call.tangent[3 + 6 * 3] == Approx(kShear));

  UmatWorker fragile(cone(Misbehaviour::null_pointer));
  UmatCall untouched;
  untouched.stress = {-1, -2, -3, 0, 0, 0};
  untouched.strain_increment = {-1e-4, 0, 0, 0, 0, 0};
  CHECK_FALSE(fragile.call(untouched).empty());
  CHECK(untouched.stress[2] == -3);
}

TEST_CASE("several threads may use one plug-in") {
  if (!umat_fixture_is_there()) return;
  UmatWorker worker(cone());
  std::vector<std::thread> threads;
  std::array<int, 4> right{};
  for (std::size_t k = 0; k < right.size(); ++k)
    threads.emplace_back([&, k] {
      for (int i = 0; i < 500; ++i) {
        UmatCall call;
        call.strain_increment[3] = 1e-6 * static_cast<double>(k + 1);
        if (worker.call(call).empty() &&
            std::abs(call.stress[3] - kShear * call.strain_increment[3]) < 1e-12)
          ++right[k];
      }
    });
  for (auto& thread : threads) thread.join();
  for (const int count : right) CHECK(count == 500);
}
