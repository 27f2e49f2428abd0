// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/warning/onset_forecast.hpp"

#include <algorithm>
#include <cmath>

#include "lab/warning/driven_fit.hpp"
#include "lab/warning/warning_limits.hpp"

namespace triax::lab {
namespace {

constexpr std::size_t kLeast = 8;                  ///< means in a fit
constexpr double kLongest = 0.5, kShortest = 0.1;  ///< distance that rules the window, of η
constexpr double kReach = 2.5, kReachShut = 5;
constexpr double kDown = 0.02;  ///< of the largest y, by which it has come down
constexpr double kApart = 2;    ///< of the way ahead, between two witnesses that are believed both
/// Standard deviation of ln(distance/forecast distance): laws bend, mostly so that the onset is
/// forecast too early.
constexpr double kModel = 0.7;
/// Span of η, as a fraction of η now, over which a path must have been seen: what is missing of it
/// counts as distance, since the start of a stage bends more sharply than what follows.
constexpr double kSpan = 0.2;
constexpr double kPast = 2;         ///< standard errors past which earlier tests are not used
constexpr int kLooksInAll = 64;     ///< a look each so many-th part of the readings
constexpr int kLooksNear = 1024;    ///< near the onset: every reading of a shorter stage
constexpr double kLooksFrom = 0.2;  ///< fraction of η left, from which it is near

std::size_t first_within(const std::vector<PathMean>& means, double from) {
  const auto at = std::ranges::find_if(means, [&](const PathMean& m) { return m.eta >= from; });
  const auto first = static_cast<std::size_t>(at - means.begin());
  return std::min(first, means.size() > kLeast ? means.size() - kLeast : 0);
}

struct FitToRoot {
  std::optional<DrivenFit> fit;
  std::optional<double> xi;
};

/// The root, and the window that its distance rules.
FitToRoot fit_to_root(const DrivenPath& path, double now, double distance, double weight) {
  FitToRoot r;
  const auto& means = path.means();
  const DrivenPath::Control control = path.control();
  const double reach = control == DrivenPath::Control::held_q_shut ? kReachShut : kReach;
  const int terms = control == DrivenPath::Control::strain_path ? 3 : 4;
  bool was_longer = false;
  distance = std::clamp(distance, kShortest * now, kLongest * now);
  for (int round = 0; round < 4; ++round) {
    r.fit =
        fit_driven(means, first_within(means, now - (reach - 1) * distance), now, distance, terms);
    if (!r.fit) return {};
    if (control == DrivenPath::Control::strain_path)
      r.fit->give_way(path.compliance() * weight, path.ratio(), path.in_extension() ? -1 : 1);
    r.xi = control == DrivenPath::Control::held_q_open ? r.fit->root_of_work() : r.fit->root();
    if (!r.xi) break;
    // Halfway. Where two windows call for each other the shorter one is believed: the other bends
    // over it.
    const double next = std::clamp(0.5 * (*r.xi + 1) * distance, kShortest * now, kLongest * now);
    if (next >= distance && was_longer) break;
    was_longer = next < distance;
    distance = next;
  }
  return r;
}

/// How many of the latest are taken together: single readings scatter.
std::size_t latest_of(const std::vector<PathMean>& means, std::int64_t readings) {
  return std::min(static_cast<std::size_t>(std::clamp<std::int64_t>(readings / 100, 3, 16)),
                  means.size());
}

PathMean latest(const std::vector<PathMean>& means, std::size_t count) {
  PathMean sum{};
  for (std::size_t i = means.size() - count; i < means.size(); ++i) {
    sum.eta += means[i].eta / static_cast<double>(count);
    sum.p += means[i].p / static_cast<double>(count);
    sum.q += means[i].q / static_cast<double>(count);
  }
  return sum;
}

/// Where the onset will be, and how well that is known. What lies ahead is known up to a factor
/// (kModel). A root behind the present state contradicts that the specimen is controlled: the
/// interval of 90 % reaches to the present state.
void set_forecast(const DrivenFit& f, double xi, DrivenPath::Control control, EtaForecast& made) {
  const bool open = control == DrivenPath::Control::held_q_open;
  double ahead = xi * f.distance, between = 0;
  if (const auto slope = f.root_of_slope(); control == DrivenPath::Control::strain_path && slope &&
                                            std::fabs(*slope - xi) <= kApart * std::max(xi, 0.0)) {
    between = 0.5 * (*slope - xi) * f.distance;
    ahead += between;
  }
  const double of_fit =
      open ? 2 * std::fabs(ahead) * std::sqrt(f.variance(1, 1)) / std::fabs(f.y[1]) : f.error(xi);
  const double factor = std::exp(kOf90 * kModel);
  const double below = ahead > 0 ? ahead * (1 - 1 / factor) : -ahead;
  const double unseen = std::max(kSpan - made.covered, 0.0) * made.now;
  const double above = std::max(-ahead, std::max(ahead, unseen) * (factor - 1));
  made.eta = made.now + ahead;
  made.error = std::hypot(of_fit, between, below / kOf90);
  made.error_above = std::hypot(of_fit, between, above / kOf90);
}

/// What the path does there: dη/dx, and whether p′ still falls.
void path_at_onset(const DrivenFit& f, double xi, const PathMean& here, EtaForecast& made) {
  const double weight = std::sqrt(here.p);
  made.slope = weight * (f.y[1] - here.eta * f.beside[1]) / here.p;
  made.slope_there = -weight * made.eta * DrivenFit::at(f.beside, xi) / here.p;
  made.fall = f.beside[1] < 0 ? DrivenFit::at(f.beside, xi) / f.beside[1] : 0;
}

/// The forecast of the test itself and what earlier tests know, by their precisions. Where they
/// differ by more than their errors the error grows with it.
void weigh(const EarlierTests::Onset& known, EtaForecast& made) {
  const double own = 1 / (made.error * made.error), theirs = 1 / (known.error * known.error);
  const double apart = (made.eta - known.eta) / std::hypot(made.error, known.error);
  made.eta = (own * made.eta + theirs * known.eta) / (own + theirs);
  made.error = made.error_above = std::max(1.0, std::fabs(apart)) / std::sqrt(own + theirs);
  made.by_earlier = true;
}

/// What single readings scatter by: from how far each of the latest lies off the middle of its
/// neighbours.
double scatter(const std::vector<PathMean>& means) {
  std::vector<double> off;
  for (std::size_t i = means.size() - kLeast + 1; i + 1 < means.size(); ++i)
    off.push_back(std::fabs(means[i].y - 0.5 * (means[i - 1].y + means[i + 1].y)));
  std::ranges::nth_element(off, off.begin() + static_cast<std::ptrdiff_t>(off.size() / 2));
  return off[off.size() / 2] / 0.826;  // of 1.22 σ, its median
}

/// Whether y has come down, beyond scatter: then the onset was where it was largest, between its
/// neighbours.
bool look_back(const std::vector<PathMean>& means, std::size_t latest, EtaForecast& made) {
  const auto most = std::ranges::max_element(means, {}, &PathMean::y);
  const auto now = std::ranges::max_element(means.end() - static_cast<std::ptrdiff_t>(latest),
                                            means.end(), {}, &PathMean::y);
  if (most->y - now->y < kDown * most->y + 5 * scatter(means)) return false;
  const auto& before = most == means.begin() ? *most : *(most - 1);
  const auto& after = most + 1 == means.end() ? *most : *(most + 1);
  made.eta = most->eta;
  made.error = made.error_above = 0.5 * std::fabs(after.eta - before.eta) / kOf90;
  return true;
}

}  // namespace

double EtaForecast::way_to(double at) const {
  const double ahead = std::max(at - now, 0.0);
  if (by == AxialControl::constant_q) return q / now - q / (now + ahead);
  if (!(slope > 0)) return ahead > 0 ? std::numeric_limits<double>::infinity() : 0;
  // dy/dη falls linearly to zero at the onset; dη/dx goes from the one slope to the other.
  const double share = eta > now ? std::min(ahead / (eta - now), 1.0) : 1.0;
  if (by == AxialControl::load) return answer / slope * ahead * (1 - 0.5 * share);
  return ahead / (slope + 0.5 * share * (slope_there - slope));
}

void OnsetForecast::start_stage(const StageInfo* stage, bool has_time,
                                const SpecimenVolume& volume) {
  if (!path_.goes_on_in(stage)) {
    DrivenPath path = std::move(path_);
    forget();
    path_ = std::move(path);
    path_.start_stage(stage, has_time, volume);
  }
  if (stage) by_ = stage->control;
}

void OnsetForecast::forget() { *this = OnsetForecast(std::move(earlier_)); }

bool OnsetForecast::add(const State& state) {
  if (path_.control() == DrivenPath::Control::none) return false;
  path_.add(state);
  const std::int64_t readings = path_.readings();
  if (readings == looked_) return false;
  const bool near = forecast_ && forecast_->left() < kLooksFrom;
  const std::int64_t every = readings / (near ? kLooksNear : kLooksInAll);
  if (readings > looked_ && readings - looked_ < every) return false;
  // Means of readings are independent if half of the readings differ.
  const std::size_t half = std::max<std::size_t>(latest_of(path_.means(), readings) / 2, 1);
  new_evidence_ =
      std::clamp(static_cast<double>(readings - looked_) / static_cast<double>(half), 0.0, 1.0);
  looked_ = readings;
  forecast_ = made();
  return true;
}

/// What earlier tests say of the onset, as long as the path has not gone past it.
std::optional<EarlierTests::Onset> OnsetForecast::known(double now) const {
  const auto known =
      earlier_.onset(path_.control(), path_.in_extension(), path_.volume().give().value_or(0));
  return known && now <= known->eta + kPast * known->error ? known : std::nullopt;
}

/// Before the test shows anything itself.
std::optional<EtaForecast> OnsetForecast::known_alone(const PathMean& here) const {
  const auto before = known(here.eta);
  if (!before) return std::nullopt;
  return EtaForecast{.eta = before->eta,
                     .error = before->error,
                     .error_above = before->error,
                     .now = here.eta,
                     .by = by_,
                     .q = here.q,
                     .by_earlier = true};
}

/// How stiff the specimen is here and what second-order work it does, without where that leads.
EtaForecast OnsetForecast::described(const DrivenFit& f, const PathMean& here, double weight) {
  const double error = std::sqrt(f.variance(1, 1));
  stiffest_ = std::max(stiffest_, f.y[1] * weight);
  clear_ = f.y[1] > 3 * error;
  EtaForecast made{.now = here.eta};
  if (stiffest_ > 0) {
    made.stiffness = f.y[1] * weight / stiffest_;
    made.stiffness_error = error * weight / stiffest_;
  }
  made.covered = (here.eta - path_.means().front().eta) / here.eta;
  made.by = by_;
  made.q = here.q;
  made.answer = f.y[1] * weight;
  if (path_.control() == DrivenPath::Control::strain_path)
    made.work = f.work_along_path(path_.ratio(), path_.in_extension() ? -1 : 1);
  if (path_.control() == DrivenPath::Control::held_q_open) made.work = f.normalised_work(0);
  if (made.work < 1) made.work_error = error * std::fabs(made.work / f.y[1]);
  return made;
}

std::optional<EtaForecast> OnsetForecast::made() {
  const auto& means = path_.means();
  clear_ = false;
  if (means.empty()) return std::nullopt;
  if (means.size() < kLeast) return known_alone(means.back());
  const std::size_t count = latest_of(means, path_.readings());
  const PathMean here = latest(means, count);
  const bool on_path = path_.control() == DrivenPath::Control::strain_path;
  const double weight = on_path ? std::sqrt(here.p) : 1;
  const auto [f, xi] =
      fit_to_root(path_, here.eta, forecast_ ? forecast_->eta - here.eta : here.eta, weight);
  if (!f) return std::nullopt;
  EtaForecast made = described(*f, here, weight);
  const auto before = known(here.eta);
  if (xi) {
    set_forecast(*f, *xi, path_.control(), made);
    if (before && *xi > 0) weigh(*before, made);
    if (on_path)
      path_at_onset(*f, made.by_earlier ? (made.eta - here.eta) / f->distance : *xi, here, made);
  } else if (!on_path || !look_back(means, count, made)) {
    if (!before) return std::nullopt;
    made.eta = before->eta;
    made.error = made.error_above = before->error;
    made.by_earlier = true;
    if (on_path) path_at_onset(*f, (made.eta - here.eta) / f->distance, here, made);
  }
  if (made.by_earlier) return made;
  return made.covered * made.now < warning_limits::kCovered * made.eta ? std::nullopt
                                                                       : std::optional(made);
}

std::optional<double> OnsetForecast::rate() const {
  const auto& means = path_.means();
  if (means.size() < 3) return std::nullopt;
  const auto driver = [&](const PathMean& m) {
    if (by_ == AxialControl::load) return m.y;
    return m.x;
  };
  const PathMean &last = means.back(),
                 &before = means[means.size() - std::min<std::size_t>(means.size(), 24)];
  const double rate = (driver(last) - driver(before)) / (last.progress - before.progress);
  return rate > 0 ? std::optional(rate) : std::nullopt;
}

}  // namespace triax::lab
