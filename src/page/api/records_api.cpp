// SPDX-License-Identifier: GPL-3.0-or-later
// A record that a browser sends is replayed as `triax replay` does it.
#include <algorithm>

#include "lab/base/bad_input.hpp"
#include "lab/base/text.hpp"
#include "lab/records/metadata.hpp"
#include "lab/reduction/reduction.hpp"
#include "lab/rig/otherwise.hpp"
#include "lab/rig/recorded.hpp"
#include "src/page/api/changes_api.hpp"
#include "src/study/json_parts.hpp"
#include "src/study/triaxial/test_run.hpp"

namespace triax::src {
namespace {

using study::Json;

/// What reading a record may need: a line of the longest, the head, a batch for the database.
constexpr std::size_t kMemoryOfReader = std::size_t{64} << 20;

std::string name_of(const Target& target) {
  std::string name = target.value("name").value_or("record");
  if (const auto slash = name.find_last_of("/\\"); slash != std::string::npos)
    name = name.substr(slash + 1);
  constexpr std::size_t kMost = 200;
  if (name.empty() || name.size() > kMost)
    throw Refused(400, "name: expected the name of the file, at most 200 bytes");
  return name;
}

lab::RecordOptions options_of(const Target& target) {
  lab::RecordOptions options;
  for (const auto& [name, value] : target.query) {
    if (name != "set") continue;
    const auto equals = value.find('=');
    if (equals == std::string::npos || equals == 0)
      throw Refused(400, "set=" + lab::excerpt(value) + ": expected KEY=VALUE");
    options.sets.emplace_back(value.substr(0, equals), value.substr(equals + 1));
  }
  return options;
}

/// One record, as often as it is opened.
class Dropped {
 public:
  Dropped(const Upload& upload, std::string name, lab::RecordOptions options)
      : upload_(upload), name_(std::move(name)), options_(std::move(options)) {}

  std::unique_ptr<lab::RecordedRig> open(const lab::RecordOptions& options) const {
    return lab::open_record(upload_.source(name_), options);
  }
  std::unique_ptr<lab::RecordedRig> open() const { return open(options_); }
  const lab::RecordOptions& options() const { return options_; }

 private:
  const Upload& upload_;
  std::string name_;
  lab::RecordOptions options_;
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

std::int64_t replay(PageLaboratory& laboratory, const Dropped& record) {
  const auto rig = record.open();
  // Thrown through the session: what was read stays, marked as interrupted.
  const auto stop = [&laboratory]() -> bool {
    if (laboratory.ending) throw lab::WorkFailed("triax open was ended while the record was read");
    return false;
  };
  const auto otherwise = [&] {
    return lab::judge_otherwise(rig->header(), {}, [&](const lab::Guess::Said& said) {
      lab::RecordOptions other = record.options();
      other.sets.emplace_back(said.key, said.value);
      return record.open(other);
    });
  };
  return study::run_test(*rig, {.reduction = {}, .stop = stop, .otherwise = otherwise},
                         laboratory.db, {},
                         {.say = {}, .stop = [&laboratory] { return laboratory.ending.load(); }});
}

}  // namespace

PageAnswer take_record(PageLaboratory& laboratory, const PageRequest& request) {
  const auto share = laboratory.budget.take(kMemoryOfReader);
  if (!share) throw Refused(503, "too many records are read at once; send it again in a while");
  const Dropped record(*request.upload, name_of(request.target), options_of(request.target));
  Json answer = {{"recognised", nullptr},
                 {"guessed", Json::array()},
                 {"missing", Json::array()},
                 {"test", nullptr},
                 {"error", nullptr}};
  try {
    {
      const auto rig = record.open();
      answer["recognised"] = recognised(rig->header());
      answer["guessed"] = guesses_of(rig->header().guesses);
      answer["missing"] = missing_keys(rig->header());
    }
    if (answer["missing"].empty()) {
      const std::int64_t id = replay(laboratory, record);
      answer["test"] = id;
      answer["guessed"] = guesses_of(db::Store(laboratory.db).load(id).header.guesses);
    }
  } catch (const lab::BadInput& error) {
    answer["error"] = error.what();
  }
  return json_answer(study::json_line(answer));
}

}  // namespace triax::src
