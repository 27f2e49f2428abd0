// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string_view>

namespace triax::study {

/// The version of the program and its libraries, as in "1.2.3": that of project() in
/// CMakeLists.txt.
std::string_view version();

}  // namespace triax::study
