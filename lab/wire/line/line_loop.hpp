// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Everything that waits on the wire waits here: one loop, one thread. Handlers are called from
// poll(), run_for() and run_until() only, never from within the call that asked for them.
#include <functional>
#include <memory>

namespace boost::asio {
class io_context;
}

namespace triax::lab {

/// Something to be done at an instant; cancelled by its end of life.
class LineTimer {
 public:
  LineTimer() = default;
  LineTimer(LineTimer&&) = default;
  LineTimer& operator=(LineTimer&& other) noexcept;
  ~LineTimer();
  void cancel();
  /// Whether it is still to come.
  bool waits() const;

 private:
  friend class LineLoop;
  struct State;
  std::shared_ptr<State> state_;
};

class LineLoop {
 public:
  LineLoop();
  ~LineLoop();
  LineLoop(const LineLoop&) = delete;
  LineLoop& operator=(const LineLoop&) = delete;

  /// Monotonic, s since the loop was made. All deadlines are on this clock.
  double now_s() const;
  /// Calls `what` once at `when_s` or as soon after as the loop runs. What it throws goes through
  /// to who runs the loop.
  [[nodiscard]] LineTimer at(double when_s, std::function<void()> what);
  /// Calls `what` from the loop, as soon as it runs.
  void soon(std::function<void()> what);

  /// Does what is ready without waiting, 1,000 handlers at most.
  void poll();
  void run_for(double seconds);
  /// Until `reached` says so or the deadline is over; gives what it said last. It is asked after
  /// every handler and at least 20 times a second, so that it may look at a signal's flag.
  bool run_until(const std::function<bool()>& reached, double deadline_s);
  /// Longest time since the last call for which no handler could run, s: the process stood still or
  /// was busy elsewhere. Up to 0.05 s is waiting.
  double take_longest_stall_s();

  /// For lines of this folder.
  boost::asio::io_context& context();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace triax::lab
