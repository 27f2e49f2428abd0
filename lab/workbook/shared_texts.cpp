// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/workbook/shared_texts.hpp"

#include <algorithm>

namespace triax::lab {

void SharedTexts::end_text() {
  constexpr std::size_t kBlock = std::size_t{1} << 20;
  if (blocks_.empty() || blocks_.back().size() + pending_.size() > blocks_.back().capacity())
    blocks_.emplace_back().reserve(std::max(kBlock, pending_.size()));
  std::string& block = blocks_.back();
  places_.push_back({static_cast<std::uint32_t>(blocks_.size() - 1),
                     static_cast<std::uint32_t>(block.size()),
                     static_cast<std::uint32_t>(pending_.size())});
  block += pending_;
  held_ += pending_.size();
  pending_.clear();
}

std::optional<std::string_view> SharedTexts::at(std::size_t index) const {
  if (index >= places_.size()) return std::nullopt;
  const Place& place = places_[index];
  return std::string_view(blocks_[place.block]).substr(place.begin, place.size);
}

}  // namespace triax::lab
