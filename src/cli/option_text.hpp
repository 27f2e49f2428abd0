// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <CLI/App.hpp>
#include <string>

namespace triax::src {

/// The description of an option as help, man pages and completion show it: with the default in
/// brackets, "database of tests [triax.db]". A default that the option itself does not have, as
/// "[all cores]", is part of its description.
[[nodiscard]] std::string describe_option(const CLI::Option& option);

}  // namespace triax::src
