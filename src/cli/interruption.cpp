// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/cli/interruption.hpp"

#include <atomic>

namespace triax::src {
namespace {

// All that a signal handler may touch.
std::atomic<bool> signalled = false;
static_assert(std::atomic<bool>::is_always_lock_free);

void take_note(int) { signalled = true; }

void catch_once(int signal, struct sigaction& before) {
  struct sigaction once {};
  once.sa_handler = take_note;
  once.sa_flags = static_cast<int>(SA_RESETHAND) | SA_RESTART;
  sigaction(signal, nullptr, &before);
  if (before.sa_handler != SIG_IGN) sigaction(signal, &once, nullptr);
}

}  // namespace

Interruption::Interruption() {
  signalled = false;
  catch_once(SIGINT, interrupt_before_);
  catch_once(SIGTERM, terminate_before_);
}

Interruption::~Interruption() {
  sigaction(SIGINT, &interrupt_before_, nullptr);
  sigaction(SIGTERM, &terminate_before_, nullptr);
}

bool Interruption::requested() const { return signalled; }

}  // namespace triax::src
