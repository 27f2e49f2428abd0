// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <atomic>
#include <cstdint>

namespace triax::sim {

/// Tells objects that never change apart for as long as the program runs, also where one is built
/// in the place of another: a copy has the same mark, no other object has. A law's answer that is
/// kept for the next question is known by it.
class Mark {
 public:
  bool operator==(const Mark&) const = default;

 private:
  inline static std::atomic<std::uint64_t> made{0};
  std::uint64_t number_ = ++made;
};

}  // namespace triax::sim
