// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A programme run once more without its guard: what the guard was good for.
#include <cstdint>
#include <functional>
#include <optional>

#include "lab/programmes/programme.hpp"
#include "lab/results/summary.hpp"

namespace triax::lab {

/// For SessionOptions::without_guard: the same programme and seed give the same readings up to
/// where the guard acted. Told to nobody; `stop` as in the session. Empty where there is no guard.
std::function<GuardOutcome::Without()> without_guard(const Programme& programme,
                                                     std::optional<std::uint64_t> seed,
                                                     std::function<bool()> stop = {});

}  // namespace triax::lab
