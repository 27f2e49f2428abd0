// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/recording/pulse.hpp"

#include <SQLiteCpp/Transaction.h>

#include <filesystem>
#include <utility>

#include "db/connection.hpp"

namespace triax::db {

Pulse::Pulse(std::string path, Lease lease)
    : path_(std::move(path)), lease_(std::move(lease)), thread_([this] { beat(); }) {}

Pulse::~Pulse() {
  {
    const std::lock_guard lock(mutex_);
    ended_ = true;
    end_.notify_one();
  }
  thread_.join();
}

void Pulse::beat() {
  std::unique_lock lock(mutex_);
  while (!end_.wait_for(lock, Lease::kBeat, [this] { return ended_; })) try {
      if (!std::filesystem::exists(path_)) continue;  // the writer re-creates it, with its run
      SQLite::Database database = open_for_writing(path_, Lease::kBeat);
      SQLite::Transaction transaction(database, SQLite::TransactionBehavior::IMMEDIATE);
      lease_.renew(database);
      transaction.commit();
    } catch (const std::exception&) {  // NOLINT(bugprone-empty-catch)
      // The writer itself tells what is wrong when it next has something to store.
    }
}

}  // namespace triax::db
