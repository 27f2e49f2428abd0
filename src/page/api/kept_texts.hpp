// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>
#include <map>
#include <mutex>
#include <string>
#include <utility>

namespace triax::src {

/// Texts that were made of tests, as long as these are what they were. From any thread.
class KeptTexts {
 public:
  /// The text of that version of the test, made by `make` where it is not there.
  template <class Make>
  std::string of(std::int64_t test, const std::string& version, const Make& make) {
    {
      const std::lock_guard lock(mutex_);
      const auto found = texts_.find(test);
      if (found != texts_.end() && found->second.first == version) return found->second.second;
    }
    std::string text = make();
    const std::lock_guard lock(mutex_);
    texts_[test] = {version, text};
    return text;
  }

 private:
  std::mutex mutex_;
  std::map<std::int64_t, std::pair<std::string, std::string>> texts_;  ///< version, text
};

}  // namespace triax::src
