// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

#include "lab/base/bad_input.hpp"
#include "lab/programmes/programme_reader.hpp"
#include "tests/lab/programmes/programme_text.hpp"

namespace triax::lab::test {

/// The small programme with these lines in its [rig], the first of them in line 14.
inline Programme with_rig(const std::string& lines) {
  return read_programme(programme_text("", "back_pressure_kPa = 300.0\n" + lines + R"(
[[stages]]
name = "rest"
role = "consolidation"
drainage = "open"
axial = "free"
end = [{quantity = "time_s", above = 10.0}]
)"),
                        "p.toml");
}

/// What the reader says of them.
inline std::string complaint_of_rig(const std::string& lines) {
  try {
    with_rig(lines);
  } catch (const BadInput& error) {
    return error.what();
  }
  return "accepted";
}

}  // namespace triax::lab::test
