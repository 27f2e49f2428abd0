// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/wire/remote/absences.hpp"

#include <fmt/format.h>

#include "lab/wire/remote/wire_instrument.hpp"

namespace triax::lab {

std::vector<std::string> Absences::news(double now_s) {
  std::vector<std::string> news;
  for (auto& [one, gap] : all_) {
    const std::string& name = one->described().name;
    if (gap.why.empty()) {
      if (!gap.told.empty())
        news.push_back(fmt::format("{} responds again after {:.1f} s", name, now_s - gap.since_s));
      gap.told.clear();
      continue;
    }
    if (gap.told.empty()) gap.since_s = now_s;
    if (gap.told.insert(gap.why.substr(0, gap.why.find(':'))).second)
      news.push_back(fmt::format("{} gives no readings: {}", name, gap.why));
  }
  return news;
}

}  // namespace triax::lab
