// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <CLI/App.hpp>
#include <functional>
#include <memory>
#include <vector>

#include "src/cli/command.hpp"

namespace triax::src {

/// The whole command line, built from the descriptions of its commands. `run` executes the parsed
/// command; it is empty if none was given.
struct Application {
  std::unique_ptr<CLI::App> app;
  std::shared_ptr<std::function<void()>> run;
};

Application make_application(const std::vector<Command>& commands);

}  // namespace triax::src
