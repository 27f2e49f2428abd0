// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/live_document.hpp"

#include "db/store.hpp"
#include "src/output/table.hpp"
#include "src/triaxial/live_json.hpp"
#include "src/triaxial/live_text.hpp"

namespace triax::src {

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
