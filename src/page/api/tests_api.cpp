// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/page/api/tests_api.hpp"

#include <algorithm>

#include "db/catalogue.hpp"
#include "db/connection.hpp"
#include "lab/base/bad_input.hpp"
#include "lab/base/text.hpp"
#include "src/study/json_parts.hpp"
#include "src/study/triaxial/event_json.hpp"
#include "src/study/triaxial/window.hpp"
#include "src/triaxial/content.hpp"
#include "src/triaxial/json_report.hpp"

namespace triax::src {
namespace {

using study::Json;

/// What the store has of a test.
template <class Of>
Of found(const db::Store& store, std::int64_t id, Of (db::Store::*read)(std::int64_t) const) {
  try {
    return (store.*read)(id);
  } catch (const lab::BadInput& error) {
    throw Refused(404, error.what());
  }
}

/// Of a summary what a table and a card show: lists and evidence stand in the whole document.
Json in_short(const db::StoredTest& test) {
  Json document = test_document(test);
  const auto warnings = document["warnings"].size();
  for (const char* list : {"events", "notes", "guesses", "checks"}) document.erase(list);
  document["collapse"].erase("criteria");
  document["warnings"] = warnings;
  document["programme_type"] = study::json_text(test.header.programme);
  document["material"] = study::json_text(test.header.specimen.material);
  return document;
}

/// What must not have changed for a summary that was made to stand.
std::string version_of(const db::ListedTest& test) {
  std::string version = test.name + '\n' + std::string(to_string(test.status)) + '\n' +
                        test.stored_at + '\n' + test.digest + '\n' + std::to_string(test.readings) +
                        '\n' + std::to_string(test.revision);
  for (const std::string& tag : test.tags) version += '\n' + tag;
  return version;
}

std::string summary_of(PageLaboratory& laboratory, const db::Store& store,
                       const db::ListedTest& listed) {
  return laboratory.summaries.of(listed.id, version_of(listed),
                                 [&] { return study::json_line(in_short(store.load(listed.id))); });
}

Json stages_json(const lab::RecordHeader& header) {
  Json list = Json::array();
  for (const lab::StageInfo& stage : header.stages) list.push_back(study::stage_json(stage));
  return list;
}

Json facts_json(const std::vector<Fact>& facts) {
  Json list = Json::array();
  for (const Fact& fact : facts) list.push_back({{"label", fact.label}, {"lines", fact.lines}});
  return list;
}

Json columns_json() {
  Json list = Json::array();
  for (const auto& column : db::read_columns()) list.push_back(column.name);
  return list;
}

std::vector<std::size_t> columns_asked(const std::string& names) {
  std::vector<std::size_t> columns;
  std::string_view rest = names;
  while (!rest.empty()) {
    const auto end = std::min(rest.find(','), rest.size());
    const auto found = db::find_read_column(rest.substr(0, end));
    if (!found)
      throw Refused(400, "unknown column " + lab::excerpt(rest.substr(0, end)) +
                             "; a test's document lists the columns");
    if (std::ranges::find(columns, *found) == columns.end()) columns.push_back(*found);
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return columns;
}

std::int64_t number_asked(const Target& target, std::string_view name, std::int64_t usual,
                          std::int64_t least, std::int64_t most) {
  const auto text = target.value(name);
  if (!text) return usual;
  const auto number = lab::whole_text_as<std::int64_t>(*text);
  if (!number || *number < least || *number > most)
    throw Refused(400, std::string(name) + "=" + lab::excerpt(*text) + ": expected a number from " +
                           std::to_string(least) + " to " + std::to_string(most));
  return *number;
}

/// What must not have changed for columns that were read to stand: with its end a test has readings
/// that it had not while it ran, and with a correction other states.
std::string columns_version_of(const db::TestVersion& test) {
  return test.stored_at + '\n' + test.digest + '\n' + std::string(to_string(test.status)) + '\n' +
         std::to_string(test.revision);
}

PageAnswer cut(PageLaboratory& laboratory, const db::Store& store, std::int64_t id,
               const db::TestVersion& test, const study::WindowAsked& asked) {
  const bool grows = test.status == db::TestStatus::running;
  const auto scans =
      static_cast<std::size_t>(test.status == db::TestStatus::complete ? test.readings
                                                                       : store.scan_count(id)) *
      (grows ? 2 : 1);
  constexpr std::size_t kOfWork = std::size_t{1} << 20;
  PageAnswer answer;
  laboratory.columns.with(
      id, columns_version_of(test),
      [&](const study::TestColumns& columns) {
        return columns.bytes_with(asked.columns, asked.work, scans) + kOfWork;
      },
      [&](study::TestColumns& columns) {
        columns.read(store, asked.columns, grows);
        if (asked.work) columns.read_work(store, grows);
        answer = json_answer(study::window_json(columns, asked));
      });
  return answer;
}

}  // namespace

PageAnswer list_of_tests(PageLaboratory& laboratory) {
  std::string json = "{\"tests\":[", running;
  try {
    const auto listed = db::list_tests(laboratory.db);
    const db::Store store(laboratory.db);
    for (const db::ListedTest& test : listed) {
      if (json.back() != '[') json += ',';
      json += summary_of(laboratory, store, test);
      if (test.status != db::TestStatus::running) continue;
      running += (running.empty() ? "" : ",") + std::to_string(test.id);
    }
  } catch (const db::NoDatabase&) {  // NOLINT(bugprone-empty-catch)
    // No test was stored yet.
  }
  return json_answer(json + "],\"running\":[" + running +
                     "],\"rig\":" + (laboratory.rig.empty() ? "false" : "true") +
                     ",\"record_bytes\":" + std::to_string(laboratory.record_bytes) + '}');
}

PageAnswer test_of(PageLaboratory& laboratory, std::int64_t id) {
  const db::Store store(laboratory.db);
  const study::TestResult result{found(store, id, &db::Store::load), {}};
  const TestContent content = test_content(result);
  Json document = test_document(result.stored);
  document["stages"] = stages_json(result.stored.header);
  document["title"] = content.title;
  document["banner"] = study::json_text(content.banner);
  document["facts"] = facts_json(content.facts);
  document["columns"] = columns_json();
  const auto run = laboratory.live.control_of(id);
  document["live"] = {{"running", result.stored.status == db::TestStatus::running},
                      {"controlled", run.controlled},
                      {"held", run.held}};
  return json_answer(study::json_line(document));
}

PageAnswer outline_of(PageLaboratory& laboratory, std::int64_t id) {
  constexpr std::int64_t kAll = std::int64_t{1} << 32;
  const db::Store store(laboratory.db);
  const auto test = found(store, id, &db::Store::version);
  const auto made = [&] {
    return cut(laboratory, store, id, test,
               {.from = 0, .to = kAll, .pixels = 24, .columns = columns_asked("q_kPa,p_eff_kPa")})
        .body;
  };
  if (test.status != db::TestStatus::complete) return json_answer(made());
  return json_answer(laboratory.outlines.of(id, columns_version_of(test), made));
}

PageAnswer window_of(PageLaboratory& laboratory, std::int64_t id, const Target& target) {
  constexpr std::int64_t kAll = std::int64_t{1} << 32;
  study::WindowAsked asked;
  asked.from = number_asked(target, "from", 0, 0, kAll);
  asked.to = number_asked(target, "to", kAll, 0, kAll);
  asked.pixels = static_cast<std::size_t>(number_asked(target, "pixels", 1000, 1, 8000));
  asked.columns = columns_asked(target.value("columns").value_or(
      "time_s,stage,axial_strain,volumetric_strain,q_kPa,p_eff_kPa,pore_pressure_kPa"));
  asked.work = target.value("work").value_or("0") == "1";
  const db::Store store(laboratory.db);
  return cut(laboratory, store, id, found(store, id, &db::Store::version), asked);
}

}  // namespace triax::src
