// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <CLI/App.hpp>
#include <string>
#include <vector>

namespace triax::src {

/// What is wrong with a command line that the option library did not accept, in our words: an
/// unknown command or option with the nearest known one, a value that is missing or not valid, an
/// argument too many. `arguments` is what was parsed, without the program's name.
[[nodiscard]] std::string usage_message(const CLI::App& app, const CLI::ParseError& error,
                                        const std::vector<std::string>& arguments);

/// "missing command; known: simulate, replay, ...".
[[nodiscard]] std::string missing_command(const CLI::App& app);

}  // namespace triax::src
