// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Man pages and shell completion, written from the same command line that --help prints.
#include <CLI/App.hpp>
#include <string>

#include "src/cli/command.hpp"

namespace triax::src {

/// The page triax(1): what it is, its commands, exit status.
std::string man_page(const CLI::App& app);
/// The page triax-COMMAND(1).
std::string man_page(const CLI::App& sub, const Command& command);
/// A completion script; `shell` is "bash", "zsh" or "fish". Throws lab::BadInput for another.
std::string completion_script(const CLI::App& app, const std::string& shell);

/// Writes triax.1, triax-COMMAND.1 … and triax.bash, _triax, triax.fish into the folder.
void write_manual(const CLI::App& app, const std::vector<Command>& commands,
                  const std::string& folder);

}  // namespace triax::src
