// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/print_tests.hpp"

#include <utility>

#include "db/store.hpp"
#include "src/output/output.hpp"
#include "src/output/table.hpp"
#include "src/triaxial/json_report.hpp"
#include "src/triaxial/live_json.hpp"
#include "src/triaxial/live_text.hpp"
#include "src/triaxial/text_report.hpp"

namespace triax::src {

std::string text_for_people(std::vector<study::TestResult> tests) {
  for (study::TestResult& test : tests) {
    std::string& name = test.stored.header.name;
    name = on_one_line(std::move(name));
  }
  return without_controls(text_report(tests));
}

void print_tests(const std::string& db, const std::vector<std::int64_t>& ids, bool json) {
  const db::Store store(db);
  std::vector<study::TestResult> tests;
  tests.reserve(ids.size());
  for (const auto id : ids)
    tests.push_back(study::load_test_result(store, id, study::WithCurves::no));
  print(json ? json_report(tests) : text_for_people(std::move(tests)));
}

std::string live_document(const std::string& db, const std::vector<std::int64_t>& ids, bool json) {
  const db::Store store(db);
  if (json) {
    study::Json all = study::Json::array();
    for (const auto id : ids) all.push_back(live_json(store, id));
    return study::json_document(all.size() == 1 ? study::Json(all.front()) : all);
  }
  std::string text;
  for (const auto id : ids) {
    db::StoredTest test = store.load(id);
    test.header.name = on_one_line(std::move(test.header.name));
    text += (text.empty() ? "" : "\n") + live_text(test, study::live_account(store, test));
  }
  return without_controls(text);
}

}  // namespace triax::src
