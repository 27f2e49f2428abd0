// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <set>

namespace triax::db {

/// Lets threads take numbered turns in the order 1, 2, 3..., whichever comes first. A turn may be
/// given back before it is taken, or twice.
class Turns {
 public:
  /// Waits until all turns before `number` are over.
  void wait_for(std::int64_t number);
  /// Turn `number` is over, taken or not.
  void over(std::int64_t number);

 private:
  std::mutex mutex_;
  std::condition_variable moved_;
  std::int64_t next_ = 1;
  std::set<std::int64_t> early_;  ///< over before all those in front of them
};

}  // namespace triax::db
