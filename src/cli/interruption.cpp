// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/cli/interruption.hpp"

#include <atomic>
#include <ctime>

namespace triax::src {
namespace {

// All that a signal handler may touch.
std::atomic<bool> signalled = false;
std::atomic<long> orderly_ns = 0, orderly_until_ns = 0;
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<long>::is_always_lock_free);

void take_note(int signal) {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  const long now_ns = now.tv_sec * 1'000'000'000 + now.tv_nsec;
  if (!signalled.exchange(true)) {
    orderly_until_ns = now_ns + orderly_ns;
  } else if (now_ns >= orderly_until_ns) {
    std::signal(signal, SIG_DFL);
    std::raise(signal);  // comes when this handler has ended
  }
}

void catch_it(int signal, struct sigaction& before) {
  struct sigaction noted {};
  noted.sa_handler = take_note;
  noted.sa_flags = SA_RESTART;
  sigaddset(&noted.sa_mask, SIGINT);
  sigaddset(&noted.sa_mask, SIGTERM);
  sigaction(signal, nullptr, &before);
  if (before.sa_handler != SIG_IGN) sigaction(signal, &noted, nullptr);
}

}  // namespace

Interruption::Interruption(std::chrono::seconds orderly) {
  signalled = false;
  orderly_ns = std::chrono::nanoseconds(orderly).count();
  catch_it(SIGINT, interrupt_before_);
  catch_it(SIGTERM, terminate_before_);
}

Interruption::~Interruption() {
  sigaction(SIGINT, &interrupt_before_, nullptr);
  sigaction(SIGTERM, &terminate_before_, nullptr);
}

// NOLINTNEXTLINE(readability-convert-member-functions-to-static): asked of who caught the signal.
bool Interruption::requested() const { return signalled; }

}  // namespace triax::src
