// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/page/record/record_reading.hpp"

#include <memory>

#include "db/store.hpp"
#include "lab/base/bad_input.hpp"
#include "lab/records/metadata.hpp"
#include "lab/reduction/reduction.hpp"
#include "lab/rig/otherwise.hpp"
#include "lab/rig/recorded.hpp"
#include "src/study/json_parts.hpp"
#include "src/study/triaxial/test_run.hpp"

namespace triax::src {
namespace {

using study::Json;

/// One record, as often as it is opened.
class UploadedRecord {
 public:
  UploadedRecord(const RecordToRead& record, const Upload& upload)
      : record_(record), upload_(upload) {}

  std::unique_ptr<lab::RecordedRig> open(const lab::RecordOptions& options) const {
    return lab::open_record(upload_.source(record_.name), options);
  }
  std::unique_ptr<lab::RecordedRig> open() const { return open(options()); }
  lab::RecordOptions options() const {
    lab::RecordOptions options;
    options.sets = record_.sets;
    return options;
  }

 private:
  const RecordToRead& record_;
  const Upload& upload_;
};

/// Keys that have to be answered before the record can be reduced: each is asked for with the
/// others taken as said.
Json missing_keys(const lab::RecordHeader& head) {
  Json missing = Json::array();
  lab::RecordHeader header = head;
  for (int tries = 0; tries < 8; ++tries) try {
      const lab::Reduction reduced(header, {});
      break;
    } catch (const lab::MissingKey& error) {
      missing.push_back({{"key", error.key()},
                         {"label", error.label()},
                         {"unit", study::json_text(error.unit())},
                         {"why", error.what()}});
      lab::set_metadata(header, "asked for", error.key(), "100");
    }
  return missing;
}

Json guesses_of(const std::vector<lab::Guess>& guesses) {
  Json list = Json::array();
  for (const lab::Guess& guess : guesses) {
    Json otherwise = Json::array();
    for (const auto& said : guess.otherwise) otherwise.push_back(said.key + '=' + said.value);
    list.push_back({{"what", guess.what},
                    {"taken", guess.taken},
                    {"evidence", guess.evidence},
                    {"remedy", guess.remedy},
                    {"otherwise", std::move(otherwise)}});
  }
  return list;
}

Json recognised(const lab::RecordHeader& header) {
  Json columns = Json::array();
  for (const lab::Quantity quantity : header.columns) columns.push_back(lab::heading(quantity));
  return {{"name", header.name},
          {"dialect", study::json_text(header.dialect)},
          {"programme", study::json_text(header.programme)},
          {"columns", std::move(columns)},
          {"stages", header.stages.size()},
          {"raw", header.is_raw()}};
}

std::int64_t replay(const RecordToRead& asked, const UploadedRecord& record) {
  const auto rig = record.open();
  const auto otherwise = [&] {
    return lab::judge_otherwise(rig->header(), {}, [&](const lab::Guess::Said& said) {
      lab::RecordOptions other = record.options();
      other.sets.emplace_back(said.key, said.value);
      return record.open(other);
    });
  };
  std::string db = asked.db;
  return study::run_test(*rig, {.reduction = {}, .otherwise = otherwise}, db, {}, {}, {},
                         asked.writer);
}

}  // namespace

std::string read_record(const RecordToRead& record, const Upload& upload) {
  const UploadedRecord opened(record, upload);
  Json answer = {{"recognised", nullptr},
                 {"guessed", Json::array()},
                 {"missing", Json::array()},
                 {"test", nullptr},
                 {"error", nullptr}};
  try {
    {
      const auto rig = opened.open();
      answer["recognised"] = recognised(rig->header());
      answer["guessed"] = guesses_of(rig->header().guesses);
      answer["missing"] = missing_keys(rig->header());
    }
    if (answer["missing"].empty()) {
      const std::int64_t id = replay(record, opened);
      answer["test"] = id;
      answer["guessed"] = guesses_of(db::Store(record.db).load(id).header.guesses);
    }
  } catch (const lab::BadInput& error) {
    answer["error"] = error.what();
  }
  return study::json_line(answer);
}

}  // namespace triax::src
