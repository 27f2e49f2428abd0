// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The guard of a programme while its test runs: what the alarm said last, whether that calls for
// it, and what it did. It acts once.
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lab/rig/guard_stages.hpp"

namespace triax::lab {

class RigGuard {
 public:
  explicit RigGuard(const GuardedProgramme& all)
      : guard_(all.programme.guard), successor_(all.successor) {}

  void hear(WarningLevel level) { said_ = level; }
  /// Whether it is called for in this stage of the programme, which runs, and has not acted yet.
  bool is_due(std::size_t place, const Stage& stage) const;
  /// Pre-condition: it is due. From now on it has acted.
  const Guard& act();
  /// Whether q is being taken back by it.
  bool unloads() const { return acted_ && guard_->action == Guard::Action::unload; }
  double hold_s() const { return guard_->hold_s; }

  /// Whether another stage follows this one by itself: those of the guard stand after those of the
  /// programme and are followed by none.
  bool is_followed(std::size_t place) const { return place + 1 < successor_.size(); }
  /// The stage of the guard that takes over from this one. Pre-condition: its action has stages.
  std::size_t successor(std::size_t place) const { return *successor_[place]; }

  /// What it did, in words, once.
  std::optional<std::string> take_news() { return std::exchange(did_, {}); }

 private:
  std::optional<Guard> guard_;
  std::vector<std::optional<std::size_t>> successor_;
  WarningLevel said_ = WarningLevel::none;
  bool acted_ = false;
  std::optional<std::string> did_;
};

}  // namespace triax::lab
