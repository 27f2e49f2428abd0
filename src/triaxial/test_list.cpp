// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/test_list.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "lab/base/text.hpp"
#include "src/output/table.hpp"
#include "src/output/terminal.hpp"
#include "src/output/words.hpp"
#include "src/study/json_parts.hpp"
#include "src/triaxial/facts/verdict_fact.hpp"

namespace triax::src {
namespace {

/// "2026-11-23 06:39" of an ISO 8601 time: seconds say nothing in a list.
std::string to_the_minute(std::string time) {
  constexpr std::size_t kMinute = 16;
  if (time.size() > kMinute) time.resize(kMinute);
  std::ranges::replace(time, 'T', ' ');
  return time;
}

study::Json listed_json(const db::ListedTest& test) {
  return {
      {"id", test.id},
      {"name", test.name},
      {"origin", lab::to_string(test.origin)},
      {"programme", study::json_text(test.programme)},
      {"status", db::to_string(test.status)},
      {"last_sign_of_life", test.sign_of_life ? study::Json(test.sign_of_life->at) : study::Json()},
      {"kind", test.kind ? study::Json(lab::to_string(*test.kind)) : study::Json(nullptr)},
      {"readings", test.readings},
      {"stored_at", study::json_text(test.stored_at)},
      {"source", study::json_text(test.source)},
      {"digest", study::json_text(test.digest)},
      {"counted", test.counted},
      {"revision", test.revision},
      {"tags", test.tags}};
}

}  // namespace

std::string test_list_text(const std::vector<db::ListedTest>& tests) {
  Table table{{{"ID", Align::right},
               {"Test"},
               {"Origin"},
               {"Type of test"},
               {"Collapse"},
               {"Readings", Align::right},
               {"Stored (UTC)"},
               {"Tags"}},
              {}};
  for (const db::ListedTest& test : tests)
    table.rows.push_back({fmt::format("{}", test.id), test.name,
                          test.origin == lab::Origin::simulated ? "SIMULATED" : "recorded",
                          test.programme.empty() ? kUnknown : test.programme,
                          verdict_word(test.status, test.kind), fmt::format("{}", test.readings),
                          to_the_minute(test.stored_at), lab::joined(test.tags)});
  std::string text = to_text(table, text_width());
  const auto again = std::ranges::count(tests, false, &db::ListedTest::counted);
  if (again > 0)
    text += fmt::format(
        "\n{} of these {}: the file was replayed again, and statistics use the latest replay\n",
        again, again == 1 ? "does not count" : "do not count");
  return text;
}

std::string test_list_json(const std::vector<db::ListedTest>& tests) {
  study::Json list = study::Json::array();
  for (const db::ListedTest& test : tests) list.push_back(listed_json(test));
  return study::json_document(list);
}

std::string test_in_words(const db::ListedTest& test) {
  return fmt::format("test {} {}", test.id, lab::excerpt(test.name));
}

}  // namespace triax::src
