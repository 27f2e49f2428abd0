// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/calibrate/calibration_start.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "lab/base/bad_input.hpp"
#include "lab/base/text.hpp"
#include "lab/base/toml_reader.hpp"
#include "src/study/calibrate/search_space.hpp"
#include "src/study/calibrate/soil_priors.hpp"

namespace triax::study {
namespace {

const sim::LawDescription& law_called(const std::string& name) {
  if (const auto* law = sim::find_law(name)) return *law;
  std::vector<std::string> known;
  known.reserve(sim::laws().size());
  for (const auto& law : sim::laws()) known.push_back(law.name);
  throw lab::BadInput(
      fmt::format("unknown law {}; {}", lab::excerpt(name), lab::suggestion(name, known)));
}

lab::MaterialSet first_shipped(const std::string& law) {
  for (const auto& set : lab::shipped_materials())
    if (set.law->name == law) return set;
  throw lab::BadInput(
      fmt::format("the program has no parameter set of {}; give one with --start FILE.toml", law));
}

/// Of a file of sets, "FILE.toml" or "FILE.toml:SET".
CalibrationStart from_file(const std::string& law, const std::string& file,
                           const std::string& set_name, const std::string& text) {
  const auto sets = lab::read_materials(text, file);
  const auto found = std::ranges::find_if(sets, [&](const lab::MaterialSet& set) {
    return set_name.empty() || set.name == fmt::format("{}/{}", set.law->name, set_name);
  });
  if (found == sets.end())
    throw lab::BadInput(file, 0, "no parameter set " + lab::excerpt(set_name));
  if (found->law->name != law)
    throw lab::BadInput(
        file, 0, fmt::format("contains parameter sets of {}, not of {}", found->law->name, law));
  return {*found, lab::read_search(text, file), {}};
}

CalibrationStart begin_with(const StartWish& wish) {
  const std::string& start = wish.start;
  if (start.empty()) return {first_shipped(wish.law), {}, {}};
  const auto end = start.find(".toml");
  if (end == std::string::npos) {
    CalibrationStart found{lab::find_material(start), {}, {}};
    if (found.set.law->name != wish.law)
      throw lab::BadInput(fmt::format("--start {}: is a parameter set of {}, not of {}", start,
                                      found.set.law->name, wish.law));
    return found;
  }
  const std::string file = start.substr(0, end + 5);
  const std::string name = start.size() > file.size() + 1 ? start.substr(file.size() + 1) : "";
  const std::string text = lab::read_text_file(file);
  const auto root = lab::TomlTable::parse(text, file);
  if (!is_soil_result(root)) return from_file(wish.law, file, name, text);
  CalibrationStart found{first_shipped(wish.law), lab::shipped_search(wish.law), {}};
  take_soil_result(found, root);
  return found;
}

void keep_only(std::vector<lab::SearchRange>& free, const std::vector<std::string>& wanted) {
  std::vector<std::string> known;
  known.reserve(free.size());
  for (const auto& range : free) known.push_back(range.key);
  std::vector<lab::SearchRange> kept;
  for (const std::string& key : wanted) {
    const auto found = std::ranges::find(free, key, &lab::SearchRange::key);
    if (found == free.end())
      throw lab::BadInput(
          fmt::format("--free {}: has no search range; {}, or give a range under [search] in the "
                      "file of --start",
                      lab::excerpt(key), lab::suggestion(key, known)));
    kept.push_back(*found);
  }
  free = std::move(kept);
}

void fix(CalibrationStart& start, const std::string& key, const std::optional<double>& value) {
  if (value) {
    const std::string name = start.set.name;
    start.set = lab::with_parameter(start.set, key, fmt::format("{}", *value));
    start.set.name = name;
  } else if (!value_of(start.set, key)) {
    throw lab::BadInput(fmt::format("--fix {}: unknown parameter of {}", key, start.set.name));
  }
  std::erase_if(start.free, [&](const auto& range) { return range.key == key; });
}

}  // namespace

CalibrationStart calibration_start(const StartWish& wish) {
  law_called(wish.law);
  CalibrationStart start = begin_with(wish);
  if (start.free.empty()) start.free = lab::shipped_search(wish.law);
  if (start.free.empty())
    throw lab::BadInput(
        fmt::format("{} has no search ranges; give them under [search] in the file of --start, as "
                    "\"properties.1\" = [0.1, 0.6]",
                    wish.law));
  if (!wish.free.empty()) keep_only(start.free, wish.free);
  for (const auto& [key, value] : wish.fixed) fix(start, key, value);
  return start;
}

}  // namespace triax::study
