#include "lab/records/findings.hpp"

#include <algorithm>

namespace triax::lab {

void Findings::note(const std::string& kind, std::int64_t line, const std::string& text) {
  const auto known = std::ranges::find(kinds_, kind, &Kind::name);
  if (known == kinds_.end()) {
    kinds_.push_back({kind, warnings_.size(), 0, line});
    warnings_.push_back({line, text});
    return;
  }
  ++known->more;
  known->last_line = line;
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
