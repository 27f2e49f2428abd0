// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <tuple>
#include <vector>

namespace triax::src {

/// Finds files that are new or changed and that are no longer being written: size, time and inode
/// have been the same for `quiet`. Looks when it is asked, so that it works on any file system.
class FolderWatch {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::milliseconds kQuiet{2000};

  /// `files` gives the paths to watch; a path that is missing in its answer is forgotten.
  explicit FolderWatch(std::function<std::vector<std::string>()> files,
                       std::chrono::milliseconds quiet = kQuiet);

  /// The files that have become quiet since the last call, in the order of `files`. Each state of a
  /// file is given once. Throws what `files` throws.
  std::vector<std::string> settled(Clock::time_point now);
  /// The present state of this file is given once more, after `delay`.
  void repeat(const std::string& path, Clock::time_point now, std::chrono::milliseconds delay);

 private:
  /// Size, time of the last change in nanoseconds, inode.
  using State = std::tuple<std::int64_t, std::int64_t, std::uint64_t>;
  struct Watched {
    State state;
    Clock::time_point due;
    bool is_given = false;
  };
  static bool read_state(const std::string& path, State& state);

  std::function<std::vector<std::string>()> files_;
  std::chrono::milliseconds quiet_;
  std::map<std::string, Watched> watched_;
};

}  // namespace triax::src
