// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/page/live/live_run.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <chrono>
#include <utility>

#include "lab/base/bad_input.hpp"
#include "lab/rig/simulated/virtual_rig.hpp"
#include "lab/rig/simulated/without_guard.hpp"
#include "lab/wire/remote/remote_rig.hpp"
#include "src/page/request/request.hpp"
#include "src/study/triaxial/test_run.hpp"

namespace triax::src {
namespace {

std::string now_utc() {
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)));
}

std::string by_whom(const RunOrder& order) {
  return fmt::format("by {} on the page, {}", order.who, now_utc());
}

}  // namespace

LiveRun::LiveRun(std::string db, RunAsked asked)
    : db_(std::move(db)), asked_(std::move(asked)), thread_([this] { run(); }) {}

LiveRun::~LiveRun() {
  end();
  changed_.notify_all();
  thread_.join();
}

std::int64_t LiveRun::test() {
  constexpr std::chrono::seconds kPatience{30};
  std::unique_lock lock(mutex_);
  changed_.wait_for(lock, kPatience, [this] { return id_ || failure_ || ending_; });
  if (id_) return *id_;
  if (failure_) std::rethrow_exception(failure_);
  throw lab::WorkFailed("the test has not begun after 30 s; the database may be locked");
}

void LiveRun::order(const RunOrder& order) {
  if (over_) throw Refused(409, "the test has ended");
  if (order.kind == RunOrder::Kind::hold && held_) throw Refused(409, "the test is held already");
  if (order.kind == RunOrder::Kind::resume && !held_) throw Refused(409, "the test is not held");
  const std::lock_guard lock(mutex_);
  constexpr std::size_t kMost = 16;
  if (orders_.size() >= kMost)
    throw Refused(503, "too many commands are waiting for the rig; try again later");
  orders_.push_back(order);
  changed_.notify_all();
}

/// By the thread of the test, between two readings.
void LiveRun::obey(lab::RigSoftware& rig) {
  std::vector<RunOrder> orders;
  {
    const std::lock_guard lock(mutex_);
    orders.swap(orders_);
  }
  for (const RunOrder& order : orders) {
    const std::string by = by_whom(order);
    if (order.kind == RunOrder::Kind::hold && rig.hold(by)) held_ = true;
    if (order.kind == RunOrder::Kind::resume && rig.resume(by)) held_ = false;
    if (order.kind == RunOrder::Kind::stop && rig.stop_safely(by)) held_ = false;
  }
}

/// Time stands still for no test that is held; but one that runs as fast as it can would fill the
/// disk meanwhile with readings of which nothing comes.
void LiveRun::wait_while_held() {
  constexpr std::chrono::milliseconds kBetweenReadings{200};
  if (!held_ || asked_.speed > 0 || !asked_.rig.empty()) return;
  std::unique_lock lock(mutex_);
  changed_.wait_for(lock, kBetweenReadings, [this] { return !orders_.empty() || ending_; });
}

/// Whether the session is to break the test off.
bool LiveRun::look(lab::RigSoftware& rig) {
  obey(rig);
  wait_while_held();
  return ending_;
}

lab::SessionListener LiveRun::listener() {
  const auto feed = feed_;
  return {
      .started = [this](const lab::RecordHeader& header) { header_ = header; },
      .scanned =
          [this, feed, stage = 0](const lab::Reading& reading, const lab::State& state) mutable {
            if (std::exchange(stage, reading.stage) != reading.stage)
              if (const auto* info = header_.stage(reading.stage)) feed->stage_began(*info);
            feed->scanned(reading, state);
          },
      .second_order_work = {},
      .happened = [feed](const lab::Event& event) { feed->happened(event); },
      .doubted = [feed](const lab::SensorFinding& finding) { feed->doubted(finding); },
      .foreseen = [feed](const lab::Forecast& forecast) { feed->foreseen(forecast); },
      .progressed = [feed](double share) { feed->progressed(share); }};
}

std::int64_t LiveRun::run_on(lab::RigSoftware& rig) {
  lab::SessionOptions options;
  options.speed = asked_.rig.empty() ? asked_.speed : 0;
  options.stop = [this, &rig] { return look(rig); };
  if (asked_.rig.empty())
    options.without_guard =
        lab::without_guard(asked_.programme, asked_.seed, [this] { return ending_.load(); });
  std::string db = db_;
  return study::run_test(rig, options, db, {listener()},
                         {.say = {}, .stop = [this] { return ending_.load(); }},
                         [this](std::int64_t id) {
                           const std::lock_guard lock(mutex_);
                           id_ = id;
                           changed_.notify_all();
                         });
}

void LiveRun::run() {
  std::string error;
  try {
    std::int64_t id = 0;
    if (asked_.rig.empty()) {
      lab::VirtualRig rig(asked_.programme, asked_.seed);
      id = run_on(rig);
    } else {
      const lab::RigFile file = lab::load_rig_file(asked_.rig);
      lab::LineLoop loop;
      lab::RemoteRig rig(loop, file, asked_.programme, [this] { return ending_.load(); });
      id = run_on(rig);
    }
    const std::lock_guard lock(mutex_);
    id_ = id;
  } catch (const std::exception& failure) {
    error = failure.what();
    const std::lock_guard lock(mutex_);
    failure_ = std::current_exception();
  }
  over_ = true;
  held_ = false;
  feed_->ended(error.empty() ? "complete" : "interrupted", error);
  changed_.notify_all();
}

}  // namespace triax::src
