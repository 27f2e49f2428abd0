#include "lab/reduction/closure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace triax::lab {

void Closure::add(const Reading& reading, const State& state, bool in_shear) {
  const double theirs = reading[Quantity::deviator_stress];
  if (!in_shear || std::isnan(theirs) || std::isnan(state.q)) return;
  ours_theirs_ += state.q * theirs;
  ours_ours_ += state.q * state.q;
  const double their_area = reading[Quantity::current_area];
  if (!(their_area > 0)) return;
  if (!their_start_area_) their_start_area_ = their_area;
  area_ratio_sum_ += their_area / state.area_m2;
  ++area_count_;
}

std::optional<Check> Closure::check(std::optional<double> start_area,
                                    const std::vector<Warning>& record_warnings) const {
  if (!(ours_ours_ > 0)) return std::nullopt;
  const double difference = 1 - ours_theirs_ / ours_ours_;
  Check c{.name = "closure_deviator_stress",
          .measured = difference,
          .limit = kLimit,
          .ok = std::fabs(difference) <= kLimit};
  c.note = fmt::format("the file's own q is {:.2f} % {} than ours", std::fabs(difference) * 100,
                       difference < 0 ? "higher" : "lower");
  if (area_count_ == 0 || !start_area || c.ok) return c;

  const double area_ratio = area_ratio_sum_ / static_cast<double>(area_count_);
  if (std::fabs(1 / area_ratio - 1 + difference) > 0.01) return c;
  c.note += fmt::format(
      ", because of the area: at the start of shear the file takes {:.1f} mm2, ours is {:.1f} mm2",
      *their_start_area_ * 1e6, *start_area * 1e6);
  const bool joined = std::ranges::any_of(record_warnings, [](const Warning& w) {
    return w.text.find("back_volume") != std::string::npos;
  });
  if (joined)
    c.note +=
        "; its volume counter was set back between stages while the reference for the volume "
        "change was kept";
  return c;
}

}  // namespace triax::lab
