// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/page/record/record_reading.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "db/store.hpp"
#include "lab/base/bad_input.hpp"
#include "lab/records/dialect_memory.hpp"
#include "lab/records/tables/table_recognition.hpp"
#include "lab/rig/otherwise.hpp"
#include "lab/rig/recorded.hpp"
#include "lab/rig/sheet_record.hpp"
#include "lab/workbook/sheet_source.hpp"
#include "src/study/intake/proposal_json.hpp"
#include "src/study/intake/record_preview.hpp"
#include "src/study/json_parts.hpp"
#include "src/study/triaxial/test_run.hpp"
#include "src/study/triaxial/tests_of_file.hpp"

namespace triax::src {
namespace {

using study::Json;

/// In the order of RecordTask.
constexpr std::array<std::string_view, 3> kTaskNames{"replay", "propose", "preview"};

/// One record, as often as it is opened.
class UploadedRecord {
 public:
  UploadedRecord(const RecordToRead& record, const Upload& upload)
      : record_(record), upload_(upload) {}

  std::unique_ptr<lab::RecordedRig> open(const lab::RecordOptions& options) const {
    return lab::open_record(upload_.source(record_.name), options);
  }
  std::unique_ptr<lab::RecordedRig> open(const study::TestOfFile& test) const {
    return open(test.options(options()));
  }
  lab::RecordOptions options() const {
    return {.dialect_text = record_.dialect,
            .dialect_folder = lab::DialectMemory::folder_of(record_.db),
            .sheet = record_.sheet,
            .sets = record_.sets};
  }
  study::FindTests tests() const {
    return [this](lab::Extent extent) {
      return lab::tests_in([this] { return upload_.source(record_.name); }, options(), extent);
    };
  }
  /// The one of tables side by side that the dialect describes; 0: none.
  std::size_t block() const {
    return record_.dialect.empty() ? 0 : lab::parse_dialect(record_.dialect, "dialect").block;
  }

 private:
  const RecordToRead& record_;
  const Upload& upload_;
};

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

std::int64_t replay(const RecordToRead& asked, const UploadedRecord& record,
                    const study::TestOfFile& test) {
  const auto rig = record.open(test);
  const auto otherwise = [&] {
    return lab::judge_otherwise(rig->header(), {}, [&](const lab::Guess::Said& said) {
      lab::RecordOptions other = test.options(record.options());
      other.sets.emplace_back(said.key, said.value);
      return record.open(other);
    });
  };
  std::string db = asked.db;
  return study::run_test(*rig, {.reduction = {}, .otherwise = otherwise}, db, {}, {}, {},
                         asked.writer);
}

/// Facts that are known before the first test is stored.
void look_at_heads(const UploadedRecord& record, Json& answer) {
  for (const study::TestOfFile& test : study::tests_of(record.tests()(lab::Extent::sample))) {
    const auto rig = record.open(test);
    if (answer["recognised"].is_null()) {
      answer["recognised"] = recognised(rig->header());
      answer["guessed"] = study::guesses_json(rig->header().guesses);
      answer["warnings"] = study::warnings_json(rig->header().warnings);
    }
    if (answer["missing"].empty()) answer["missing"] = study::missing_keys(rig->header());
  }
}

void replay_tests(const RecordToRead& record, const UploadedRecord& opened, Json& answer) {
  std::vector<std::string> faults;
  const auto read = [&](const study::TestOfFile& test) {
    const std::int64_t id = replay(record, opened, test);
    answer["tests"].push_back(id);
    if (answer["tests"].size() > 1) return;
    answer["test"] = id;
    answer["guessed"] = study::guesses_json(db::Store(record.db).load(id).header.guesses);
  };
  study::read_tests(opened.tests(), read,
                    [&](const lab::BadInput& error) { faults.emplace_back(error.what()); });
  if (!faults.empty())
    answer["error"] = fmt::format("{} of {} tests could not be read: {}", faults.size(),
                                  faults.size() + answer["tests"].size(), faults.front());
}

Json replayed(const RecordToRead& record, const UploadedRecord& opened) {
  Json answer = {{"recognised", nullptr},    {"guessed", Json::array()},
                 {"missing", Json::array()}, {"warnings", Json::array()},
                 {"test", nullptr},          {"tests", Json::array()},
                 {"error", nullptr}};
  try {
    look_at_heads(opened, answer);
    if (answer["missing"].empty()) replay_tests(record, opened, answer);
  } catch (const lab::BadInput& error) {
    answer["error"] = error.what();
  }
  return answer;
}

/// True if it is in the format of triax, whose headings and metadata leave nothing open.
bool is_own_format(lab::ByteSource& table) {
  std::vector<lab::Warning> warnings;
  lab::Findings findings(warnings);
  try {
    const lab::Dialect& own = lab::shipped_dialects().front();
    return lab::recognise_table(table, own, findings).dialect.own_headings;
  } catch (const lab::BadInput&) {
    return false;
  }
}

Json proposed(const RecordToRead& record, const Upload& upload) {
  try {
    const auto table = lab::sheet_or_text(upload.source(record.name), {.sheet = record.sheet});
    Json answer =
        study::proposal_json(*table, lab::DialectMemory(lab::DialectMemory::folder_of(record.db)));
    answer["worksheets"] = Json::array();
    answer["worksheet"] = nullptr;
    if (const auto* const sheet = dynamic_cast<const lab::SheetSource*>(table.get())) {
      for (const auto& entry : sheet->book().sheets()) answer["worksheets"].push_back(entry.name);
      answer["worksheet"] = sheet->sheet().name;
    }
    answer["own"] = is_own_format(*table);
    answer["error"] = nullptr;
    return answer;
  } catch (const lab::BadInput& error) {
    return {{"error", error.what()}};
  }
}

Json preview_of(const UploadedRecord& opened, const std::vector<study::TestOfFile>& tests) {
  const study::TestOfFile test = study::test_of_block(tests, opened.block());
  Json answer = study::preview_json(*opened.open(test));
  answer["tests"] = tests.size();
  answer["shown"] = std::max<std::size_t>(test.number, 1);
  return answer;
}

Json previewed(const UploadedRecord& opened) {
  try {
    Json answer;
    try {
      answer = preview_of(opened, study::tests_of(opened.tests()(lab::Extent::sample)));
    } catch (const lab::SeveralTests& error) {
      answer = preview_of(opened, study::tests_in_all_rows(opened.tests(), error));
    }
    answer["error"] = nullptr;
    return answer;
  } catch (const lab::BadInput& error) {
    return {{"error", error.what()}};
  }
}

}  // namespace

std::string_view name_of(RecordTask task) { return kTaskNames[static_cast<std::size_t>(task)]; }

std::optional<RecordTask> find_record_task(std::string_view name) {
  const auto* const found = std::ranges::find(kTaskNames, name);
  if (found == kTaskNames.end()) return std::nullopt;
  return static_cast<RecordTask>(found - kTaskNames.begin());
}

std::string read_record(const RecordToRead& record, const Upload& upload) {
  const UploadedRecord opened(record, upload);
  switch (record.task) {
    case RecordTask::replay:
      return study::json_line(replayed(record, opened));
    case RecordTask::propose:
      return study::json_line(proposed(record, upload));
    case RecordTask::preview:
      return study::json_line(previewed(opened));
  }
  return {};
}

}  // namespace triax::src
