// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Memory that browsers may make this program hold, all of them together.
#include <atomic>
#include <cstddef>

namespace triax::src {

class MemoryBudget {
 public:
  explicit MemoryBudget(std::size_t most) : most_(most) {}

  /// A part of it as long as this lives; may be empty.
  class Share {
   public:
    Share() = default;
    Share(Share&& other) noexcept : of_(other.of_), bytes_(other.bytes_) { other.of_ = nullptr; }
    Share& operator=(Share&& other) noexcept;
    ~Share() { give_back(); }
    explicit operator bool() const { return of_ != nullptr; }
    /// This one becomes as much larger. Pre-condition: of the same budget, where neither is empty.
    void add(Share more);

   private:
    friend class MemoryBudget;
    Share(MemoryBudget* of, std::size_t bytes) : of_(of), bytes_(bytes) {}
    void give_back();
    MemoryBudget* of_ = nullptr;
    std::size_t bytes_ = 0;
  };

  /// An empty share where so much is not left.
  Share take(std::size_t bytes);
  std::size_t taken() const { return taken_; }
  std::size_t most() const { return most_; }

 private:
  std::size_t most_;
  std::atomic<std::size_t> taken_ = 0;
};

}  // namespace triax::src
