// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The code page of a text that is not Unicode.
#include <string>
#include <string_view>

namespace triax::lab {

/// Name (encoding_names()) of the code page in which the bytes above 0x7F are the most likely
/// letters and signs of headings. `last` is empty or another part of the same file.
std::string find_code_page(std::string_view first, std::string_view last);

}  // namespace triax::lab
