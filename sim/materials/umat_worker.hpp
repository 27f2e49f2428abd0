// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A foreign library is never run inside triax: a process of its own (fork) loads it and answers
// calls through shared memory, so that whatever it does (a segmentation fault, STOP, XIT, an
// endless loop) ends that process only and comes back as words. The process cannot outlive triax,
// and it has no others (process_confinement.hpp).
#include <memory>
#include <mutex>
#include <string>

#include "sim/materials/umat_plugin.hpp"

namespace triax::sim {

struct UmatExchange;

class UmatWorker {
 public:
  /// Loads the library. Throws std::invalid_argument that says why it cannot be used.
  explicit UmatWorker(UmatPlugin plugin);
  ~UmatWorker();
  UmatWorker(const UmatWorker&) = delete;
  UmatWorker& operator=(const UmatWorker&) = delete;

  const UmatPlugin& plugin() const { return plugin_; }

  /// Calls the UMAT; empty where it came back in order, otherwise what happened, and `call` is
  /// untouched. After a crash the next call starts the process anew; after three calls that
  /// did not end in time there is none (a probe asks in hundreds of directions). May be called from
  /// several threads; they wait for each other.
  std::string call(UmatCall& call);

 private:
  enum class Answer { came, ended, late };

  std::string start();
  Answer wait();
  std::string ended(Answer answer);
  std::string how_late(const char* what) const;
  std::string why_it_ended() const;
  std::string last_words() const;
  void shorten_output() const;
  std::string how_it_trespassed() const;
  void close_files();
  void kill_group();
  void stop();

  UmatPlugin plugin_;
  std::mutex mutex_;
  UmatExchange* exchange_ = nullptr;
  int process_ = 0;    ///< 0: none
  int status_ = 0;     ///< of the process that ended, as waitpid gives it; −1: unknown
  int output_ = -1;    ///< what the plug-in prints
  int lifeline_ = -1;  ///< closed at the end of triax, which ends the process
  unsigned calls_ = 0;
  int late_ = 0;  ///< calls that did not end in time
};

/// Calls of plug-ins that did not come back in order since the program began, of all workers: a
/// crash, STOP, XIT, an index out of range, no end in time. Who asks a law in many directions or
/// runs a test goes on without their answers, so that somebody has to tell of them in the end.
struct UmatEnds {
  long calls = 0;
  std::string first;  ///< what happened to the first of them
};
/// From any thread.
UmatEnds umat_ends();

}  // namespace triax::sim
