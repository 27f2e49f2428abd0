// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/grains/engine/team.hpp"

#include <stdexcept>

#if defined(__x86_64__)
#include <emmintrin.h>
#endif

namespace triax::sim {
namespace {

/// How long a thread looks for the next round before it sleeps: rounds take some ten microseconds.
constexpr std::chrono::microseconds kLook{100};
/// How often it looks so long while a round is open, offering its processor in between: who sleeps
/// comes late to the next round, finds its pieces taken, and sleeps again.
constexpr int kLooksInRound = 4;
/// Looks between two readings of the clock.
constexpr int kLooks = 64;
/// How often a thread that holds no piece offers its processor to whoever waits for one. Schedulers
/// give turns of some milliseconds: a thread that gives its own back in time is seldom stopped in
/// the middle of a piece, where the others would have to wait for it.
constexpr std::chrono::microseconds kOffer{2000};

void breathe() {
#if defined(__x86_64__)
  _mm_pause();
#endif
}

void run_alone(const TeamWork& work) {
  for (unsigned round = 0;; ++round) {
    for (int k = 0; k < work.pieces; ++k) work.piece(round, k);
    if (!work.after_round(round)) return;
  }
}

}  // namespace

Team::Team(int threads) : seats_(static_cast<std::size_t>(threads)) {
  for (int t = 1; t < threads; ++t) others_.emplace_back([this, t] { serve(t); });
}

Team::~Team() {
  leaving_.store(true);
  round_.fetch_add(2);  // a change that opens no round
  round_.notify_all();
  for (std::thread& t : others_) t.join();
}

void Team::run(const TeamWork& work) {
  if (work.pieces < 1 || work.pieces > kMostPieces)
    throw std::invalid_argument("a round of a team has 1 to 16 pieces");
  if (others_.empty()) return run_alone(work);
  const unsigned round = round_.load(std::memory_order_relaxed) + 1;
  for (Piece& piece : pieces_) piece.taken.store(round - 2, std::memory_order_relaxed);
  work_ = &work;
  first_ = round;
  pieces_a_round_.store(work.pieces, std::memory_order_relaxed);
  left_.store(work.pieces, std::memory_order_relaxed);
  round_.store(round);
  round_.notify_all();
  work_on(0, round);
}

/// Takes part until no round is open; returns what round_ was then.
unsigned Team::work_on(int thread, unsigned round) {
  auto offered = Clock::now();
  while (round % 2 == 1) {
    take_part(thread, round);
    wait_for_change(round);
    round = round_.load(std::memory_order_acquire);
    if (Clock::now() - offered < kOffer) continue;
    std::this_thread::yield();
    offered = Clock::now();
  }
  return round;
}

void Team::take_part(int thread, unsigned round) {
  seats_[static_cast<std::size_t>(thread)].here.store(round, std::memory_order_relaxed);
  const auto begun = Clock::now();
  if (take_pieces_of(thread, round)) return;
  const auto away = [&](int other) {
    return round - seats_[static_cast<std::size_t>(other)].here.load(std::memory_order_relaxed) > 2;
  };
  for (int i = 1; i < size(); ++i) {
    const int other = (thread + i) % size();
    if (away(other) && take_pieces_of(other, round)) return;
  }
  if (look_for_change(round, Clock::now() - begun)) return;
  for (int i = 1; i < size(); ++i)
    if (take_pieces_of((thread + i) % size(), round)) return;
}

/// Does what is left of a thread's pieces; true if that ended the round.
bool Team::take_pieces_of(int owner, unsigned round) {
  const int count = pieces_a_round_.load(std::memory_order_relaxed);
  const int end = count * (owner + 1) / size();
  for (int k = count * owner / size(); k < end; ++k) {
    std::atomic<unsigned>& taken = pieces_[static_cast<std::size_t>(k)].taken;
    unsigned free = round - 2;
    if (taken.load(std::memory_order_relaxed) != free) continue;
    if (!taken.compare_exchange_strong(free, round, std::memory_order_relaxed)) continue;
    work_->piece((round - first_) / 2, k);
    if (left_.fetch_sub(1, std::memory_order_acq_rel) != 1) continue;
    close(round);
    return true;
  }
  return false;
}

/// By the thread that finished the last piece of the round.
void Team::close(unsigned round) {
  const bool more = work_->after_round((round - first_) / 2);
  left_.store(work_->pieces, std::memory_order_relaxed);
  // In the one order of all such operations: notify_all() then knows of whoever went to sleep on
  // the round before.
  round_.store(more ? round + 2 : round + 1);
  round_.notify_all();
}

/// Looks without sleeping; false if the round is the same when patience ends.
bool Team::look_for_change(unsigned round, Clock::duration patience) const {
  if (round_.load(std::memory_order_acquire) != round) return true;
  const auto until = Clock::now() + patience;
  for (int look = 1; round_.load(std::memory_order_acquire) == round; ++look) {
    breathe();
    if (look % kLooks == 0 && Clock::now() > until) return false;
  }
  return true;
}

void Team::wait_for_change(unsigned round) const {
  const int looks = round % 2 == 1 ? kLooksInRound : 1;
  for (int i = 0; i < looks; ++i) {
    if (look_for_change(round, kLook)) return;
    std::this_thread::yield();
  }
  round_.wait(round, std::memory_order_acquire);
}

void Team::serve(int thread) {
  unsigned seen = 0;
  while (!leaving_.load()) {
    wait_for_change(seen);
    seen = work_on(thread, round_.load(std::memory_order_acquire));
  }
}

}  // namespace triax::sim
