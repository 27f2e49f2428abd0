// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// triax left running in a folder, until it is told to end in the midst of its work.
#include <SQLiteCpp/Database.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <nlohmann/json.hpp>
#include <thread>

#include "tests/cli/program.hpp"

namespace triax::cli_tests {

class Running {
 public:
  Running(const Workplace& here, const std::string& arguments) : here_(here), child_(fork()) {
    const std::string command = "cd '" + (here / "").string() + "' && exec " TRIAX_PROGRAM " " +
                                arguments + " >.child_out 2>.child_err </dev/null";
    if (child_ > 0) return;
    execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
    _exit(127);
  }

  /// Waits until a count in the database exceeds `least`: at work, on any machine. False after two
  /// minutes.
  bool reaches(const std::string& database, const std::string& counted, int least) const {
    for (int i = 0; i < 600; ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(200));
      if (!here_.has(database)) continue;
      const Outcome found = here_.triax("query \"SELECT count(*) AS n FROM " + counted +
                                        "\" --db " + database + " --format json");
      if (found.status == 0 && nlohmann::json::parse(found.out)[0]["n"].get<int>() > least)
        return true;
    }
    return false;
  }

  /// Waits until standard error has this text. False after two minutes.
  bool says(const std::string& text) const {
    for (int i = 0; i < 2400; ++i) {
      if (here_.has(".child_err") && err().find(text) != std::string::npos) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    return false;
  }

  /// Sends the signal, so many times at once, and gives the exit status; -1 where the signal itself
  /// ended the program.
  int end_by(int signal, int times = 1) const {
    for (int i = 0; i < times; ++i) {
      if (i > 0) std::this_thread::sleep_for(std::chrono::milliseconds(2));
      kill(child_, signal);
    }
    int status = -1;
    waitpid(child_, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

  std::string out() const { return content(here_ / ".child_out"); }
  std::string err() const { return content(here_ / ".child_err"); }

 private:
  const Workplace& here_;
  pid_t child_;
};

/// As if the writers of what runs in the database had been silent for an hour.
inline void silence(const std::filesystem::path& database) {
  SQLite::Database(database.string(), SQLite::OPEN_READWRITE)
      .exec("UPDATE leases SET last_sign_of_life = datetime('now', '-1 hour')");
}

}  // namespace triax::cli_tests
