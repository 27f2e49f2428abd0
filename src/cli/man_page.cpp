// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "src/cli/manual.hpp"
#include "src/cli/option_text.hpp"
#include "src/study/version.hpp"

namespace triax::src {
namespace {

/// Text as roff: hyphens as typed, no line that begins with a control character.
std::string roff(const std::string& text) {
  std::string out;
  bool line_start = true;
  for (const char c : text) {
    if (line_start && (c == '.' || c == '\'')) out += "\\&";
    line_start = c == '\n';
    if (c == '\\')
      out += "\\e";
    else if (c == '-')
      out += "\\-";
    else
      out += c;
  }
  return out;
}

std::string title(const std::string& page) {
  std::string capitals = page;
  for (char& c : capitals)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  return fmt::format(".TH {} 1 \"\" \"triax {}\" \"User Commands\"\n", capitals, study::version());
}

std::string option_item(const CLI::Option& option) {
  std::string names;
  if (option.get_positional() && !option.nonpositional()) {
    names = "\\fI" + roff(option.get_name(true)) + "\\fR";
  } else {
    names = "\\fB" + roff(option.get_name(false, true)) + "\\fR";
    if (option.get_items_expected_max() > 0)
      names += " \\fI" + roff(option.get_type_name()) + "\\fR";
  }
  return ".TP\n" + names + "\n" + roff(describe_option(option)) + "\n";
}

std::string options(const CLI::App& app) {
  std::string text = ".SH OPTIONS\n";
  for (const auto* option : app.get_options()) text += option_item(*option);
  return text;
}

std::string synopsis(const CLI::App& sub) {
  std::string text = "\\fBtriax " + roff(sub.get_name()) + "\\fR";
  for (const auto* option : sub.get_options()) {
    if (!option->get_positional() || option->nonpositional()) continue;
    std::string name = "\\fI" + roff(option->get_name(true)) + "\\fR";
    if (option->get_items_expected_max() > 1) name += "...";
    text += option->get_required() ? " " + name : " [" + name + "]";
  }
  return text + " [\\fIOPTION\\fR]...\n";
}

std::string exit_status(const std::vector<Example>& more = {}) {
  std::string text =
      ".SH EXIT STATUS\n.TP\n0\nsuccess\n.TP\n1\nfailure at run time\n.TP\n2\nwrong usage or "
      "invalid input: one line on standard error names the file, the line or key, what was found "
      "and what is accepted\n";
  for (const auto& status : more)
    text += ".TP\n" + roff(status.line) + "\n" + roff(status.purpose) + "\n";
  return text;
}

}  // namespace

std::string man_page(const CLI::App& app) {
  std::string text = title("TRIAX") + ".SH NAME\ntriax \\- Process triaxial tests on soil\n";
  text += ".SH SYNOPSIS\n\\fBtriax\\fR \\fICOMMAND\\fR [\\fIOPTION\\fR]...\n.SH DESCRIPTION\n" +
          roff(app.get_description()) + "\n.SH COMMANDS\n";
  for (const auto* sub : app.get_subcommands({}))
    text += ".TP\n\\fB" + roff(sub->get_name()) + "\\fR\n" + roff(sub->get_description()) + "\n";
  text += options(app) + exit_status() + ".SH SEE ALSO\n";
  std::string separator;
  for (const auto* sub : app.get_subcommands({})) {
    text += separator + "\\fBtriax\\-" + roff(sub->get_name()) + "\\fR(1)";
    separator = ", ";
  }
  return text + "\n";
}

std::string man_page(const CLI::App& sub, const Command& command) {
  std::string text = title("TRIAX\\-" + command.name) + ".SH NAME\ntriax\\-" + roff(command.name) +
                     " \\- " + roff(command.purpose) + "\n.SH SYNOPSIS\n" + synopsis(sub) +
                     ".SH DESCRIPTION\n";
  for (const auto& paragraph : command.description) text += ".PP\n" + roff(paragraph) + "\n";
  text += options(sub) + exit_status(command.statuses) + ".SH DIAGNOSTICS\n";
  for (const auto& d : command.diagnostics)
    text += ".TP\n" + roff(d.line) + "\n" + roff(d.purpose) + "\n";
  text += ".SH EXAMPLES\n";
  for (const auto& e : command.examples)
    text += ".TP\n\\fB" + roff(e.line) + "\\fR\n" + roff(e.purpose) + "\n";
  return text + ".SH SEE ALSO\n\\fBtriax\\fR(1)\n";
}

}  // namespace triax::src
