// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "lab/base/bad_input.hpp"
#include "src/cli/manual.hpp"
#include "src/cli/option_text.hpp"

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

/// What `triax --complete` is asked for where this option or argument takes a name of the database
/// or of the program: "tests", "ids", "materials", "queries"; empty for others.
std::string kind_of_names(const CLI::Option& option) {
  const std::string name = option.get_name(), type = option.get_type_name();
  if (name == "TEST" || type == "TEST") return "tests";
  if (name == "ID") return "ids";
  if (name == "NAME" || type == "LAW/SET") return "materials";
  if (name == "NAME|SQL") return "queries";
  return {};
}

std::string kind_of_argument(const CLI::App& app) {
  for (const auto* option : app.get_options())
    if (auto kind = kind_of_names(*option); option->get_positional() && !kind.empty())
      return kind;
  return {};
}

/// Of the first argument, where it is one of a few words; empty for others.
std::vector<std::string> values_of_argument(const CLI::App& app) {
  for (const auto* option : app.get_options())
    if (option->get_positional()) return values(*option);
  return {};
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const auto& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

/// The same in front of further words.
std::string first_words(const CLI::App& app) {
  const std::string words = joined(values_of_argument(app));
  return words.empty() ? words : words + ' ';
}

std::string bash(const CLI::App& app) {
  std::vector<std::string> names;
  std::string cases, option_values, arguments;
  for (const auto* sub : app.get_subcommands({})) {
    names.push_back(sub->get_name());
    cases += fmt::format("    {}) words=\"{}\" ;;\n", sub->get_name(), joined(option_names(*sub)));
    if (const auto kind = kind_of_argument(*sub); !kind.empty())
      arguments += fmt::format("    {}) words=\"{}$(_triax_names {})\" ;;\n", sub->get_name(),
                               first_words(*sub), kind);
    for (const auto* option : sub->get_options()) {
      if (option->get_lnames().empty()) continue;
      const auto kind = kind_of_names(*option);
      if (values(*option).empty() && kind.empty()) continue;
      option_values += fmt::format(
          "    {}:--{}) words=\"{}\"; only=1 ;;\n", sub->get_name(), option->get_lnames().front(),
          kind.empty() ? joined(values(*option)) : fmt::format("$(_triax_names {})", kind));
    }
  }
  return fmt::format(R"bash(# bash completion of triax, written by triax itself
_triax_names() {{  # of the database that --db names on this line
  local i db=triax.db
  for ((i = 1; i < COMP_CWORD; ++i)); do
    [ "${{COMP_WORDS[i]}}" = --db ] && db=${{COMP_WORDS[i+1]}}
  done
  "${{COMP_WORDS[0]}}" --complete "$1" "$db" 2>/dev/null
}}
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
    words=""
    case ${{COMP_WORDS[1]}} in
{}    esac
    COMPREPLY=($(compgen -W "$words" -- "$current"))
    [ -n "$words" ] || COMPREPLY=($(compgen -f -- "$current"))
  fi
}}
complete -o filenames -F _triax triax
)bash",
                     joined(names), joined(option_names(app)), cases, option_values, arguments);
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

/// The action of _arguments that completes such names.
std::string zsh_names(const std::string& kind) { return "{_triax_names " + kind + "}"; }

std::string zsh(const CLI::App& app) {
  std::string names, cases;
  for (const auto* sub : app.get_subcommands({})) {
    names +=
        fmt::format("    '{}:{}'\n", sub->get_name(), zsh_escaped(sub->get_description(), ":"));
    cases += fmt::format("    {}) _arguments", sub->get_name());
    for (const auto* option : sub->get_options()) {
      const std::string text = zsh_escaped(describe_option(*option), "[]:");
      const bool takes_value = option->get_items_expected_max() > 0;
      const auto choices = values(*option);
      const std::string kind = kind_of_names(*option);
      const std::string action = !kind.empty()     ? zsh_names(kind)
                                 : choices.empty() ? "_files"
                                                   : "(" + joined(choices) + ")";
      for (const auto& name : option->get_lnames())
        cases += fmt::format(" \\\n      '--{}[{}]{}'", name, text,
                             takes_value ? ":value:" + action : "");
    }
    if (const auto words = values_of_argument(*sub); !words.empty())
      cases += fmt::format(" \\\n      '1:word:({})'", joined(words));
    const std::string kind = kind_of_argument(*sub);
    cases += fmt::format(" \\\n      '*:{}' ;;\n",
                         kind.empty() ? "file:_files" : "name:" + zsh_names(kind));
  }
  std::string own;
  for (const auto& name : option_names(app)) own += " " + name;
  return fmt::format(R"zsh(#compdef triax
# zsh completion of triax, written by triax itself
_triax_names() {{  # of the database that --db names on this line
  local db=triax.db
  (( $words[(I)--db] )) && db=$words[$words[(I)--db]+1]
  local -a names=(${{(f)"$(triax --complete $1 $db 2>/dev/null)"}})
  compadd -a names
}}
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
)zsh",
                     names, own, cases);
}

std::string fish(const CLI::App& app) {
  std::string text = R"(# fish completion of triax, written by triax itself
function __triax_names  # of the database that --db names on this line
    set -l words (commandline -opc)
    set -l db triax.db
    set -l at (contains -i -- --db $words); and set db $words[(math $at + 1)]
    triax --complete $argv[1] $db 2>/dev/null
end
)";
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
                            sub->get_name(), name, escaped(describe_option(*option), "'"));
        if (const auto kind = kind_of_names(*option); !kind.empty())
          text += fmt::format(" -x -a '(__triax_names {})'", kind);
        else if (const auto choices = values(*option); !choices.empty())
          text += fmt::format(" -x -a '{}'", joined(choices));
        else if (option->get_items_expected_max() > 0)
          text += " -r";
        text += "\n";
      }
    if (const auto words = values_of_argument(*sub); !words.empty())
      text += fmt::format("complete -c triax -n '__fish_seen_subcommand_from {}' -a '{}'\n",
                          sub->get_name(), joined(words));
    if (const auto kind = kind_of_argument(*sub); !kind.empty())
      text += fmt::format(
          "complete -c triax -n '__fish_seen_subcommand_from {}' -a '(__triax_names {})'\n",
          sub->get_name(), kind);
  }
  return text;
}

}  // namespace

std::string completion_script(const CLI::App& app, const std::string& shell) {
  if (shell == "bash") return bash(app);
  if (shell == "zsh") return zsh(app);
  if (shell == "fish") return fish(app);
  throw lab::BadInput(fmt::format("no completion for '{}'; known: bash, zsh, fish", shell));
}

}  // namespace triax::src
