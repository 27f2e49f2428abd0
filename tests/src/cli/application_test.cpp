// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/cli/application.hpp"
#include "src/commands.hpp"

#include <catch2/catch.hpp>
#include <filesystem>

#include "src/cli/command.hpp"

using namespace triax::src;

TEST_CASE(
    "every command has a purpose, a description, diagnostics, examples and described options") {
  const auto application = make_application(commands());
  REQUIRE_FALSE(commands().empty());
  for (const auto& command : commands()) {
    INFO(command.name);
    CHECK_FALSE(command.purpose.empty());
    CHECK_FALSE(command.description.empty());
    CHECK_FALSE(command.diagnostics.empty());
    CHECK_FALSE(command.examples.empty());
    for (const auto& example : command.examples)
      CHECK(example.line.rfind("triax " + command.name, 0) == 0);
    for (const auto* option : application.app->get_subcommand(command.name)->get_options()) {
      INFO(option->get_name());
      CHECK_FALSE(option->get_description().empty());
    }
  }
}

TEST_CASE("parsing a command touches no file and runs nothing by itself") {
  const auto application = make_application(commands());
  application.app->parse("report --db nowhere/none.db --output nowhere/out.txt");
  CHECK(*application.run);
  CHECK_FALSE(std::filesystem::exists("nowhere"));
}

TEST_CASE("without a command there is nothing to run; an option of another command is refused") {
  const auto application = make_application(commands());
  application.app->parse("");
  CHECK_FALSE(*application.run);
  CHECK_THROWS_AS(make_application(commands()).app->parse("report --list"), CLI::ParseError);
}
