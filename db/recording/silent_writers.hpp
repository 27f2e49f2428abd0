// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Which writers are gone: those whose count of heartbeats stands still between two looks. No clock
// is asked, which may differ between two computers.
#include <chrono>
#include <cstdint>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "db/recording/lease.hpp"

namespace triax::db {

/// Between the two looks: a heartbeat that is due, the lock of another program in its way, and as
/// much again.
inline constexpr std::chrono::milliseconds kBetweenLooks = 3 * Lease::kBeat;

struct Looks {
  std::chrono::milliseconds between = kBetweenLooks;
  std::function<void(const std::string&)> say{};  ///< a sentence for the user before the wait
  std::vector<std::int64_t> tests{};  ///< only of these; of all tests and runs where empty
};

/// Those that hold a lease of a running test or run of grains in these databases and gave no sign
/// of life while this function looked; a lease that is new at the second look is of a living
/// writer. Waits only where there are such leases, and no longer than until all have given a sign.
/// Throws as open_for_reading().
std::set<std::string> silent_writers(const std::vector<std::string>& databases,
                                     const Looks& looks = {});

}  // namespace triax::db
