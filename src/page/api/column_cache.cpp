// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/page/api/column_cache.hpp"

#include <algorithm>

#include "src/page/request/request.hpp"

namespace triax::src {

std::shared_ptr<ColumnCache::Kept> ColumnCache::kept_of(std::int64_t test,
                                                        const std::string& version) {
  const std::lock_guard lock(mutex_);
  const auto found =
      std::ranges::find_if(all_, [test](const auto& kept) { return kept->columns.test() == test; });
  if (found != all_.end() && (*found)->version != version) {
    all_.erase(found);
  } else if (found != all_.end()) {
    all_.splice(all_.begin(), all_, found);
    return all_.front();
  }
  return all_.emplace_front(std::make_shared<Kept>(test, version));
}

/// Drops what was asked for longest ago until it fits.
MemoryBudget::Share ColumnCache::room_for(std::size_t bytes, const Kept* but) {
  for (;;) {
    if (auto share = budget_.take(bytes)) return share;
    const std::lock_guard lock(mutex_);
    const auto last = std::find_if(all_.rbegin(), all_.rend(), [but](const auto& kept) {
      return kept.get() != but && kept.use_count() == 1;
    });
    if (last == all_.rend())
      throw Refused(503, "not enough memory to draw this test now; try again");
    all_.erase(std::next(last).base());
  }
}

void ColumnCache::with(std::int64_t test, const std::string& version,
                       const std::function<std::size_t(const study::TestColumns&)>& bytes,
                       const std::function<void(study::TestColumns&)>& use) {
  const auto kept = kept_of(test, version);
  const std::lock_guard lock(kept->mutex);
  const std::size_t needed = bytes(kept->columns);
  if (needed > budget_.most())
    throw Refused(
        413,
        "this test has too many readings to be drawn here; use `triax report`, which has no limit");
  if (needed > kept->bytes) {
    // What is held already stays paid for where there is no room for more.
    kept->share.add(room_for(needed - kept->bytes, kept.get()));
    kept->bytes = needed;
  }
  use(kept->columns);
}

}  // namespace triax::src
