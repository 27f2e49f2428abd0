// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/records/findings.hpp"

#include <algorithm>
#include <utility>

namespace triax::lab {
namespace {
constexpr std::size_t kMostKinds = 200;
}

bool Findings::repeats(std::string_view kind, std::int64_t line) {
  auto known = std::ranges::find(kinds_, kind, &Kind::name);
  if (known == kinds_.end()) {
    if (kinds_.size() < kMostKinds) return false;
    known = kinds_.end() - 1;
  }
  ++known->more;
  known->last_line = line;
  return true;
}

void Findings::note(std::string_view kind, std::int64_t line, std::string text) {
  if (repeats(kind, line)) return;
  kinds_.push_back({std::string(kind), warnings_.size(), 0, line});
  warnings_.push_back({line, std::move(text)});
}

void Findings::finish() {
  for (Kind& kind : kinds_) {
    if (kind.more == 0) continue;
    warnings_[kind.warning].text += " (and " + std::to_string(kind.more) +
                                    " more, the last in line " + std::to_string(kind.last_line) +
                                    ")";
    kind.more = 0;
  }
}

}  // namespace triax::lab
