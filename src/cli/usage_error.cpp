// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/cli/usage_error.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "lab/base/text.hpp"

namespace triax::src {
namespace {

std::vector<std::string> command_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const auto* sub : app.get_subcommands({})) names.push_back(sub->get_name());
  return names;
}

std::vector<std::string> long_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const auto* option : app.get_options())
    for (const auto& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

const CLI::App* command_of(const CLI::App& app, const std::string& name) {
  for (const auto* sub : app.get_subcommands({}))
    if (sub->get_name() == name) return sub;
  return nullptr;
}

/// The option that a message of the library begins with: "--seed: ...", "TEST: ...".
const CLI::Option* option_of(const CLI::App& command, const std::string& message) {
  const std::string name = message.substr(0, message.find_first_of(": "));
  for (const auto* option : command.get_options())
    if (option->get_name() == name || option->check_name(name)) return option;
  return nullptr;
}

bool looks_like_option(const std::string& text) {
  return text.size() > 1 && text[0] == '-' && !lab::whole_text_as<double>(text);
}

std::string as_typed(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  return option.get_name() + (option.get_positional() || type.empty() ? "" : " " + type);
}

/// "missing --record OUT.csv (the file to write)".
std::string missing_option(const CLI::App& command, const std::string& name) {
  const auto* option = option_of(command, name);
  if (option == nullptr) return "missing " + name;
  // A description can have a default in brackets, or go on with details.
  const std::string text = option->get_description();
  const std::string_view brief =
      lab::trimmed(std::string_view(text).substr(0, text.find_first_of(";[(")));
  return fmt::format("missing {}{}", as_typed(*option),
                     brief.empty() ? std::string() : fmt::format(" ({})", brief));
}

/// Choices of an option whose type is written a|b|c.
std::vector<std::string> choices(const std::string& type) {
  std::vector<std::string> all(1);
  for (const char c : type)
    if (c == '|')
      all.emplace_back();
    else
      all.back() += c;
  return all;
}

std::string superfluous(const CLI::App& command, const std::string& named) {
  const auto rest = command.remaining(true);
  for (const auto& text : rest)
    if (looks_like_option(text)) {
      const std::string name = text.substr(0, text.find('='));
      const std::string near = lab::nearest(name, long_names(command));
      return fmt::format("unknown option {}{}", name,
                         near.empty() ? std::string() : fmt::format("; did you mean {}?", near));
    }
  return fmt::format("unexpected argument {}: too many arguments for {}",
                     lab::excerpt(rest.empty() ? "" : rest.front()), named);
}

/// "1 to 1024" from the two forms of the library: "1 to 1024" (2.3) and "[1 - 1024]" (2.4).
std::string range_text(std::string range) {
  std::erase_if(range, [](char c) { return c == '[' || c == ']'; });
  for (const std::string_view between : {" to ", " - "}) {
    const auto at = range.find(between);
    if (at == std::string::npos) continue;
    const auto low = lab::whole_text_as<double>(range.substr(0, at));
    const auto high = lab::whole_text_as<double>(range.substr(at + between.size()));
    if (low && high) return fmt::format("{:.15g} to {:.15g}", *low, *high);
  }
  return range;
}

std::string not_valid(const CLI::Option& option, const std::string& message) {
  const auto& given = option.results();
  const std::string value = lab::excerpt(given.empty() ? "" : given.back());
  const std::string type = option.get_type_name();
  constexpr std::string_view kRange = "not in range ";
  const bool number = !given.empty() && lab::whole_text_as<double>(given.back());
  if (const auto range = message.find(kRange); range != std::string::npos && number)
    return fmt::format("{}: {} is out of range; expected {}", option.get_name(), value,
                       range_text(message.substr(range + kRange.size())));
  if (type.find('|') != std::string::npos)
    return fmt::format("{}: {}", option.get_name(),
                       lab::invalid_value(given.empty() ? "" : given.back(), choices(type)));
  constexpr std::string_view kSet = " not in {";  // of an argument that is one of a few words
  if (const auto set = message.find(kSet); set != std::string::npos) {
    const auto words = message.substr(set + kSet.size());
    return fmt::format("{}: {} is not valid; must be one of: {}", option.get_name(), value,
                       words.substr(0, words.find('}')));
  }
  return fmt::format("{}: {} is not valid; expected {}", option.get_name(), value,
                     as_typed(option));
}

std::string fault(const CLI::App& app, const CLI::App* command, const CLI::ParseError& error,
                  const std::string& first) {
  std::string message = error.what();
  if (command == nullptr) {
    return looks_like_option(first) ? superfluous(app, "triax")
                                    : fmt::format("unknown command {}; {}", lab::excerpt(first),
                                                  lab::suggestion(first, command_names(app)));
  }
  const std::string named = "triax " + command->get_name();
  // An option that is not known is said first: what else is missing may have been meant by it.
  if (std::ranges::any_of(command->remaining(true), looks_like_option))
    return superfluous(*command, named);
  if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr) return superfluous(*command, named);
  const auto name_end = message.find(" is required");
  if (dynamic_cast<const CLI::RequiredError*>(&error) != nullptr && name_end != std::string::npos)
    return missing_option(*command, message.substr(0, name_end));
  constexpr std::string_view kConversion = "Could not convert: ";
  const bool conversion = message.starts_with(kConversion);
  const CLI::Option* option =
      option_of(*command, conversion ? message.substr(kConversion.size()) : message);
  if (option == nullptr) return message;
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr)
    return option->get_items_expected_max() == 0
               ? fmt::format("{} takes no value", option->get_name())
               : fmt::format("{}: expected one value, {}", option->get_name(), as_typed(*option));
  // Messages of our own validators stand as they are.
  const bool raw = conversion || message.find(" not in ") != std::string::npos ||
                   message.find("could not be converted") != std::string::npos ||
                   message.find("Check ") != std::string::npos;
  return raw ? not_valid(*option, message) : message;
}

}  // namespace

std::string missing_command(const CLI::App& app) {
  return "missing command; " + lab::must_be_one_of(command_names(app));
}

std::string usage_message(const CLI::App& app, const CLI::ParseError& error,
                          const std::vector<std::string>& arguments) {
  const std::string first = arguments.empty() ? "" : arguments.front();
  const CLI::App* command = command_of(app, first);
  return fmt::format("{} (see triax {}--help)", fault(app, command, error, first),
                     command != nullptr ? first + ' ' : "");
}

}  // namespace triax::src
