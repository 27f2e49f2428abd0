// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How recorders wait for a database that takes nothing: another program holds its lock, or the disk
// is full.
#include <chrono>
#include <cstdint>
#include <functional>
#include <string>

#include "db/connection.hpp"

namespace triax::db {

struct Patience {
  std::chrono::milliseconds quiet{2000};            ///< before anything is said or kept elsewhere
  std::chrono::milliseconds again{250};             ///< between two tries
  std::chrono::seconds most{7200};                  ///< at the end of the work, which then fails
  std::int64_t most_bytes = std::int64_t{2} << 30;  ///< of a file that readings wait in
  std::function<void(const std::string&)> say;      ///< a sentence for the user; from any thread
  std::function<bool()> stop{};  ///< whether the user wants no more of it; from any thread
};

/// One time of waiting after the other. Does not outlive its Patience.
class Waiting {
 public:
  explicit Waiting(const Patience& patience) : patience_(patience) {}

  /// Patience::most counts from here, or from the beginning.
  void count_from_now() { from_ = Clock::now(); }

  /// Whether the last try failed.
  bool under_way() const { return since_ != Clock::time_point{}; }
  /// A try failed; says so, once a time. True once Patience::most is over, or where the user wants
  /// to wait no longer.
  bool failed(const MayPass& why);
  /// Until the next try.
  void pause() const;
  /// A try succeeded.
  void succeeded(const std::string& path);

 private:
  using Clock = std::chrono::steady_clock;
  void say(const std::string& sentence) const;
  const Patience& patience_;
  Clock::time_point from_ = Clock::now();
  Clock::time_point since_{};
};

}  // namespace triax::db
