// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/cli/help_formatter.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/Config.hpp>
#include <sstream>

#include "src/cli/option_text.hpp"
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
  label("Positionals", "Arguments");
}

std::string HelpFormatter::make_option_opts(const CLI::Option* option) const {
  if (option->get_items_expected_max() == 0) return {};  // a flag
  const bool is_list = option->get_positional() &&
                       option->get_expected_max() == CLI::detail::expected_max_vector_size;
  std::string text = is_list ? "..." : "";
  if (const std::string type = option->get_type_name(); !type.empty()) text += ' ' + type;
  if (option->get_required()) text += ' ' + get_label("REQUIRED");
  return text;
}

std::string HelpFormatter::make_option_desc(const CLI::Option* option) const {
  return lines_of(describe_option(*option), text_width() - column_width_);
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
