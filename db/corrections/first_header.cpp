// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/corrections/first_header.hpp"

#include <SQLiteCpp/Statement.h>
#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <string>

#include "db/columns.hpp"
#include "lab/base/bad_input.hpp"
#include "lab/records/metadata.hpp"

namespace triax::db {
namespace {

using Json = nlohmann::json;

Json number_or_null(const std::optional<double>& value) {
  return value ? Json(*value) : Json(nullptr);
}

std::optional<double> number_of(const Json& json) {
  return json.is_number() ? std::optional(json.get<double>()) : std::nullopt;
}

Json specimen_of(const lab::SpecimenInfo& specimen) {
  Json json = {{"material", specimen.material}};
  for (const lab::SpecimenKey& key : lab::specimen_keys())
    json[std::string(key.name)] = number_or_null(specimen.*key.member);
  return json;
}

lab::SpecimenInfo read_specimen_of(const Json& json) {
  lab::SpecimenInfo specimen;
  specimen.material = json.at("material").get<std::string>();
  for (const lab::SpecimenKey& key : lab::specimen_keys())
    if (const auto found = json.find(std::string(key.name)); found != json.end())
      specimen.*key.member = number_of(*found);
  return specimen;
}

Json stage_of(const lab::StageInfo& stage) {
  return {{"number", stage.number},
          {"name", stage.name},
          {"role", to_string(stage.role)},
          {"drainage", to_string(stage.drainage)},
          {"control", to_string(stage.control)},
          {"strain_path_R", number_or_null(stage.strain_path_R)},
          {"drainage_was_said", stage.drainage_was_said}};
}

lab::StageInfo read_stage_of(const Json& json) {
  lab::StageInfo stage;
  stage.number = json.at("number").get<int>();
  stage.name = json.at("name").get<std::string>();
  stage.role = lab::stage_role_from(json.at("role").get<std::string>()).value();
  stage.drainage = lab::drainage_from(json.at("drainage").get<std::string>()).value();
  stage.control = lab::axial_control_from(json.at("control").get<std::string>()).value();
  stage.strain_path_R = number_of(json.at("strain_path_R"));
  stage.drainage_was_said = json.at("drainage_was_said").get<bool>();
  return stage;
}

Json guess_of(const lab::Guess& guess) {
  Json otherwise = Json::array();
  for (const auto& said : guess.otherwise) otherwise.push_back({said.key, said.value});
  return {{"what", guess.what},
          {"taken", guess.taken},
          {"evidence", guess.evidence},
          {"remedy", guess.remedy},
          {"otherwise", std::move(otherwise)}};
}

lab::Guess read_guess_of(const Json& json) {
  lab::Guess guess{.what = json.at("what").get<std::string>(),
                   .taken = json.at("taken").get<std::string>(),
                   .evidence = json.at("evidence").get<std::string>(),
                   .remedy = json.at("remedy").get<std::string>()};
  for (const Json& said : json.at("otherwise"))
    guess.otherwise.push_back({said.at(0).get<std::string>(), said.at(1).get<std::string>()});
  return guess;
}

Json earlier_of(const lab::EarlierTest& test) {
  return {{"name", test.name},
          {"by_law", test.by_law},
          {"control", static_cast<int>(test.control)},
          {"in_extension", test.in_extension},
          {"give", test.give},
          {"onset", number_or_null(test.onset)},
          {"onset_error", test.onset_error},
          {"min_work", test.min_work}};
}

lab::EarlierTest read_earlier_of(const Json& json) {
  return {.name = json.at("name").get<std::string>(),
          .by_law = json.at("by_law").get<bool>(),
          .control = static_cast<lab::DrivenPath::Control>(json.at("control").get<int>()),
          .in_extension = json.at("in_extension").get<bool>(),
          .give = json.at("give").get<double>(),
          .onset = number_of(json.at("onset")),
          .onset_error = json.at("onset_error").get<double>(),
          .min_work = json.at("min_work").get<double>()};
}

template <class List, class Part>
Json list_of(const List& list, const Part& part) {
  Json json = Json::array();
  for (const auto& one : list) json.push_back(part(one));
  return json;
}

Json header_json(const lab::RecordHeader& header, const lab::EarlierTests& earlier) {
  return {{"programme", header.programme},
          {"cut_short", header.cut_short},
          {"specimen", specimen_of(header.specimen)},
          {"stages", list_of(header.stages, stage_of)},
          {"vouched",
           list_of(header.vouched, [](lab::Quantity channel) { return lab::info(channel).name; })},
          {"notes", list_of(header.notes,
                            [](const lab::Note& note) {
                              return Json{note.label, note.text};
                            })},
          {"guesses", list_of(header.guesses, guess_of)},
          {"earlier", list_of(earlier.all(), earlier_of)}};
}

FirstHeader read_header(const Json& json) {
  FirstHeader first;
  lab::RecordHeader& header = first.header;
  header.programme = json.at("programme").get<std::string>();
  header.cut_short = json.at("cut_short").get<std::string>();
  header.specimen = read_specimen_of(json.at("specimen"));
  for (const Json& stage : json.at("stages")) header.stages.push_back(read_stage_of(stage));
  for (const Json& channel : json.at("vouched"))
    header.vouched.push_back(lab::find_quantity(channel.get<std::string>()).value());
  for (const Json& note : json.at("notes"))
    header.notes.push_back({note.at(0).get<std::string>(), note.at(1).get<std::string>()});
  for (const Json& guess : json.at("guesses")) header.guesses.push_back(read_guess_of(guess));
  for (const Json& test : json.at("earlier")) first.earlier.add(read_earlier_of(test));
  return first;
}

Json ending_json(const lab::RecordEnding& ending) {
  return {{"warnings", ending.warnings},
          {"cut_short", ending.cut_short},
          {"back_volume_joined", ending.back_volume_joined},
          {"stage_lines", ending.stage_lines}};
}

lab::RecordEnding read_ending(const Json& json) {
  lab::RecordEnding ending;
  ending.warnings = json.at("warnings").get<std::int64_t>();
  ending.cut_short = json.at("cut_short").get<std::string>();
  ending.back_volume_joined = json.at("back_volume_joined").get<bool>();
  json.at("stage_lines").get_to(ending.stage_lines);
  return ending;
}

/// Texts of a header can hold any bytes: what is no UTF-8 is replaced.
std::string text_of(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

void insert_first_header(SQLite::Database& database, std::int64_t test_id,
                         const lab::RecordHeader& header, const lab::EarlierTests& earlier) {
  SQLite::Statement insert(database, "INSERT INTO first_headers (test_id, header) VALUES (?,?)");
  Binder(insert).integer(test_id).text(text_of(header_json(header, earlier))).run();
}

void set_first_ending(SQLite::Database& database, std::int64_t test_id,
                      const lab::RecordEnding& ending) {
  SQLite::Statement update(
      database, "UPDATE first_headers SET ending = ? WHERE test_id = ? AND ending IS NULL");
  Binder(update).text(text_of(ending_json(ending))).integer(test_id).run();
}

std::optional<FirstHeader> read_first_header(SQLite::Database& database, std::int64_t test_id) {
  SQLite::Statement select(database, "SELECT header, ending FROM first_headers WHERE test_id = ?");
  select.bind(1, test_id);
  if (!select.executeStep()) return std::nullopt;
  Columns columns(select);
  const std::string header = columns.text(), ending = columns.text();
  try {
    FirstHeader first = read_header(Json::parse(header));
    if (!ending.empty()) first.ending = read_ending(Json::parse(ending));
    return first;
  } catch (const std::exception& error) {
    throw lab::WorkFailed(
        fmt::format("the first header of test {} is damaged: {}", test_id, error.what()));
  }
}

}  // namespace triax::db
