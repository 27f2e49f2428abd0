// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace triax::lab {

/// The cells of one line of AGS4 without their quotes, a doubled quote as one. A cell that a
/// spreadsheet has left without quotes ends at the next comma. Gives what is wrong with the line,
/// in words; empty if nothing is.
std::string split_ags_line(std::string_view line, std::vector<std::string>& cells);
inline constexpr const char* kRefuseAgs3 =
    "this is AGS 3 (its groups begin with **); expected AGS4: request the delivery as AGS4";

}  // namespace triax::lab
