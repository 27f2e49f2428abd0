// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The texts that cells of a workbook share, in memory that is never copied while it grows.
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <string_view>

namespace triax::lab {

class SharedTexts {
 public:
  /// A piece of the text under way.
  void add(std::string_view piece) { pending_ += piece; }
  /// The text under way is complete.
  void end_text();
  /// Of the text under way.
  std::size_t pending_size() const { return pending_.size(); }

  /// Nothing where there is no such text.
  std::optional<std::string_view> at(std::size_t index) const;
  /// That are held, with what it takes to find them.
  std::size_t bytes() const { return held_ + places_.size() * sizeof(Place); }

 private:
  struct Place {
    std::uint32_t block, begin, size;
  };
  std::deque<std::string> blocks_;
  std::deque<Place> places_;
  std::string pending_;
  std::size_t held_ = 0;
};

}  // namespace triax::lab
