// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/rig/missed_readings.hpp"

#include <fmt/format.h>

#include <utility>

namespace triax::lab {

std::optional<std::string> MissedReadings::add(double due_s, double time_s, double interval_s) {
  const bool missed = time_s >= due_s + interval_s;
  const int before = std::exchange(late_in_a_row_, missed ? late_in_a_row_ + 1 : 0);
  if (missed && before == 1)
    return fmt::format("readings are missed repeatedly from {:.6g} s on", due_s);
  if (missed && before == 0)
    return fmt::format(
        "readings are missed from {:.6g} s to {:.6g} s: instruments or computer are too slow, or "
        "this program was suspended",
        due_s, time_s);
  if (!missed && before > 1)
    return fmt::format("readings are on time again from {:.6g} s on", time_s);
  return std::nullopt;
}

}  // namespace triax::lab
