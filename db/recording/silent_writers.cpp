// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/recording/silent_writers.hpp"

#include <SQLiteCpp/Statement.h>
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <thread>
#include <utility>

#include "db/connection.hpp"

namespace triax::db {
namespace {

/// Of a writer, its count and its last sign: an older triax counts nothing.
using Heartbeats = std::map<std::string, std::pair<std::int64_t, std::string>>;

Heartbeats heartbeats_in(const std::vector<std::string>& databases,
                         const std::vector<std::int64_t>& tests) {
  Heartbeats found;
  for (const std::string& path : databases) try {
      SQLite::Database database = open_for_reading(path);
      SQLite::Statement all(database,
                            "SELECT writer, heartbeats, last_sign_of_life, test_id FROM leases "
                            "WHERE test_id IN (SELECT id FROM tests WHERE status = 'running') "
                            "OR run_id IN (SELECT id FROM grain_runs WHERE status = 'running')");
      while (all.executeStep())
        if (tests.empty() || std::ranges::find(tests, all.getColumn(3).getInt64()) != tests.end())
          found[all.getColumn(0).getString()] = {all.getColumn(1).getInt64(),
                                                 all.getColumn(2).getString()};
    } catch (const SQLite::Exception& error) {
      throw_for(error, path);
    }
  return found;
}

}  // namespace

std::set<std::string> silent_writers(const std::vector<std::string>& databases,
                                     const Looks& looks) {
  constexpr std::chrono::milliseconds kAgain{250};
  Heartbeats silent = heartbeats_in(databases, looks.tests);
  if (!silent.empty() && looks.say)
    looks.say(fmt::format("waiting up to {:g} s for a heartbeat of the tests marked as running",
                          std::chrono::duration<double>(looks.between).count()));
  const auto end = std::chrono::steady_clock::now() + looks.between;
  while (!silent.empty() && std::chrono::steady_clock::now() < end) {
    std::this_thread::sleep_for(kAgain);
    const Heartbeats now = heartbeats_in(databases, looks.tests);
    std::erase_if(silent, [&](const auto& one) {
      const auto found = now.find(one.first);
      return found != now.end() && found->second != one.second;
    });
  }
  std::set<std::string> writers;
  for (const auto& [writer, heartbeat] : silent) writers.insert(writer);
  return writers;
}

}  // namespace triax::db
