// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/wire/line/line_loop.hpp"

#include <algorithm>
#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <chrono>
#include <utility>

namespace triax::lab {
namespace {
using LoopClock = std::chrono::steady_clock;
constexpr double kLongestWait_s = 1e9;

LoopClock::duration loop_duration(double seconds) {
  return std::chrono::duration_cast<LoopClock::duration>(
      std::chrono::duration<double>(std::clamp(seconds, 0.0, kLongestWait_s)));
}
}  // namespace

struct LineTimer::State {
  explicit State(boost::asio::io_context& context) : timer(context) {}
  boost::asio::steady_timer timer;
  std::function<void()> what;
};

LineTimer& LineTimer::operator=(LineTimer&& other) noexcept {
  if (this != &other) {
    cancel();
    state_ = std::move(other.state_);
  }
  return *this;
}

LineTimer::~LineTimer() { cancel(); }

void LineTimer::cancel() {
  if (!state_) return;
  state_->what = nullptr;
  state_->timer.cancel();
  state_.reset();
}

bool LineTimer::waits() const { return state_ && state_->what; }

struct LineLoop::Impl {
  // One thread: no locks inside.
  boost::asio::io_context context{1};
  boost::asio::executor_work_guard<boost::asio::io_context::executor_type> work{
      context.get_executor()};
  LoopClock::time_point start = LoopClock::now();
  LoopClock::time_point turned = start;  ///< when handlers could last run
  LoopClock::duration longest_stall{};

  void turn() {
    const LoopClock::time_point now = LoopClock::now();
    longest_stall = std::max(longest_stall, now - std::exchange(turned, now));
  }

  /// Runs the next handler that becomes ready within `most`: looks for it again and again for
  /// kSoon before it sleeps, or sleeps at once, whichever brought the next one sooner of late.
  /// Being woken costs 5 to 50 us, by what the other processors do and where the asker runs; the
  /// other way is tried now and then. Waits beyond kLong count alike, and then a processor that
  /// others may need is left to them.
  void run_next(LoopClock::duration most) {
    constexpr LoopClock::duration kSoon = std::chrono::microseconds(30), kLong = 4 * kSoon;
    constexpr int kTryOther = 64, kRemembered = 8;
    const bool look = (looking < sleeping) != (++waits % kTryOther == 0);
    const LoopClock::time_point begin = LoopClock::now();
    if (!(look && came_until(begin + kSoon))) context.run_one_for(most);
    LoopClock::duration& mean = look ? looking : sleeping;
    mean += (std::min(LoopClock::now() - begin, kLong) - mean) / kRemembered;
  }
  bool came_until(LoopClock::time_point until) {
    do {
      if (context.poll_one() > 0) return true;
    } while (LoopClock::now() < until);
    return false;
  }
  LoopClock::duration looking{}, sleeping{};  ///< mean waits
  int waits = 0;
};

LineLoop::LineLoop() : impl_(std::make_unique<Impl>()) {}
LineLoop::~LineLoop() = default;

double LineLoop::now_s() const {
  return std::chrono::duration<double>(LoopClock::now() - impl_->start).count();
}

LineTimer LineLoop::at(double when_s, std::function<void()> what) {
  LineTimer timer;
  timer.state_ = std::make_shared<LineTimer::State>(impl_->context);
  timer.state_->what = std::move(what);
  timer.state_->timer.expires_at(impl_->start + loop_duration(when_s));
  timer.state_->timer.async_wait([state = timer.state_](const boost::system::error_code&) {
    // It may be cancelled after it was due and before its turn; and it may put another in its
    // place.
    if (const auto due = std::exchange(state->what, nullptr)) due();
  });
  return timer;
}

void LineLoop::soon(std::function<void()> what) {
  boost::asio::post(impl_->context, std::move(what));
}

void LineLoop::poll() {
  // Handlers make handlers: under a flood there would be no end.
  for (int done = 0; done < 1000 && impl_->context.poll_one() > 0; ++done) {
  }
}

void LineLoop::run_for(double seconds) {
  run_until([] { return false; }, now_s() + seconds);
}

double LineLoop::take_longest_stall_s() {
  impl_->turn();
  return std::chrono::duration<double>(std::exchange(impl_->longest_stall, {})).count();
}

bool LineLoop::run_until(const std::function<bool()>& reached, double deadline_s) {
  constexpr double kLook_s = 0.05;
  LineTimer wake;  // a wait alone ends up to 1 ms late, a timer does not
  for (;;) {
    impl_->turn();
    if (reached()) return true;
    const double left_s = deadline_s - now_s();
    if (!(left_s > 0)) {
      // Once more what is ready, so that a loop of short deadlines moves on.
      poll();
      return reached();
    }
    if (left_s < kLook_s && !wake.waits()) wake = at(deadline_s, [] {});
    impl_->run_next(loop_duration(std::min(left_s, kLook_s)));
  }
}

boost::asio::io_context& LineLoop::context() { return impl_->context; }

}  // namespace triax::lab
