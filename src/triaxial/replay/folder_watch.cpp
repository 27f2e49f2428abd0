// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/replay/folder_watch.hpp"

#include <sys/stat.h>

#include <utility>

namespace triax::src {

FolderWatch::FolderWatch(std::function<std::vector<std::string>()> files,
                         std::chrono::milliseconds quiet)
    : files_(std::move(files)), quiet_(quiet) {}

bool FolderWatch::read_state(const std::string& path, State& state) {
  struct stat found {};
  if (stat(path.c_str(), &found) != 0) return false;
  constexpr std::int64_t kNanoseconds = 1'000'000'000;
  state = {found.st_size, found.st_mtim.tv_sec * kNanoseconds + found.st_mtim.tv_nsec,
           found.st_ino};
  return true;
}

std::vector<std::string> FolderWatch::settled(Clock::time_point now) {
  std::vector<std::string> quiet;
  std::map<std::string, Watched> seen;
  for (const std::string& path : files_()) {
    State state;
    if (!read_state(path, state)) continue;  // it vanished meanwhile
    const auto known = watched_.find(path);
    Watched watched{state, now + quiet_};
    if (known != watched_.end() && known->second.state == state) watched = known->second;
    if (!watched.is_given && watched.due <= now) {
      watched.is_given = true;
      quiet.push_back(path);
    }
    seen.emplace(path, watched);
  }
  watched_ = std::move(seen);
  return quiet;
}

void FolderWatch::repeat(const std::string& path, Clock::time_point now,
                         std::chrono::milliseconds delay) {
  const auto known = watched_.find(path);
  if (known == watched_.end()) return;
  known->second.is_given = false;
  known->second.due = now + delay;
}

}  // namespace triax::src
