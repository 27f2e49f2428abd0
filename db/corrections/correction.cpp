// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/corrections/correction.hpp"

#include <SQLiteCpp/Statement.h>
#include <fmt/format.h>

#include <QDateTime>
#include <algorithm>
#include <set>
#include <utility>

#include "db/columns.hpp"
#include "db/connection.hpp"
#include "db/missing_readings.hpp"
#include "db/summary_writer.hpp"
#include "db/test_reader.hpp"
#include "db/test_writer.hpp"
#include "lab/base/bad_input.hpp"
#include "lab/base/text.hpp"

namespace triax::db {
namespace {

using SQLite::Statement;

constexpr std::size_t kScansAtATime = 10000;

SQLite::Database opened_if_there(const std::string& path) {
  check_there(path);
  return open_for_writing(path);
}

bool has_lease(SQLite::Database& database, std::int64_t id) {
  Statement select(database, "SELECT 1 FROM leases WHERE test_id = ?");
  select.bind(1, id);
  return select.executeStep();
}

/// The start of a replay, from a test that an older triax stored.
FirstHeader first_of_stored(const StoredTest& test) {
  FirstHeader first;
  first.header.programme = test.header.programme;
  first.header.specimen = test.header.specimen;
  first.header.stages = test.header.stages;
  first.header.notes = test.header.notes;
  first.header.guesses = test.header.guesses;
  auto& ending = first.ending.emplace();
  // The record's own come first, those known at its start before those of its rows.
  const auto [stop, none] = std::ranges::mismatch(test.summary.warnings, test.header.warnings, {},
                                                  &lab::Warning::text, &lab::Warning::text);
  ending.warnings = stop - test.summary.warnings.begin();
  return first;
}

void delete_rows(SQLite::Database& database, std::int64_t id,
                 std::initializer_list<const char*> tables) {
  for (const char* table : tables) {
    Statement rows(database, std::string("DELETE FROM ") + table + " WHERE test_id = ?");
    Binder(rows).integer(id).run();
  }
}

}  // namespace

Correction::Correction(const std::string& path, std::int64_t id) try
    : path_(path),
      id_(id),
      database_(opened_if_there(path)),
      transaction_(database_, SQLite::TransactionBehavior::IMMEDIATE),
      test_(read_test(database_, id)) {
  check_can_be_corrected();
  // Another connection goes on reading what was committed before.
  reader_.emplace(path);
  if (auto first = read_first_header(database_, id); first && first->ending) {
    first_ = std::move(*first);
  } else {
    is_exact_ = false;
    first_ = first_of_stored(test_);
  }
  std::set<int> stages;
  for (const auto& [stage, reference] : stage_references(database_, id)) stages.insert(stage);
  for (const lab::StageInfo& stage : test_.header.stages) stages.insert(stage.number);
  stages_.assign(stages.begin(), stages.end());
} catch (const SQLite::Exception& error) {
  throw_for(error, path);
}

void Correction::check_can_be_corrected() {
  if (test_.id == 0) throw lab::BadInput(path_, 0, describe_missing_tests({id_}));
  const auto refuse = [&](const std::string& why) {
    throw lab::BadInput(path_, 0,
                        fmt::format("test {} {} {}; nothing was changed", id_,
                                    lab::excerpt(test_.header.name), why));
  };
  if (test_.status == TestStatus::running)
    refuse("is still being recorded: correct it when it has ended");
  if (test_.status != TestStatus::complete || has_lease(database_, id_))
    refuse("was interrupted and has no result: replay its file with --set");
  if (const auto missing = missing_readings(database_, id_))
    refuse("cannot be reduced again: " + in_words(*missing));
}

template <class Work>
auto Correction::guarded(const Work& work) const {
  try {
    return work();
  } catch (const SQLite::Exception& error) {
    throw_for(error, path_);
  }
}

lab::SessionListener Correction::listener() {
  lab::SessionListener listener;
  listener.started = [this](const auto& header) { guarded([&] { begin(header); }); };
  listener.scanned = [this](const auto& reading, const auto& state) {
    guarded([&] { write({reading, state}); });
  };
  listener.second_order_work = [this](const auto& p) { guarded([&] { scans_->write(p); }); };
  listener.happened = [this](const auto& e) { guarded([&] { insert_event(database_, id_, e); }); };
  listener.foreseen = [this](const auto& forecast) {
    guarded([&] { insert_forecasts(database_, id_, {forecast}); });
  };
  return listener;
}

void Correction::begin(const lab::RecordHeader& header) {
  remove_scans(database_, id_);
  delete_rows(database_, id_,
              {"stage_references", "events", "consolidations", "instants", "losses_of_control",
               "verdicts", "criteria", "checks", "outlooks", "cyclic_loadings"});
  Statement warnings(database_, "DELETE FROM warnings WHERE test_id = ? AND found = 'at_end'");
  Binder(warnings).integer(id_).run();
  replace_header(database_, id_, header);
  scans_.emplace(database_, id_);
}

void Correction::write(const Scan& scan) {
  waiting_.push_back(scan);
  if (waiting_.size() >= kScansAtATime) write_scans();
}

void Correction::write_scans() {
  scans_->write(waiting_);
  waiting_.clear();
}

std::int64_t Correction::commit(lab::TestSummary summary, const std::vector<RevisedValue>& values) {
  summary.guard.reset();
  summary.truth.reset();
  Revision revision;
  revision.number = test_.revisions.empty() ? 2 : test_.revisions.back().number + 1;
  revision.revised_at = QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString();
  revision.values = values;
  const lab::Collapse& former = test_.summary.collapse;
  if (former.judged) revision.former_kind = former.kind;
  if (former.onset) revision.former_eta = former.onset->eta();
  return guarded([&] {
    write_scans();
    insert_summary(database_, id_, summary);
    insert_revision(database_, id_, revision);
    transaction_.commit();
    return revision.number;
  });
}

}  // namespace triax::db
