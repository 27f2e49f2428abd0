// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <csignal>

namespace triax::src {

/// While one is alive, the first SIGINT or SIGTERM (Ctrl-C) is a request to stop in an orderly way;
/// the second kills as ever. A signal that was ignored before (nohup) stays ignored. One at a time.
class Interruption {
 public:
  Interruption();
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
