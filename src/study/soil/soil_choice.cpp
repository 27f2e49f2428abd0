// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/soil/soil_choice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "db/choice/test_choice.hpp"
#include "db/store.hpp"
#include "lab/base/bad_input.hpp"

namespace triax::study {
namespace {

constexpr std::size_t kFewest = 3;

void refuse_several_materials(const SoilGroup& group) {
  std::map<std::string, int> materials;
  for (const auto& test : group.tests)
    if (!test.material.empty()) ++materials[test.material];
  if (materials.size() < 2) return;
  std::string list;
  for (const auto& [name, count] : materials)
    list += fmt::format("{}{} ({})", list.empty() ? "" : ", ", name, count);
  throw lab::BadInput(
      fmt::format("the tests are of {} materials: {}; choose one with --where \"material = '{}'\", "
                  "or use --group material for one result per material",
                  materials.size(), list, materials.begin()->first));
}

void refuse_too_few(const SoilGroup& group) {
  if (group.tests.size() >= kFewest) return;
  throw lab::BadInput(fmt::format(
      "there {} only {} test{}{}; trends and intervals need at least {}",
      group.tests.size() == 1 ? "is" : "are", group.tests.size(),
      group.tests.size() == 1 ? "" : "s", group.name.empty() ? "" : " of " + group.name, kFewest));
}

}  // namespace

std::vector<SoilGroup> chosen_groups(const SoilChoice& choice, const std::function<void()>& look) {
  const db::Store store(choice.db);
  std::set<std::int64_t> asked;
  for (const auto id : store.find(choice.tests)) asked.insert(id);
  std::map<std::string, SoilGroup> groups;
  for (const auto& [id, name] : db::choose_tests(choice.db, choice.where, choice.group)) {
    if (!asked.contains(id)) continue;
    look();
    auto& group = groups[name];
    group.name = name;
    group.tests.push_back(load_sheared_test(store, id));
  }
  if (groups.empty())
    throw lab::BadInput("no test " +
                        (choice.where.empty()
                             ? std::string("in the database")
                             : "matches --where; `triax soil --help` lists the columns"));
  std::vector<SoilGroup> all;
  for (auto& [name, group] : groups) {
    refuse_several_materials(group);
    refuse_too_few(group);
    if (choice.group.empty() && !group.tests.empty()) group.name = group.tests.front().material;
    all.push_back(std::move(group));
  }
  return all;
}

std::vector<Soil> study_soils(const SoilChoice& choice, const SoilOptions& options,
                              const std::function<void()>& look) {
  std::vector<Soil> soils;
  const auto groups = chosen_groups(choice, look);
  soils.reserve(groups.size());
  for (const auto& group : groups) {
    look();
    soils.push_back(study_soil(group.tests, group.name, options));
  }
  return soils;
}

}  // namespace triax::study
