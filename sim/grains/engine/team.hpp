// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A few threads that share rounds of work.
//
// A round is a fixed number of pieces. Every thread has its own ones, whose data are in the cache
// of its core. Those of a thread that has not come to the round, or is late by as much as the round
// has taken, are done by others: one that the machine does not run at the moment costs its share
// and no more. A thread that is merely a little slower keeps its pieces: taken by another core they
// cost three times as much. The thread that finishes the last piece does alone what is between this
// round and the next.
#include <array>
#include <atomic>
#include <chrono>
#include <functional>
#include <thread>
#include <vector>

namespace triax::sim {

/// What a team does together. None may throw; which thread does which piece is left to chance.
struct TeamWork {
  int pieces = 1;                             ///< of every round, 1 to Team::kMostPieces
  std::function<void(unsigned, int)> piece;   ///< (round, piece), both from 0
  std::function<bool(unsigned)> after_round;  ///< (round); false: it was the last one
};

class Team {
 public:
  static constexpr int kMostPieces = 16;

  /// The calling thread is number 0; starts `threads` − 1 others, which sleep between works.
  explicit Team(int threads);
  ~Team();
  Team(const Team&) = delete;
  Team& operator=(const Team&) = delete;

  int size() const { return static_cast<int>(others_.size()) + 1; }

  /// Does rounds until after_round() says that it was the last. Every piece of a round sees what
  /// all earlier rounds wrote. From one thread at a time. Throws std::invalid_argument on a number
  /// of pieces out of its range.
  void run(const TeamWork& work);

 private:
  // round_ grows by 2 from round to round: odd while one is open, even between two works. A piece
  // is free in round r as long as its `taken` is r − 2, and r − 2 it is in no other round: a thread
  // that comes late with an old r finds nothing. So whoever takes a piece knows that the round is
  // open, and that work_ and first_ stay as they are until it is done.
  struct alignas(64) Piece {
    std::atomic<unsigned> taken{0};  ///< the round it was last taken in
  };
  struct alignas(64) Seat {
    std::atomic<unsigned> here{0};  ///< the last round that its thread came to
  };
  using Clock = std::chrono::steady_clock;
  void serve(int thread);
  unsigned work_on(int thread, unsigned round);
  void take_part(int thread, unsigned round);
  bool take_pieces_of(int owner, unsigned round);
  bool look_for_change(unsigned round, Clock::duration patience) const;
  void close(unsigned round);
  void wait_for_change(unsigned round) const;

  std::array<Piece, kMostPieces> pieces_;
  std::vector<Seat> seats_;  ///< of every thread
  alignas(64) std::atomic<unsigned> round_{0};
  std::atomic<bool> leaving_{false};
  std::atomic<int> pieces_a_round_{1};
  alignas(64) std::atomic<int> left_{0};        ///< pieces of the open round that are not done
  alignas(64) const TeamWork* work_ = nullptr;  ///< read by all: not beside what all write
  unsigned first_ = 0;                          ///< what round_ was in the first round of this work
  std::vector<std::thread> others_;
};

}  // namespace triax::sim
