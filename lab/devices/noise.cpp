// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/devices/noise.hpp"

#include <cmath>
#include <numbers>

namespace triax::lab {
namespace {

/// Finaliser of SplitMix64 (Steele, Lea and Flood 2014): every input bit reaches every output bit.
std::uint64_t mixed(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15U;
  x = (x ^ (x >> 30U)) * 0xbf58476d1ce4e5b9U;
  x = (x ^ (x >> 27U)) * 0x94d049bb133111ebU;
  return x ^ (x >> 31U);
}

/// In (0, 1), never 0.
double uniform(std::uint64_t bits) { return (static_cast<double>(bits >> 11U) + 0.5) * 0x1p-53; }

std::uint64_t key_of(std::uint64_t seed, std::uint64_t stream, std::uint64_t number) {
  return mixed(mixed(mixed(seed) ^ stream) ^ number);
}

}  // namespace

double standard_uniform(std::uint64_t seed, std::uint64_t stream, std::uint64_t number) {
  return uniform(key_of(seed, stream, number));
}

double standard_normal(std::uint64_t seed, std::uint64_t stream, std::uint64_t number) {
  const std::uint64_t key = key_of(seed, stream, number);
  // Box and Muller (1958)
  return std::sqrt(-2 * std::log(uniform(key))) *
         std::cos(2 * std::numbers::pi * uniform(mixed(key)));
}

}  // namespace triax::lab
