// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/grains/state/grain_bytes.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <stdexcept>

#include "tests/sim/grains/packings.hpp"

using namespace triax::sim;

namespace {

GrainState in_motion() {
  GrainState state = test::lattice(4);
  test::shake(state, 0.1);
  Grains grains(state);
  grains.drive({stress_drive(1e4), strain_rate_drive(0.3), following_drive(1, -0.5)});
  grains.step(40);
  return grains.state();
}

}  // namespace

TEST_CASE("Grains: bytes hold the whole state") {
  const GrainState state = in_motion();
  const GrainState restored = load_grains(save_grains(state));
  CHECK(restored == state);
  CHECK(save_grains(restored) == save_grains(state));
  GrainState other = state;
  other.neighbours.travelled_m += 1e-9;
  CHECK(save_grains(other) != save_grains(state));
}

TEST_CASE("Grains: damaged bytes are refused, wherever the damage is") {
  const std::vector<std::byte> good = save_grains(in_motion());
  for (std::size_t at = 0; at < good.size(); at += good.size() / 97 + 1) {
    std::vector<std::byte> bad = good;
    bad[at] ^= std::byte{0x10};
    CHECK_THROWS_AS(load_grains(bad), std::invalid_argument);
  }
  for (const std::size_t size :
       {std::size_t{0}, std::size_t{7}, std::size_t{19}, good.size() / 2, good.size() - 1})
    CHECK_THROWS_AS(load_grains(std::span(good).first(size)), std::invalid_argument);
}

TEST_CASE("Grains: bytes of another version say so") {
  std::vector<std::byte> bytes = save_grains(in_motion());
  bytes[8] = std::byte{9};
  CHECK_THROWS_WITH(load_grains(bytes), "grain state of version 9, this program reads version 1");
}

TEST_CASE("Grains: a fingerprint tells states apart by a bit") {
  const GrainState state = in_motion();
  CHECK(fingerprint(state) == fingerprint(load_grains(save_grains(state))));
  GrainState other = state;
  other.grains[5].spin[2] = std::nextafter(other.grains[5].spin[2], 1.0);
  CHECK(fingerprint(other) != fingerprint(state));
}

TEST_CASE("Grains: sealed bytes are past the checksum, and what they hold is looked at") {
  std::vector<std::byte> bytes = save_grains(in_motion());
  const std::vector<std::byte> good = bytes;
  seal_grains(bytes);
  CHECK(bytes == good);
  bytes[20] = std::byte{77};  // how the stiffness is read
  CHECK_THROWS_WITH(load_grains(bytes), Catch::Contains("damaged"));
  seal_grains(bytes);
  CHECK_THROWS_WITH(load_grains(bytes), Catch::Contains("no such reading"));
  std::vector<std::byte> few(19, std::byte{1});
  seal_grains(few);
  CHECK(few == std::vector<std::byte>(19, std::byte{1}));
  std::vector<std::byte> more = good;
  more.push_back({});
  seal_grains(more);
  CHECK_THROWS_WITH(load_grains(more), Catch::Contains("after its end"));
}
