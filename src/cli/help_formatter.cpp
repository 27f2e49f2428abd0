// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/cli/help_formatter.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/Config.hpp>
#include <sstream>

#include "src/output/terminal.hpp"
#include "src/output/wrapping.hpp"

namespace triax::src {
namespace {

std::string lines_of(const std::string& text, std::size_t width) {
  return fmt::format("{}", fmt::join(wrapped(text, width), "\n"));
}

}  // namespace

HelpFormatter::HelpFormatter() {
  column_width(34);
  label("REQUIRED", "(required)");
  label("SUBCOMMAND", "COMMAND");
}

std::string HelpFormatter::make_option_desc(const CLI::Option* option) const {
  return lines_of(option->get_description(), text_width() - column_width_);
}

std::string HelpFormatter::make_subcommand(const CLI::App* command) const {
  std::ostringstream out;
  CLI::detail::format_help(out, command->get_name(),
                           lines_of(command->get_description(), text_width() - column_width_),
                           column_width_);
  return out.str();
}

std::string HelpFormatter::make_description(const CLI::App* app) const {
  return lines_of(app->get_description(), text_width()) + '\n';
}

}  // namespace triax::src
