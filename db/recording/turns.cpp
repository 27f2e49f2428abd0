// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/recording/turns.hpp"

namespace triax::db {

void Turns::wait_for(std::int64_t number) {
  std::unique_lock lock(mutex_);
  moved_.wait(lock, [&] { return next_ >= number; });
}

void Turns::over(std::int64_t number) {
  const std::lock_guard lock(mutex_);
  if (number < next_) return;
  early_.insert(number);
  while (early_.erase(next_) > 0) ++next_;
  moved_.notify_all();
}

}  // namespace triax::db
