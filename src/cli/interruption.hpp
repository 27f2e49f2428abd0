// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <chrono>
#include <csignal>

namespace triax::src {

/// While one is alive, the first SIGINT or SIGTERM (Ctrl-C) is a request to stop in an orderly way;
/// what comes within `orderly` of it changes nothing (`timeout` and terminals send one to the
/// process and one to its group), a later one kills as ever. A signal that was ignored before
/// (nohup) stays ignored. One at a time.
class Interruption {
 public:
  explicit Interruption(std::chrono::seconds orderly = std::chrono::seconds(5));
  ~Interruption();  ///< what the signals did before, they do again
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;

  /// Whether a signal came since. From any thread.
  bool requested() const;

 private:
  struct sigaction interrupt_before_ {};
  struct sigaction terminate_before_ {};
};

}  // namespace triax::src
