// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/cli/candidates.hpp"

#include <algorithm>
#include <exception>
#include <variant>
#include <vector>

#include "db/query.hpp"
#include "lab/materials/material_library.hpp"
#include "src/output/table.hpp"

namespace triax::src {
namespace {

std::vector<std::string> test_names(const std::string& db) {
  std::vector<std::string> names;
  db::query(
      db, "SELECT DISTINCT name FROM tests ORDER BY name", [](const auto&) {},
      [&](const std::vector<db::Value>& row) {
        if (const auto* name = std::get_if<std::string>(&row.front())) names.push_back(*name);
      });
  for (std::string& name : names) std::ranges::replace(name = on_one_line(name), ' ', '_');
  return names;
}

std::vector<std::string> test_ids(const std::string& db) {
  std::vector<std::string> ids;
  db::query(
      db, "SELECT CAST(id AS TEXT) FROM tests ORDER BY id", [](const auto&) {},
      [&](const std::vector<db::Value>& row) {
        ids.push_back(std::get<std::string>(row.front()));
      });
  return ids;
}

std::vector<std::string> names_of(const std::string& kind, const std::string& db) {
  std::vector<std::string> names;
  if (kind == "tests") return test_names(db);
  if (kind == "ids") return test_ids(db);
  if (kind == "materials")
    for (const auto& set : lab::shipped_materials()) names.push_back(set.name);
  if (kind == "queries")
    for (const auto& query : db::named_queries()) names.emplace_back(query.name);
  return names;
}

}  // namespace

std::string candidates(const std::string& kind, const std::string& db) {
  std::string text;
  try {
    for (const std::string& name : names_of(kind, db)) text += name + '\n';
  } catch (const std::exception&) {
    return {};
  }
  return text;
}

}  // namespace triax::src
