// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/records/back_pressure_check.hpp"

#include <fmt/format.h>

namespace triax::lab {

void check_back_pressure(const Reading& reading, const StageInfo* stage, bool begins_stage,
                         Findings& findings) {
  constexpr double kKilopascal = 1e3;
  const double back = reading[Quantity::back_pressure], cell = reading[Quantity::cell_pressure];
  if (!(back - cell > kMaxBackPressureExcess_pa)) return;
  const bool is_closed = stage != nullptr && stage->drainage == Drainage::closed;
  if (is_closed && !begins_stage) return;
  findings.note("back pressure", reading.line, [&] {
    return fmt::format(
        "the back pressure, {:.6g} kPa, is above the cell pressure, {:.6g} kPa: the specimen would "
        "not be confined; check the units and the order of the columns",
        back / kKilopascal, cell / kKilopascal);
  });
}

}  // namespace triax::lab
