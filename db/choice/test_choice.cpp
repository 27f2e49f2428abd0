// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/choice/test_choice.hpp"

#include <fmt/format.h>

#include <variant>

#include "db/query.hpp"

namespace triax::db {
namespace {

constexpr const char* kTable =
    "SELECT t.id AS test_id, t.name AS test, t.origin, t.programme, t.status, t.source, "
    "(SELECT group_concat(g.tag, ' ') FROM tags g WHERE g.test_id = t.id) AS tags, s.material, "
    "coalesce(k.void_ratio, s.consolidated_void_ratio, s.void_ratio) AS void_ratio, "
    "k.p_eff_kPa AS p0_eff_kPa, v.kind, i.q_kPa / i.p_eff_kPa AS eta, c.cyclic_stress_ratio AS "
    "csr, "
    "(SELECT m.sweep FROM sweep_members m WHERE m.test_id = t.id LIMIT 1) AS sweep "
    "FROM tests t LEFT JOIN specimens s ON s.test_id = t.id "
    "LEFT JOIN consolidations k ON k.test_id = t.id LEFT JOIN verdicts v ON v.test_id = t.id "
    "LEFT JOIN instants i ON i.test_id = t.id AND i.kind = 'onset' "
    "LEFT JOIN cyclic_loadings c ON c.test_id = t.id";

std::string text_of(const Value& value) {
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return fmt::format("{}", *whole);
  if (const auto* number = std::get_if<double>(&value)) return fmt::format("{:g}", *number);
  return {};
}

}  // namespace

std::vector<ChosenTest> choose_tests(const std::string& path, const std::string& where,
                                     const std::string& group) {
  const std::string sql =
      fmt::format("SELECT test_id, {} FROM ({}) WHERE {} ORDER BY test_id",
                  group.empty() ? "''" : group, kTable, where.empty() ? "1" : where);
  std::vector<ChosenTest> chosen;
  query(
      path, sql, [](const std::vector<std::string>&) {},
      [&](const std::vector<Value>& row) {
        chosen.push_back({std::get<std::int64_t>(row[0]), text_of(row[1])});
      });
  return chosen;
}

}  // namespace triax::db
