#pragma once
#include <CLI/App.hpp>
#include <functional>
#include <memory>

namespace triax::src {

/// The whole command line, built from commands(). `run` is what the parsed command does; empty
/// where none was given.
struct Application {
  std::unique_ptr<CLI::App> app;
  std::shared_ptr<std::function<void()>> run;
};

Application make_application();

}  // namespace triax::src
