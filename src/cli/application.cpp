// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/cli/application.hpp"

#include <CLI/Config.hpp>

#include "src/cli/help_formatter.hpp"
#include "src/study/version.hpp"

namespace triax::src {
namespace {

std::string help_footer(const Command& command) {
  std::string text;
  if (!command.statuses.empty())
    text += "Exit status (0 success, 1 failure at run time, 2 wrong usage or invalid input):\n";
  for (const auto& status : command.statuses)
    text += "  " + status.line + "  " + status.purpose + "\n";
  text += text.empty() ? "Examples:\n" : "\nExamples:\n";
  for (const auto& example : command.examples)
    text += "  " + example.line + "\n      " + example.purpose + "\n";
  return text;
}

}  // namespace

Application make_application(const std::vector<Command>& commands) {
  Application application{
      std::make_unique<CLI::App>("triax processes triaxial tests on soil and reports whether, when "
                                 "and at what stress ratio a specimen became unstable.",
                                 "triax"),
      std::make_shared<std::function<void()>>()};
  CLI::App& app = *application.app;
  app.set_help_flag("--help,-h", "print this help and exit");
  app.set_version_flag("--version", "triax " + std::string(study::version()),
                       "print the version and exit");
  app.formatter(std::make_shared<HelpFormatter>());
  app.footer(
      "Exit status: 0 success, 1 failure at run time, 2 wrong usage or invalid input.\n"
      "See triax COMMAND --help or man triax-COMMAND for more.");
  for (const auto& command : commands) {
    CLI::App* sub = app.add_subcommand(command.name, command.purpose);
    sub->group("Commands");
    sub->footer(help_footer(command));
    const auto run = command.set_up(*sub);
    sub->callback([slot = application.run, run] { *slot = run; });
  }
  app.require_subcommand(0, 1);
  return application;
}

}  // namespace triax::src
