// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/element/path_json.hpp"

#include "src/element/path_words.hpp"
#include "src/study/json_parts.hpp"

namespace triax::src {
namespace {

study::Json point_json(const study::PathResult& path, const study::ResultPoint& at) {
  study::Json object;
  object["segment"] = study::json_text(at.segment);
  for (std::size_t i = 0; i < path.columns.size(); ++i)
    object[path.columns[i]] =
        i < at.values.size() ? study::json_number(at.values[i]) : study::Json(nullptr);
  return object;
}

}  // namespace

std::string path_json(const study::PathResult& path) {
  study::Json document = {{"path",
                           {{"name", path.name},
                            {"origin", "simulated"},
                            {"source", path.source},
                            {"tolerance", path.tolerance}}},
                          {"material", study::json_material(path.material)},
                          {"start", point_json(path, path.start)},
                          {"outcome", word_of(path.outcome)},
                          {"limiting_variable", study::json_text(path.limiting_variable)},
                          {"message", study::json_text(path.message)},
                          {"error", study::json_number(path.error)},
                          {"peak", path.peak ? point_json(path, *path.peak) : study::Json(nullptr)},
                          {"last", point_json(path, path.last)}};
  study::Json events = study::Json::array();
  for (const auto& event : path.events)
    events.push_back(
        {{"kind", word_of(event.kind)}, {"what", event.what}, {"at", point_json(path, event.at)}});
  document["events"] = std::move(events);
  document["warnings"] = path.warnings;
  study::Json rows = study::Json::array();
  for (const auto& row : path.rows) rows.push_back(point_json(path, row));
  document["rows"] = std::move(rows);
  return study::json_document(document);
}

}  // namespace triax::src
