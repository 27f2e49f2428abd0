// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/records/stage_split.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "lab/base/statistics.hpp"
#include "lab/measured/assessment_limits.hpp"

namespace triax::lab {
namespace {

constexpr std::size_t kMinSamples = 20;   ///< samples that are split
constexpr std::size_t kFirst = 5;         ///< samples that show the load cell without a load
constexpr std::size_t kMinStretch = 5;    ///< samples whose drainage counts
constexpr double kDeviatorLoad_pa = 5e3;  ///< of a deviator load, as in infer_stages
constexpr double kShareOfP = 0.1;         ///< of p′, if that is less
constexpr double kHeld = 0.02;            ///< of a held q
constexpr double kMinHeld = 0.9;  ///< of the largest q: what remains after a fall is not held
/// Of the change of confinement that follows: at a peak of q along a strain path q is constant,
/// too.
constexpr double kMinHeldShare = 0.8;
constexpr double kConfinement = 0.05;  ///< of p′, that cell or back pressure take away meanwhile
constexpr double kMinFlow = 1e-4;      ///< volume change that counts, of the specimen's volume
constexpr double kNoises = 6;          ///< standard deviations that noise does not reach
/// Below and above this f/(f + w) the drainage is closed and open.
constexpr double kClosed = 1.0 / 3, kOpen = 2.0 / 3;
/// Flow, in the smallest volume that counts, that must be missing before a valve counts as shut.
constexpr double kMinMissed = 3;

/// Standard deviation of the noise, from the second differences; 0 of less than three values.
double noise_of(std::span<const double> values) {
  std::vector<double> bends;
  for (std::size_t i = 1; i + 1 < values.size(); ++i)
    if (const double bend = values[i + 1] - 2 * values[i] + values[i - 1]; !std::isnan(bend))
      bends.push_back(std::fabs(bend));
  return bends.empty() ? 0 : median(std::move(bends)) / 0.6745 / std::sqrt(6.0);
}

/// The median of each value and its two neighbours: without single outliers.
std::vector<double> without_spikes(const std::vector<double>& values) {
  std::vector<double> out = values;
  for (std::size_t i = 1; i + 1 < values.size(); ++i) {
    const double low = std::min(values[i - 1], values[i + 1]);
    const double high = std::max(values[i - 1], values[i + 1]);
    out[i] = std::clamp(values[i], low, high);
  }
  return out;
}

struct Range {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  void add(double value) {
    if (std::isnan(value)) return;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  double beyond(double noise) const { return high < low ? 0 : std::max(high - low - noise, 0.0); }
};

/// What the samples show, in SI.
struct Course {
  std::vector<double> q, cell, back, p_eff;
  std::vector<double> volume, excess;  ///< volume over that of the specimen; u − u_b
  double q_noise = 0, cell_noise = 0, back_noise = 0, volume_noise = 0, excess_noise = 0;
  double unloaded_q = 0;  ///< what the load cell shows without a load
  double min_flow = 0;    ///< volumetric strain that counts
  bool has_volume = false;
  /// A stress that counts.
  double worth(std::size_t i) const {
    return std::min(kDeviatorLoad_pa, kShareOfP * std::max(p_eff[i], 0.0));
  }
};

/// From `from` to before `until`, of one drainage.
struct Stretch {
  std::size_t from = 0, until = 0;  ///< first sample, and the one after the last
  Drainage drainage = Drainage::unknown;
  double flow = 0;
};

/// f and w of the samples that were added, as volumetric strains.
struct Drained {
  Range volume, excess;
  double p_eff = 0;
  void add(const Course& course, std::size_t i) {
    volume.add(course.volume[i]);
    excess.add(course.excess[i]);
    if (course.p_eff[i] > p_eff) p_eff = course.p_eff[i];
  }
  double flow(const Course& course) const { return volume.beyond(kNoises * course.volume_noise); }
  double driven(const Course& course) const {
    if (!(p_eff > 0)) return 0;
    return excess.beyond(kNoises * course.excess_noise) / (StageSplit::kBulk * p_eff);
  }
};

Drainage drainage_of(double flow, double driven, double min_flow) {
  if (std::max(flow, driven) < min_flow) return Drainage::unknown;
  const double degree = flow / (flow + driven);
  if (degree < kClosed) return Drainage::closed;
  return degree > kOpen ? Drainage::open : Drainage::unknown;
}

/// The stretches from `from` to `until` that cost least. Without a volume nothing shows drainage.
std::vector<Stretch> stretches(const Course& course, std::size_t from, std::size_t until) {
  if (!course.has_volume) return {{from, until, Drainage::unknown, 0}};
  const std::size_t count = until - from;
  std::vector<double> cost(count + 1, std::numeric_limits<double>::infinity());
  std::vector<std::size_t> begin(count + 1, 0);
  cost[0] = 0;
  for (std::size_t end = 1; end <= count; ++end) {
    Drained drained;
    for (std::size_t i = end; i-- > 0;) {
      drained.add(course, from + i);
      const double misfit = std::min(drained.flow(course), drained.driven(course));
      const double whole = cost[i] + misfit + StageSplit::kChange * course.min_flow;
      if (whole < cost[end]) cost[end] = whole, begin[end] = i;
    }
  }
  std::vector<Stretch> all;
  for (std::size_t end = count; end > 0; end = begin[end]) {
    Drained drained;
    for (std::size_t i = begin[end]; i < end; ++i) drained.add(course, from + i);
    all.push_back({from + begin[end], from + end,
                   drainage_of(drained.flow(course), drained.driven(course), course.min_flow),
                   drained.flow(course)});
  }
  std::ranges::reverse(all);
  return all;
}

/// The sample of `open` from which the volume is that of `closed`, which follows: the pore pressure
/// may rest for long after the valve was shut.
std::size_t end_of_flow(const Course& course, const Stretch& open, const Stretch& closed) {
  const auto at = [&](std::size_t i) {
    return course.volume.begin() + static_cast<std::ptrdiff_t>(i);
  };
  const double level = median({at(closed.from), at(closed.until)});
  std::size_t shut = closed.from;
  while (shut > open.from + 1 && std::fabs(course.volume[shut - 1] - level) < course.min_flow / 2)
    --shut;
  return shut;
}

/// Neighbours of one drainage are one; a stretch that shows none is part of the next that does, or
/// of the last. One that is closed after the valve was open lasts so long that flow is missing: in
/// a fall the pore pressure runs ahead of the drainage.
std::vector<Stretch> joined_stretches(std::vector<Stretch> all, const Course& course) {
  for (std::size_t i = all.size(); i-- > 0;) {
    const bool shows_none =
        all[i].drainage == Drainage::unknown || all[i].until - all[i].from < kMinStretch;
    if (shows_none && i + 1 < all.size()) all[i].drainage = all[i + 1].drainage;
  }
  std::vector<Stretch> out;
  for (Stretch& next : all) {
    const bool shuts =
        !out.empty() && out.back().drainage == Drainage::open && next.drainage == Drainage::closed;
    const std::size_t shut = shuts ? end_of_flow(course, out.back(), next) : next.from;
    const bool is_short =
        shuts && out.back().flow * static_cast<double>(next.until - shut) <
                     kMinMissed * course.min_flow * static_cast<double>(shut - out.back().from);
    const bool joins = !out.empty() && (next.drainage == out.back().drainage || is_short ||
                                        next.drainage == Drainage::unknown);
    if (joins) {
      out.back().until = next.until;
      out.back().flow += next.flow;
      continue;
    }
    if (!out.empty()) out.back().until = shut;
    next.from = shut;
    out.push_back(next);
  }
  return out;
}

double load(const Course& course, std::size_t i) {
  return std::fabs(course.q[i] - course.unloaded_q);
}

bool is_loaded(const Course& course, std::size_t i) {
  return load(course, i) > std::max(course.worth(i), kNoises * course.q_noise);
}

/// The last sample without a deviator load: from the second after it on q exceeds what counts.
/// Empty if there is never a load.
std::optional<std::size_t> start_of_load(const Course& course) {
  std::size_t at = 0;
  while (at + 1 < course.q.size() && !(is_loaded(course, at) && is_loaded(course, at + 1))) ++at;
  if (at + 1 >= course.q.size()) return std::nullopt;
  while (at > 0 && load(course, at) > 2 * course.q_noise) --at;
  return at > 0 ? at - 1 : 0;
}

/// Before `until` the cell pressure, the pore pressure or the volume changed.
bool is_preparation(const Course& course, std::size_t until) {
  if (until < kMinSamples / 2) return false;
  Drained drained;
  Range cell;
  for (std::size_t i = 0; i < until; ++i) {
    drained.add(course, i);
    cell.add(course.cell[i]);
  }
  return cell.beyond(kNoises * course.cell_noise) > kDeviatorLoad_pa ||
         std::max(drained.flow(course), drained.driven(course)) > course.min_flow;
}

/// Where the cell pressure, which increases in a stretch, is within noise of its largest value;
/// the first sample if it does not increase.
std::size_t end_of_ramp(const Course& course, const Stretch& stretch) {
  const auto at = [&](std::size_t i) {
    return course.cell.begin() + static_cast<std::ptrdiff_t>(i);
  };
  const auto begin = at(stretch.from), end = at(stretch.until);
  const double noise = kNoises * course.cell_noise;
  const double largest = *std::max_element(begin, end);
  if (!(largest - *begin > std::max(kDeviatorLoad_pa, noise))) return stretch.from;
  const auto reached =
      std::find_if(begin, end, [&](double cell) { return cell >= largest - noise; });
  const std::size_t ramp = stretch.from + static_cast<std::size_t>(reached - begin);
  // Strength that was lost before that was lost in shear: a test of several stages.
  double max_q = 0;
  for (std::size_t i = stretch.from; i <= ramp; ++i)
    max_q = std::max(max_q, std::fabs(course.q[i]));
  const bool lost = std::fabs(course.q[ramp]) <
                    (1 - assessment_limits::kLossOfStrength) * max_q - kNoises * course.q_noise;
  return lost ? stretch.from : ramp;
}

/// By how much the cell pressure or, through an open valve, the back pressure changes from `from`
/// on as long as `lasts`.
template <class Lasts>
double change_of_confinement(const Course& course, const Stretch& stretch, std::size_t from,
                             const Lasts& lasts) {
  Range cell, back;
  for (std::size_t i = from; i < stretch.until && lasts(i); ++i) {
    cell.add(course.cell[i]);
    if (stretch.drainage == Drainage::open) back.add(course.back[i]);
  }
  return std::max(cell.beyond(kNoises * course.cell_noise),
                  back.beyond(kNoises * course.back_noise));
}

/// The first sample from which q is constant while the cell pressure or the back pressure changes
/// p′, and which q never exceeds after that; the end of the stretch if there is none.
std::size_t start_of_constant_q(const Course& course, const Stretch& stretch) {
  std::vector<double> largest(stretch.until - stretch.from + 1, 0);  // |q| from there on
  for (std::size_t i = stretch.until; i-- > stretch.from;)
    largest[i - stretch.from] = std::max(largest[i - stretch.from + 1], std::fabs(course.q[i]));
  const double min_held = kMinHeld * largest.front();
  for (std::size_t from = stretch.from; from < stretch.until; ++from) {
    const double q = course.q[from], size = std::fabs(q);
    const double held = std::max(kHeld * size, kNoises * course.q_noise);
    if (!is_loaded(course, from) || size < min_held || largest[from - stretch.from] > size + held)
      continue;
    const double held_change = change_of_confinement(
        course, stretch, from, [&](std::size_t at) { return std::fabs(course.q[at] - q) <= held; });
    const double change =
        change_of_confinement(course, stretch, from, [](std::size_t) { return true; });
    if (held_change > kConfinement * course.p_eff[stretch.from] &&
        held_change > kMinHeldShare * change)
      return from;
  }
  return stretch.until;
}

}  // namespace

void StageSplit::add(const Row& row) {
  const auto take = [&](double& kept, Quantity q) {
    if (const double value = row.si[index(q)]; !std::isnan(value)) kept = value;
  };
  take(last_.force, Quantity::axial_force);
  take(last_.cell, Quantity::cell_pressure);
  take(last_.pore, Quantity::pore_pressure);
  take(last_.back, Quantity::back_pressure);
  take(last_.volume, Quantity::back_volume);
  last_.line = row.line;
  if (rows_++ % stride_ != 0) return;
  samples_.push_back(last_);
  if (samples_.size() < kSamples) return;
  for (std::size_t i = 0; 2 * i < samples_.size(); ++i) samples_[i] = samples_[2 * i];
  samples_.resize((samples_.size() + 1) / 2);
  stride_ *= 2;
}

std::vector<StageSplit::Stage> StageSplit::stages(const SpecimenInfo& specimen) const {
  std::vector<Stage> one{
      {.line = samples_.empty() ? 0 : samples_.front().line, .role = StageRole::shear}};
  if (samples_.size() < kMinSamples || !specimen.height_m || !specimen.diameter_m) return one;
  const double area = std::numbers::pi / 4 * *specimen.diameter_m * *specimen.diameter_m;
  const double volume = area * *specimen.height_m;
  Course course;
  for (const Sample& s : samples_) {
    const double pore = std::isnan(s.pore) ? s.back : s.pore;
    course.q.push_back(s.force / area);
    course.cell.push_back(s.cell);
    course.back.push_back(s.back);
    course.p_eff.push_back(s.cell - pore + s.force / area / 3);
    course.volume.push_back(s.volume / volume);
    course.excess.push_back(std::isnan(s.back) ? pore : pore - s.back);
  }
  std::vector<double> first(course.q.begin(), course.q.begin() + kFirst);
  std::erase_if(first, [](double q) { return std::isnan(q); });
  course.unloaded_q = median(std::move(first));
  course.has_volume = !std::isnan(samples_.back().volume);
  course.q_noise = noise_of(course.q);
  course.cell_noise = noise_of(course.cell);
  course.back_noise = noise_of(course.back);
  course.volume_noise = noise_of(course.volume);
  course.excess_noise = noise_of(course.excess);
  course.min_flow = std::max(kMinFlow, kNoises * course.volume_noise);
  course.volume = without_spikes(course.volume);
  course.excess = without_spikes(course.excess);

  std::vector<Stage> found;
  const auto loaded = start_of_load(course);
  if (!loaded) return one;
  const std::size_t start = is_preparation(course, *loaded) ? *loaded : 0;
  if (start > 0)
    for (const Stretch& s : joined_stretches(stretches(course, 0, start), course)) {
      const bool is_open = s.drainage == Drainage::open;
      found.push_back({samples_[s.from].line,
                       is_open ? StageRole::consolidation : StageRole::unknown, s.drainage});
      // A B check that is taken back is two stages.
      const std::size_t top = end_of_ramp(course, s);
      if (!is_open && top > s.from && top + kMinStretch < s.until)
        found.push_back({samples_[top].line, StageRole::unknown, s.drainage});
    }
  const auto is_loaded_before = [&](std::size_t end) {
    for (std::size_t i = start; i < end; ++i)
      if (is_loaded(course, i)) return true;
    return false;
  };
  for (const Stretch& s : joined_stretches(stretches(course, start, course.q.size()), course)) {
    const std::size_t ramp = s.drainage == Drainage::open ? end_of_ramp(course, s) : s.from;
    const Stretch rest{ramp, s.until, s.drainage};
    if (ramp > s.from) {
      // A B check before that, under no load, is no shear.
      for (Stage& before : found)
        if (before.role == StageRole::shear && !is_loaded_before(s.from))
          before.role = StageRole::unknown;
      found.push_back({samples_[s.from].line, StageRole::consolidation, s.drainage});
      // What rests under its load until the valve is shut belongs to consolidation.
      Range q;
      for (std::size_t i = ramp; i < s.until; ++i) q.add(course.q[i]);
      if (s.until < course.q.size() && q.beyond(kNoises * course.q_noise) < course.worth(ramp))
        continue;
    }
    const std::size_t held = start_of_constant_q(course, rest);
    if (held > ramp) found.push_back({samples_[ramp].line, StageRole::shear, s.drainage});
    if (held < s.until)
      found.push_back(
          {samples_[held].line, StageRole::shear, s.drainage, AxialControl::constant_q});
  }
  return found;
}

}  // namespace triax::lab
