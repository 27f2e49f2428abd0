// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <CLI/App.hpp>
#include <functional>
#include <memory>
#include <vector>

#include "src/cli/command.hpp"

namespace triax::src {

/// The whole command line, built from what its commands say of themselves. `run` is what the parsed
/// command does; empty where none was given.
struct Application {
  std::unique_ptr<CLI::App> app;
  std::shared_ptr<std::function<void()>> run;
};

Application make_application(const std::vector<Command>& commands);

}  // namespace triax::src
