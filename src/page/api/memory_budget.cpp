// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/page/api/memory_budget.hpp"

#include <utility>

namespace triax::src {

void MemoryBudget::Share::give_back() {
  if (of_ != nullptr) of_->taken_ -= bytes_;
  of_ = nullptr;
}

MemoryBudget::Share& MemoryBudget::Share::operator=(Share&& other) noexcept {
  if (this == &other) return *this;
  give_back();
  of_ = std::exchange(other.of_, nullptr);
  bytes_ = other.bytes_;
  return *this;
}

void MemoryBudget::Share::add(Share more) {
  if (of_ == nullptr)
    *this = std::move(more);
  else if (std::exchange(more.of_, nullptr) != nullptr)
    bytes_ += more.bytes_;
}

MemoryBudget::Share MemoryBudget::take(std::size_t bytes) {
  std::size_t taken = taken_;
  do {
    if (bytes > most_ || taken > most_ - bytes) return {};
  } while (!taken_.compare_exchange_weak(taken, taken + bytes));
  return {this, bytes};
}

}  // namespace triax::src
