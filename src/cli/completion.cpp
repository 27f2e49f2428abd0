#include <fmt/format.h>

#include "lab/base/bad_input.hpp"
#include "src/cli/manual.hpp"

namespace triax::src {
namespace {

/// Every option's names as typed: "--db", "-h".
std::vector<std::string> option_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const auto* option : app.get_options()) {
    for (const auto& name : option->get_snames()) names.push_back("-" + name);
    for (const auto& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

/// The values of an option whose type is written a|b|c in small letters; empty for free ones.
std::vector<std::string> values(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  std::vector<std::string> all;
  if (type.find('|') == std::string::npos) return all;
  for (std::size_t start = 0; start <= type.size();) {
    const auto end = std::min(type.find('|', start), type.size());
    const std::string value = type.substr(start, end - start);
    if (value.find_first_not_of("abcdefghijklmnopqrstuvwxyz") == std::string::npos)
      all.push_back(value);
    start = end + 1;
  }
  return all;
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const auto& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

std::string bash(const CLI::App& app) {
  std::vector<std::string> names;
  std::string cases, option_values;
  for (const auto* sub : app.get_subcommands({})) {
    names.push_back(sub->get_name());
    cases += fmt::format("    {}) words=\"{}\" ;;\n", sub->get_name(), joined(option_names(*sub)));
    for (const auto* option : sub->get_options())
      if (!values(*option).empty() && !option->get_lnames().empty())
        option_values += fmt::format("    {}:--{}) words=\"{}\"; only=1 ;;\n", sub->get_name(),
                                     option->get_lnames().front(), joined(values(*option)));
  }
  return fmt::format(R"(# bash completion of triax, written by triax itself
_triax() {{
  local current=${{COMP_WORDS[COMP_CWORD]}} previous=${{COMP_WORDS[COMP_CWORD-1]}} words="" only=""
  if [ "$COMP_CWORD" -eq 1 ]; then
    COMPREPLY=($(compgen -W "{} {}" -- "$current"))
    return
  fi
  case ${{COMP_WORDS[1]}} in
{}  esac
  case ${{COMP_WORDS[1]}}:$previous in
{}  esac
  if [ -n "$only" ] || [[ $current == -* ]]; then
    COMPREPLY=($(compgen -W "$words" -- "$current"))
  else
    COMPREPLY=($(compgen -f -- "$current"))
  fi
}}
complete -o filenames -F _triax triax
)",
                     joined(names), joined(option_names(app)), cases, option_values);
}

/// Text inside single quotes of fish.
std::string escaped(std::string text, const std::string& special) {
  for (std::size_t i = 0; i < text.size(); ++i)
    if (special.find(text[i]) != std::string::npos) text.insert(i++, 1, '\\');
  return text;
}

/// The same for zsh, whose single quotes hold everything but their own end.
std::string zsh_escaped(const std::string& text, const std::string& special) {
  std::string out;
  for (const char c : escaped(text, special)) {
    if (c == '\'')
      out += "'\\''";
    else
      out += c;
  }
  return out;
}

std::string zsh(const CLI::App& app) {
  std::string names, cases;
  for (const auto* sub : app.get_subcommands({})) {
    names +=
        fmt::format("    '{}:{}'\n", sub->get_name(), zsh_escaped(sub->get_description(), ":"));
    cases += fmt::format("    {}) _arguments", sub->get_name());
    for (const auto* option : sub->get_options()) {
      const std::string text = zsh_escaped(option->get_description(), "[]:");
      const bool takes_value = option->get_items_expected_max() > 0;
      const auto choices = values(*option);
      const std::string action = choices.empty() ? "_files" : "(" + joined(choices) + ")";
      for (const auto& name : option->get_lnames())
        cases += fmt::format(" \\\n      '--{}[{}]{}'", name, text,
                             takes_value ? ":value:" + action : "");
    }
    cases += " \\\n      '*:file:_files' ;;\n";
  }
  std::string own;
  for (const auto& name : option_names(app)) own += " " + name;
  return fmt::format(R"(#compdef triax
# zsh completion of triax, written by triax itself
_triax() {{
  local -a commands=(
{}  )
  if (( CURRENT == 2 )); then
    _describe command commands
    compadd --{}
    return
  fi
  local command=$words[2]
  shift words
  (( CURRENT-- ))
  case $command in
{}  esac
}}
_triax "$@"
)",
                     names, own, cases);
}

std::string fish(const CLI::App& app) {
  std::string text = "# fish completion of triax, written by triax itself\n";
  for (const auto& name : option_names(app))
    text +=
        fmt::format("complete -c triax -n __fish_use_subcommand -{} {}\n",
                    name.starts_with("--") ? 'l' : 's', name.substr(name.find_first_not_of('-')));
  for (const auto* sub : app.get_subcommands({})) {
    text += fmt::format("complete -c triax -n __fish_use_subcommand -a {} -d '{}'\n",
                        sub->get_name(), escaped(sub->get_description(), "'"));
    for (const auto* option : sub->get_options())
      for (const auto& name : option->get_lnames()) {
        text += fmt::format("complete -c triax -n '__fish_seen_subcommand_from {}' -l {} -d '{}'",
                            sub->get_name(), name, escaped(option->get_description(), "'"));
        if (const auto choices = values(*option); !choices.empty())
          text += fmt::format(" -x -a '{}'", joined(choices));
        else if (option->get_items_expected_max() > 0)
          text += " -r";
        text += "\n";
      }
  }
  return text;
}

}  // namespace

std::string completion_script(const CLI::App& app, const std::string& shell) {
  if (shell == "bash") return bash(app);
  if (shell == "zsh") return zsh(app);
  if (shell == "fish") return fish(app);
  throw lab::BadInput(fmt::format("no completion for '{}': bash, zsh or fish", shell));
}

}  // namespace triax::src
