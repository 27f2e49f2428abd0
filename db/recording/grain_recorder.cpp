// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/recording/grain_recorder.hpp"

#include <SQLiteCpp/Statement.h>
#include <SQLiteCpp/Transaction.h>

#include <QDateTime>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "db/connection.hpp"
#include "db/files/open_files.hpp"
#include "db/grain_writer.hpp"
#include "db/recording/pulse.hpp"
#include "lab/base/bad_input.hpp"

namespace triax::db {

struct GrainRecorder::Impl {
  Impl(std::string file, const lab::GrainProgramme& run, Patience how_long)
      : path(std::move(file)), programme(run), patience(std::move(how_long)) {}

  std::string path;
  const lab::GrainProgramme& programme;
  const Patience patience;
  std::optional<SQLite::Database> database;
  std::optional<OpenFiles> files;
  std::string began_at;
  std::optional<lab::GrainsMade> specimen;
  std::vector<lab::GrainStageResult> ended;  ///< that are stored
  Lease lease{Leased::grain_run};
  std::optional<Pulse> pulse;
  std::int64_t id = 0;
  bool finished = false, has_moved = false;

  /// Runs `write` in a transaction of its own, again until the database takes it.
  template <class Write>
  void in_transaction(const Write& write) {
    Waiting waiting(patience);
    for (;; waiting.pause()) try {
        try_transaction(write);
        return waiting.succeeded(path);
      } catch (const MayPass& why) {
        if (waiting.failed(why)) throw;
      }
  }
  /// IMMEDIATE: a second writer waits here.
  template <class Write>
  void try_transaction(const Write& write) {
    try {
      if (!database || !files->missing().empty()) connect();
      if (has_moved) settle_in();
      SQLite::Transaction transaction(*database, SQLite::TransactionBehavior::IMMEDIATE);
      if (id != 0) lease.renew(*database);
      write(*database);
      transaction.commit();
    } catch (const SQLite::Exception& error) {
      throw_for(error, path);
    }
  }
  /// To the file at the path, a new one where the one before was renamed, removed or replaced.
  void connect() {
    if (database) {
      files->make_whole();
      path = files->path_today();
      has_moved = true;
    }
    try {
      SQLite::Database there = open_for_writing(path, patience.quiet);
      files.reset();
      database.emplace(std::move(there));
      files.emplace(*database, path);
    } catch (const lab::BadInput& error) {  // in its place now may be anything
      if (!has_moved) throw;
      throw MayPass(error.what());
    }
  }
  /// Into the file at the path goes all that was stored of the run, unless it is there.
  void settle_in() {
    SQLite::Transaction transaction(*database, SQLite::TransactionBehavior::IMMEDIATE);
    std::int64_t run = lease.row(*database);
    if (run == 0 && id != 0) run = store_again();
    transaction.commit();
    id = run;
    has_moved = false;
    if (pulse) pulse.emplace(path, lease);
    if (patience.say)
      patience.say(path + ": was renamed, removed or replaced during the run; the whole run is " +
                   "stored there again, nothing is lost");
  }
  std::int64_t store_again() {
    const std::int64_t run = insert_specimen_of_run(*database);
    for (std::size_t i = 0; i < ended.size(); ++i)
      insert_grain_stage(*database, run, static_cast<std::int64_t>(i) + 1, ended[i]);
    return run;
  }
  std::int64_t insert_specimen_of_run(SQLite::Database& d) {
    const std::int64_t run = insert_grain_run(d, programme, *specimen, began_at);
    lease.take(d, run);
    return run;
  }
  void mark(const char* status, bool complete) {
    pulse.reset();
    in_transaction([&](SQLite::Database& d) {
      SQLite::Statement mark(d, "UPDATE grain_runs SET status = ? WHERE id = ?");
      mark.bind(1, status);
      mark.bind(2, id);
      mark.exec();
      if (complete) lease.end(d);
    });
  }
};

GrainRecorder::GrainRecorder(std::string path, const lab::GrainProgramme& programme,
                             Patience patience)
    : impl_(std::make_unique<Impl>(std::move(path), programme, std::move(patience))) {
  check_place(impl_->path);
}

GrainRecorder::~GrainRecorder() {
  if (impl_->id == 0 || impl_->finished) return;
  try {
    impl_->mark("interrupted", false);
  } catch (...) {  // NOLINT(bugprone-empty-catch)
    // What was committed stands; readers see that no sign of life comes.
  }
}

lab::GrainListener GrainRecorder::listener() {
  lab::GrainListener all;
  all.made = [this](const lab::GrainsMade& told) { made(told); };
  all.stage_ended = [this](const lab::GrainStage&, const sim::GrainState&,
                           const lab::GrainStageResult& result) { ended(result); };
  return all;
}

void GrainRecorder::made(const lab::GrainsMade& made) {
  impl_->began_at = QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString();
  impl_->specimen = made;
  std::int64_t id = 0;
  impl_->in_transaction([&](SQLite::Database& d) { id = impl_->insert_specimen_of_run(d); });
  impl_->id = id;
  impl_->pulse.emplace(impl_->path, impl_->lease);
}

void GrainRecorder::ended(const lab::GrainStageResult& result) {
  if (impl_->id == 0) throw lab::WorkFailed(impl_->path + ": a stage before the specimen");
  const auto number = static_cast<std::int64_t>(impl_->ended.size()) + 1;
  impl_->in_transaction(
      [&](SQLite::Database& d) { insert_grain_stage(d, impl_->id, number, result); });
  impl_->ended.push_back(result);
}

std::int64_t GrainRecorder::finish() {
  if (impl_->id == 0) throw lab::WorkFailed(impl_->path + ": no run of grains was started");
  impl_->mark("complete", true);
  impl_->finished = true;
  return impl_->id;
}

std::int64_t GrainRecorder::id() const { return impl_->id; }

const std::string& GrainRecorder::path() const { return impl_->path; }

}  // namespace triax::db
