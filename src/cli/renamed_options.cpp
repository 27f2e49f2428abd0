// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/cli/renamed_options.hpp"

#include <algorithm>
#include <string_view>

namespace triax::src {
namespace {

struct Renamed {
  std::string_view command, before, today;
};

constexpr Renamed kRenamed[] = {{"domain", "--threads", "--jobs"},
                                {"grains", "--threads", "--jobs"},
                                {"probe", "--p", "--p-kPa"},
                                {"probe", "--q", "--q-kPa"},
                                {"materials", "--file", "--materials"},
                                {"element", "--csv", "--output"}};

}  // namespace

std::vector<std::string> with_names_of_today(std::vector<std::string> arguments) {
  if (arguments.empty()) return arguments;
  const std::string command = arguments.front();
  for (std::string& argument : arguments) {
    const std::string name = argument.substr(0, argument.find('='));
    const auto* renamed = std::ranges::find_if(kRenamed, [&](const Renamed& option) {
      return option.command == command && option.before == name;
    });
    if (renamed != std::end(kRenamed)) argument.replace(0, name.size(), renamed->today);
  }
  return arguments;
}

}  // namespace triax::src
