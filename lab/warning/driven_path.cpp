// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/warning/driven_path.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lab/measured/path_sampler.hpp"

namespace triax::lab {
namespace {

constexpr double kBelow = 0.05;      ///< of the largest η, and in η itself
constexpr int kLoop = 8;             ///< readings below it in a row: no outliers
constexpr std::size_t kLatest = 24;  ///< means that stay single readings

PathMean mean_of(const PathMean& a, const PathMean& b) {
  const double wa = a.readings / (a.readings + b.readings), wb = 1 - wa;
  PathMean m{.readings = a.readings + b.readings,
             .progress = wa * a.progress + wb * b.progress,
             .eta = wa * a.eta + wb * b.eta,
             .p = wa * a.p + wb * b.p,
             .q = wa * a.q + wb * b.q,
             .x = wa * a.x + wb * b.x,
             .y = wa * a.y + wb * b.y,
             .beside = wa * a.beside + wb * b.beside};
  for (std::size_t k = 0; k < m.weighted.size(); ++k)
    m.weighted[k] = wa * a.weighted[k] + wb * b.weighted[k];
  return m;
}

double ratio_of(const StageInfo* stage) { return stage ? stage->strain_path_R.value_or(1) : 1; }

}  // namespace

DrivenPath::Control DrivenPath::control_of(const StageInfo* stage) {
  if (!stage) return Control::strain_path;
  if (stage->control == AxialControl::constant_q)
    return stage->drainage == Drainage::closed ? Control::held_q_shut : Control::held_q_open;
  if (is_drained_frame(stage) && !stage->strain_path_R) return Control::none;
  return Control::strain_path;
}

bool DrivenPath::is_alike(const StageInfo* stage) const {
  return is_watched(stage) && control_of(stage) == control_ && ratio_of(stage) == ratio_;
}

void DrivenPath::start_stage(const StageInfo* stage, bool has_time, const SpecimenVolume& volume) {
  DrivenPath next;
  if (is_alike(stage)) {  // a loop may be a stage of its own
    next.in_extension_ = in_extension_;
    next.highest_ = highest_;
  }
  *this = std::move(next);
  volume_ = volume;
  control_ = control_of(stage);
  has_time_ = has_time;
  ratio_ = ratio_of(stage);
}

/// The reading by itself; integrals are not in it.
PathMean DrivenPath::sample(const State& s) const {
  const double sign = in_extension_ ? -1 : 1;
  PathMean m{.readings = 1,
             .progress = has_time_ ? s.time_s : sign * s.strain.axial,
             .eta = sign * s.eta(),
             .p = s.p_eff,
             .q = sign * s.q};
  m.x = control_ == Control::strain_path ? sign * s.strain.axial : -s.p_eff;
  m.beside = control_ == Control::strain_path ? s.p_eff : sign * s.strain.axial;
  if (control_ == Control::strain_path)
    m.y = sign * (s.p_eff + 2 * s.q / 3 - (s.p_eff - s.q / 3) / ratio_);
  else
    m.y = control_ == Control::held_q_shut ? -s.pore_pressure : -s.volumetric_strain;
  return m;
}

void DrivenPath::add(const State& state) {
  if (control_ == Control::none || !(state.p_eff > 0)) return;
  if (const bool extension = state.q < 0; extension != in_extension_) {
    means_.clear();
    before_.reset();
    below_ = 0;
    highest_ = gone_y_ = gone_beside_ = 0;
    readings_ = 0;
    in_extension_ = extension;
  }
  PathMean now = sample(state);
  if (!std::isfinite(now.y)) return;
  if (now.eta < highest_ - kBelow * std::max(1.0, highest_)) {
    if (++below_ == kLoop) leave_out();
    return;
  }
  if (in_loop() && now.eta < highest_) return;
  now.y += gone_y_;
  now.beside += gone_beside_;
  if (in_loop() && before_) {
    gone_y_ += before_->y - now.y;
    gone_beside_ += before_->beside - now.beside;
    now.y = before_->y;
    now.beside = before_->beside;
  }
  if (before_) {
    // What moved while the path was left out is none of its own.
    const double dx = below_ > 0 ? 0 : now.x - before_->x;
    const auto weight = [&](const PathMean& m) {
      return control_ == Control::strain_path ? std::sqrt(m.p) : 1.0;
    };
    double then = weight(*before_), here = weight(now);
    for (std::size_t k = 0; k < now.weighted.size(); ++k) {
      now.weighted[k] = before_->weighted[k] + 0.5 * (then + here) * dx;
      then *= before_->eta;
      here *= now.eta;
    }
    highest_ = std::max(highest_, std::min(now.eta, before_->eta));
  }
  below_ = 0;
  before_ = now;
  ++readings_;
  if (volume_.compliance() && std::isfinite(state.pore_pressure))
    compliance_ = volume_.compliance()->at(state.pore_pressure);
  if (means_.size() == kMost) merge();
  means_.push_back(now);
}

bool DrivenPath::in_loop() const { return below_ >= kLoop; }

/// A loop begins. The way down from the largest η belongs to it.
void DrivenPath::leave_out() {
  if (means_.empty()) return;
  const auto top = std::ranges::max_element(means_, {}, &PathMean::eta);
  means_.erase(top + 1, means_.end());
  before_ = *top;
}

/// Joins about half of the pairs, those that lie closest together in η, and none of the latest.
void DrivenPath::merge() {
  const std::size_t older = means_.size() - kLatest;
  std::vector<double> spans;
  for (std::size_t i = 0; i + 1 < older; i += 2)
    spans.push_back(std::fabs(means_[i + 1].eta - means_[i].eta));
  const auto middle = spans.begin() + static_cast<std::ptrdiff_t>(spans.size() / 2);
  std::vector<double> sorted = spans;
  std::nth_element(sorted.begin(), sorted.begin() + (middle - spans.begin()), sorted.end());
  const double most = sorted[spans.size() / 2];
  std::size_t kept = 0;
  for (std::size_t i = 0; i < means_.size();) {
    const bool pair = i + 1 < older && std::fabs(means_[i + 1].eta - means_[i].eta) <= most;
    means_[kept++] = pair ? mean_of(means_[i], means_[i + 1]) : means_[i];
    i += pair ? 2 : 1;
  }
  means_.resize(kept);
}

}  // namespace triax::lab
