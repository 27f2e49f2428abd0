// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>

namespace triax::lab {

/// A standard normal number (mean 0, rms 1) that is a pure function of its three arguments: the
/// same on every platform, whatever was drawn before. Streams and seeds are independent of each
/// other.
double standard_normal(std::uint64_t seed, std::uint64_t stream, std::uint64_t number);

/// The same for a number that is uniform over 0 to 1, both excluded. Of the same arguments it is
/// not independent of standard_normal.
double standard_uniform(std::uint64_t seed, std::uint64_t stream, std::uint64_t number);

}  // namespace triax::lab
