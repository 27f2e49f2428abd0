// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/wire/personality.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "lab/base/bad_input.hpp"
#include "lab/base/embedded.hpp"
#include "lab/base/text.hpp"
#include "lab/base/toml_reader.hpp"

namespace triax::lab {

std::string_view to_text(Protocol protocol) {
  switch (protocol) {
    case Protocol::scpi:
      return "scpi";
    case Protocol::modbus:
      return "modbus";
    case Protocol::lines:
      break;
  }
  return "lines";
}

bool PersonalityScan::chooses() const {
  const auto names_channels = [](const std::string& text) {
    return text.find("{at}") != std::string::npos;
  };
  return names_channels(ask) || std::ranges::any_of(prepare, names_channels);
}

bool Personality::speaks(Protocol protocol) const {
  return std::ranges::find(protocols, protocol) != protocols.end();
}

const PersonalityPoint* Personality::find(std::string_view point) const {
  const auto found = std::ranges::find(points, point, &PersonalityPoint::name);
  return found == points.end() ? nullptr : &*found;
}

const PersonalityPoint& Personality::at(std::string_view point) const {
  if (const auto* found = find(point)) return *found;
  std::vector<std::string> names;
  for (const auto& one : points) names.push_back(one.name);
  throw BadInput(
      fmt::format("{} has no value {}; {}", title, excerpt(point),
                  names.empty() ? "its channels are numbered: at = 1" : suggestion(point, names)));
}

std::string Personality::complaint_about(std::string_view text) const {
  const auto said = trimmed(text);
  if (!identity.begins.empty() && !said.starts_with(identity.begins))
    return fmt::format("the identity is {}; that of a {} begins with '{}'", excerpt(said), title,
                       identity.begins);
  if (!identity.holds.empty() && said.find(identity.holds) == std::string_view::npos)
    return fmt::format("the identity is {}; that of a {} contains '{}'", excerpt(said), title,
                       identity.holds);
  return {};
}

const std::vector<Personality>& shipped_personalities() {
  static const std::vector<Personality> all = [] {
    std::vector<Personality> made;
    for (const EmbeddedFile& file : kShippedPersonalities)
      made.push_back(parse_personality(file.text, std::string(file.name) + ".toml"));
    std::ranges::sort(made, {}, &Personality::name);
    return made;
  }();
  return all;
}

Personality find_personality(const std::string& name_or_file) {
  if (name_or_file.ends_with(".toml"))
    return parse_personality(read_text_file(name_or_file), name_or_file);
  std::vector<std::string> names;
  for (const Personality& one : shipped_personalities()) {
    if (one.name == name_or_file) return one;
    names.push_back(one.name);
  }
  throw BadInput(fmt::format("unknown instrument profile {}; {}; or give the path of a .toml file",
                             excerpt(name_or_file), suggestion(name_or_file, names)));
}

}  // namespace triax::lab
