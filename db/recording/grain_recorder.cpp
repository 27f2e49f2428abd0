// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/recording/grain_recorder.hpp"

#include <SQLiteCpp/Statement.h>
#include <SQLiteCpp/Transaction.h>

#include <QDateTime>
#include <optional>

#include "db/connection.hpp"
#include "db/grain_writer.hpp"
#include "db/recording/pulse.hpp"
#include "lab/base/bad_input.hpp"

namespace triax::db {

struct GrainRecorder::Impl {
  Impl(std::string file, const lab::GrainProgramme& run, Patience how_long)
      : path(std::move(file)), programme(run), patience(std::move(how_long)) {}

  const std::string path;
  const lab::GrainProgramme& programme;
  const Patience patience;
  std::optional<SQLite::Database> database;
  Lease lease{Leased::grain_run};
  std::optional<Pulse> pulse;
  std::int64_t id = 0, stages = 0;
  bool finished = false;

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
      if (!database) database.emplace(open_for_writing(path, patience.quiet));
      SQLite::Transaction transaction(*database, SQLite::TransactionBehavior::IMMEDIATE);
      if (id != 0) lease.renew(*database);
      write(*database);
      transaction.commit();
    } catch (const SQLite::Exception& error) {
      throw_for(error, path);
    }
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
    : impl_(std::make_unique<Impl>(std::move(path), programme, std::move(patience))) {}

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
  const std::string now = QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString();
  std::int64_t id = 0;
  impl_->in_transaction([&](SQLite::Database& d) {
    id = insert_grain_run(d, impl_->programme, made, now);
    impl_->lease.take(d, id);
  });
  impl_->id = id;
  impl_->pulse.emplace(impl_->path, impl_->lease);
}

void GrainRecorder::ended(const lab::GrainStageResult& result) {
  if (impl_->id == 0) throw lab::WorkFailed(impl_->path + ": a stage before the specimen");
  impl_->in_transaction(
      [&](SQLite::Database& d) { insert_grain_stage(d, impl_->id, impl_->stages + 1, result); });
  ++impl_->stages;
}

std::int64_t GrainRecorder::finish() {
  if (impl_->id == 0) throw lab::WorkFailed(impl_->path + ": no run of grains was started");
  impl_->mark("complete", true);
  impl_->finished = true;
  return impl_->id;
}

std::int64_t GrainRecorder::id() const { return impl_->id; }

}  // namespace triax::db
