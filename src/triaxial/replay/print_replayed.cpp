// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/replay/print_replayed.hpp"

#include "db/store.hpp"
#include "src/output/output.hpp"
#include "src/output/terminal.hpp"
#include "src/reference/reference_json.hpp"
#include "src/reference/reference_text.hpp"
#include "src/triaxial/json_report.hpp"
#include "src/triaxial/live_json.hpp"
#include "src/triaxial/print_tests.hpp"

namespace triax::src {
namespace {

study::Json replayed_json(const std::string& db, const std::vector<std::int64_t>& ids,
                          const ReferenceFiles& references, bool live) {
  study::Json all = study::Json::array();
  if (!ids.empty()) {
    const db::Store store(db);
    for (const auto id : ids)
      all.push_back(live ? live_json(store, id)
                         : study::Json::parse(json_of_test(
                               study::load_test_result(store, id, study::WithCurves::no))));
  }
  for (const lab::AgsResults& file : references.all()) all.push_back(reference_json(file));
  return all.size() == 1 ? study::Json(all.front()) : all;
}

}  // namespace

void print_replayed(const std::string& db, const std::vector<std::int64_t>& ids,
                    const ReferenceFiles& references, bool json, bool live) {
  if (json && !references.all().empty()) {
    print(study::json_document(replayed_json(db, ids, references, live)));
    return;
  }
  if (!ids.empty() && live) print(live_document(db, ids, json));
  if (!ids.empty() && !live) print_tests(db, ids, json);
  bool first = ids.empty();
  for (const lab::AgsResults& file : references.all()) {
    print((first ? "" : "\n") + reference_text(file, db, text_width()));
    first = false;
  }
}

}  // namespace triax::src
