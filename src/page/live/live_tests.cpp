// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/page/live/live_tests.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "db/store.hpp"
#include "lab/base/bad_input.hpp"
#include "src/page/request/request.hpp"

namespace triax::src {
namespace {

constexpr std::ptrdiff_t kMostAtWork = 8;
/// Of tests that are over: a browser that comes back still hears how they ended.
constexpr std::size_t kMostKept = 8;

bool at_work(const auto& entry) { return !entry.second->is_over(); }

/// Takes out those that are over, oldest first, until few are left.
template <class Tests>
void forget_those_over(Tests& tests, std::vector<typename Tests::mapped_type>& forgotten) {
  for (auto i = tests.begin(); i != tests.end() && tests.size() > kMostKept;)
    if (i->second->is_over()) {
      forgotten.push_back(i->second);
      i = tests.erase(i);
    } else {
      ++i;
    }
}

}  // namespace

std::int64_t LiveTests::run(RunAsked asked) {
  std::vector<std::shared_ptr<LiveRun>> forgotten;
  std::shared_ptr<LiveRun> run;
  {
    const std::lock_guard lock(mutex_);
    if (ended_) throw Refused(503, "triax open is shutting down");
    forget_those_over(runs_, forgotten);
    const auto running = std::ranges::count_if(runs_, [](const auto& e) { return at_work(e); }) +
                         std::ssize(beginning_);
    if (running >= kMostAtWork)
      throw Refused(409, "eight tests are running already; wait for the end of one or stop it");
    if (!asked.rig.empty()) {
      const auto on_rig = [](const auto& one) { return !one->is_over() && one->is_on_rig(); };
      if (std::ranges::any_of(beginning_, on_rig) ||
          std::ranges::any_of(runs_, [&](const auto& entry) { return on_rig(entry.second); }))
        throw Refused(409, "a test is running on the rig already");
    }
    run = std::make_shared<LiveRun>(db_, std::move(asked));
    beginning_.push_back(run);
  }
  const auto begun = [&](std::int64_t id) {
    const std::lock_guard lock(mutex_);
    beginning_.remove(run);
    if (id != 0) runs_[id] = run;
  };
  try {
    const std::int64_t id = run->test();
    begun(id);
    return id;
  } catch (...) {
    begun(0);
    throw;
  }
}

void LiveTests::order(std::int64_t test, const RunOrder& order) {
  std::shared_ptr<LiveRun> run;
  {
    const std::lock_guard lock(mutex_);
    const auto found = runs_.find(test);
    if (found == runs_.end())
      throw Refused(409, "this test is run by another program; stop it there");
    run = found->second;
  }
  run->order(order);
}

LiveTests::Control LiveTests::control_of(std::int64_t test) {
  const std::lock_guard lock(mutex_);
  const auto found = runs_.find(test);
  if (found == runs_.end() || found->second->is_over()) return {};
  return {.controlled = true, .held = found->second->is_held()};
}

/// A feed that stands already. Inside the lock.
std::shared_ptr<LiveFeed> LiveTests::known_feed(std::int64_t test) const {
  if (const auto run = runs_.find(test); run != runs_.end()) return run->second->feed();
  const auto watch = watches_.find(test);
  return watch != watches_.end() && !watch->second->is_over() ? watch->second->feed() : nullptr;
}

/// Inside the lock.
void LiveTests::check_room_to_watch() const {
  if (ended_) throw Refused(503, "triax open is shutting down");
  if (std::ranges::count_if(watches_, [](const auto& e) { return at_work(e); }) >= kMostAtWork)
    throw Refused(503, "eight tests of other programs are shown already");
}

std::shared_ptr<LiveFeed> LiveTests::watched_feed(std::int64_t test) {
  std::vector<std::shared_ptr<LiveWatch>> forgotten;
  {
    const std::lock_guard lock(mutex_);
    check_room_to_watch();
  }
  auto watch = std::make_shared<LiveWatch>(db_, test);
  const std::lock_guard lock(mutex_);
  if (auto feed = known_feed(test)) return feed;
  forget_those_over(watches_, forgotten);
  check_room_to_watch();
  std::swap(watches_[test], watch);  // what stood there ends outside the lock
  return watches_[test]->feed();
}

/// Nothing is asked of the database inside the lock: orders to tests that run need it.
std::shared_ptr<LiveFeed> LiveTests::feed_of(std::int64_t test) {
  {
    const std::lock_guard lock(mutex_);
    if (auto feed = known_feed(test)) return feed;
  }
  const db::TestVersion stored = db::Store(db_).version(test);
  // One that was taken for interrupted may run again.
  if (stored.status == db::TestStatus::running) return watched_feed(test);
  {
    const std::lock_guard lock(mutex_);
    if (auto feed = known_feed(test)) return feed;
    if (const auto watch = watches_.find(test); watch != watches_.end())
      return watch->second->feed();
  }
  auto feed = std::make_shared<LiveFeed>();
  feed->begin_behind(std::max<std::int64_t>(stored.readings - 1, -1));
  feed->ended(std::string(to_string(stored.status)));
  return feed;
}

void LiveTests::end() {
  std::list<std::shared_ptr<LiveRun>> runs;
  std::map<std::int64_t, std::shared_ptr<LiveWatch>> watches;
  {
    const std::lock_guard lock(mutex_);
    ended_ = true;
    runs = std::exchange(beginning_, {});
    for (auto& [id, run] : std::exchange(runs_, {})) runs.push_back(run);
    watches = std::exchange(watches_, {});
  }
  for (const auto& run : runs) run->end();
}

}  // namespace triax::src
