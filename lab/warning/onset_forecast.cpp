// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/warning/onset_forecast.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace triax::lab {
namespace {

constexpr std::size_t kLeast = 8;                  ///< means in a fit
constexpr double kLongest = 0.5, kShortest = 0.1;  ///< distance that rules the window, of η
constexpr double kReach = 2.5, kReachShut = 5;
constexpr double kBehind = 0.3;  ///< of the distance, over which normalised work is continued

constexpr double kDown = 0.02;  ///< of the largest y, by which it has come down
constexpr double kApart = 2;    ///< of the way ahead, between two witnesses that are believed both
constexpr double kModel = 0.27, kModelOpen = 0.25, kModelShut = 0.3;  ///< errors, of the distance
constexpr double kCovered = 0.02;  ///< of the η forecast: what has to be seen of it in the stage
constexpr int kLooksInAll = 64, kLooksNear = 256;  ///< a look each so many-th part of the readings
constexpr double kLooksFrom = 0.2;  ///< share of η left, from which it is the latter

using Columns = Eigen::Matrix<double, 4, 1>;

/// y, and beside it p′ along a strain path and ε₁ at held q, fitted to the driven path near `now`.
struct Fit {
  double now = 0, distance = 0;
  Columns y = Columns::Zero(), beside = Columns::Zero();  ///< constant, f₀, f₁, f₂
  Eigen::Matrix4d variance = Eigen::Matrix4d::Zero();

  static double at(const Columns& c, double xi) { return c[1] + xi * (c[2] + xi * c[3]); }
  /// The root of dy/dx nearest to now at which it falls.
  std::optional<double> root() const;
  std::optional<double> root_of_slope() const;
  double normalised_work(double xi) const;
  double work_along_path(double ratio, double sign) const;
  std::optional<double> root_of_work() const;
  double error(double xi) const;
};

std::optional<double> Fit::root() const {
  const double a = y[3], b = y[2], c = y[1];
  std::optional<double> best;
  const auto take = [&](double xi) {
    if (!(b + 2 * a * xi < 0) || !(xi > -1)) return;
    if (!best || std::fabs(xi) < std::fabs(*best)) best = xi;
  };
  if (std::fabs(a) * std::fabs(c) < 1e-12 * b * b) {
    take(-c / b);
    return best;
  }
  const double under = b * b - 4 * a * c;
  if (under < 0) return std::nullopt;
  const double s = -0.5 * (b + std::copysign(std::sqrt(under), b));
  take(s / a);
  if (s != 0) take(c / s);
  return best;
}

/// Of −(dy/dp′) √η along a strain path, by its tangent; empty where p′ does not fall or y does.
std::optional<double> Fit::root_of_slope() const {
  if (!(y[1] > 0) || !(beside[1] < 0)) return std::nullopt;
  const double falls = y[2] / y[1] - beside[2] / beside[1] + 0.5 * distance / now;
  return falls < 0 ? std::optional(-1 / falls) : std::nullopt;
}

/// At held q, the drainage open: dp′dε_v/(|dσ′||dε|).
double Fit::normalised_work(double xi) const {
  const double volume = at(y, xi), shear = at(beside, xi) + volume / 3;
  return volume / std::sqrt(volume * volume + 4.5 * shear * shear);
}

/// Now, where dε₁ + 2R dε₃ = 0 is kept: dy dε₁/(|dσ′||dε|), y = σ₁′ − σ₃′/R.
double Fit::work_along_path(double ratio, double sign) const {
  const double radial = (3 * beside[1] - sign * y[1]) / (2 + 1 / ratio);
  const double axial = sign * y[1] + radial / ratio;
  return y[1] / std::sqrt((1 + 0.5 / (ratio * ratio)) * (axial * axial + 2 * radial * radial));
}

/// Of normalised work, which falls along a straight line over p′ = q/η.
std::optional<double> Fit::root_of_work() const {
  const double here = normalised_work(0), behind = normalised_work(-kBehind);
  const double p = 1 / now, p_behind = 1 / (now - kBehind * distance);
  const double slope = (behind - here) / (p_behind - p);
  const double p_there = p - here / slope;
  if (!(slope > 0) || !(p_there > 0)) return std::nullopt;
  return (1 / p_there - now) / distance;
}

double Fit::error(double xi) const {
  const Columns g{0, 1, xi, xi * xi};
  const double slope = y[2] + 2 * y[3] * xi;
  return distance * std::sqrt(std::max(0.0, g.dot(variance * g))) / std::fabs(slope);
}

/// Least squares over the means from `first` on, weighted by their readings.
std::optional<Fit> fit(const std::vector<PathMean>& means, std::size_t first, double now,
                       double distance, int terms) {
  Fit f{.now = now, .distance = distance};
  const auto count = static_cast<Eigen::Index>(means.size() - first);
  if (count < terms + 2) return std::nullopt;
  Eigen::Matrix<double, Eigen::Dynamic, 4, Eigen::ColMajor, 128, 4> a(count, 4);
  Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::ColMajor, 128, 2> b(count, 2);
  const PathMean& from = means[first];
  for (Eigen::Index i = 0; i < count; ++i) {
    const PathMean& m = means[first + static_cast<std::size_t>(i)];
    const double w = std::sqrt(m.readings);
    const double j0 = m.weighted[0] - from.weighted[0], j1 = m.weighted[1] - from.weighted[1],
                 j2 = m.weighted[2] - from.weighted[2];
    a.row(i) << w, w * j0, w * (j1 - now * j0) / distance,
        w * (j2 - now * (2 * j1 - now * j0)) / (distance * distance);
    b.row(i) << w * (m.y - from.y), w * (m.beside - from.beside);
  }
  Columns scale = a.colwise().norm();
  for (int k = 0; k < terms; ++k)
    if (!(scale[k] > 0)) return std::nullopt;
  const auto used = (a.leftCols(terms) * scale.head(terms).cwiseInverse().asDiagonal()).eval();
  const Eigen::LDLT<Eigen::MatrixXd> normal(used.transpose() * used);
  if (!(normal.rcond() > 1e-13)) return std::nullopt;
  const Eigen::MatrixXd solution = normal.solve(used.transpose() * b);
  const double rest = (b.col(0) - used * solution.col(0)).squaredNorm();
  const Eigen::MatrixXd inverse = normal.solve(Eigen::MatrixXd::Identity(terms, terms)) *
                                  (rest / static_cast<double>(count - terms));
  for (int k = 0; k < terms; ++k) {
    f.y[k] = solution(k, 0) / scale[k];
    f.beside[k] = solution(k, 1) / scale[k];
    for (int l = 0; l < terms; ++l) f.variance(k, l) = inverse(k, l) / (scale[k] * scale[l]);
  }
  return f;
}

std::size_t first_within(const std::vector<PathMean>& means, double from) {
  const auto at = std::ranges::find_if(means, [&](const PathMean& m) { return m.eta >= from; });
  const auto first = static_cast<std::size_t>(at - means.begin());
  return std::min(first, means.size() > kLeast ? means.size() - kLeast : 0);
}

struct FitToRoot {
  std::optional<Fit> fit;
  std::optional<double> xi;
};

/// The root, and the window that its distance rules.
FitToRoot fit_to_root(const std::vector<PathMean>& means, DrivenPath::Control control, double now,
                      double distance) {
  FitToRoot r;
  const double reach = control == DrivenPath::Control::held_q_shut ? kReachShut : kReach;
  const int terms = control == DrivenPath::Control::strain_path ? 3 : 4;
  for (int round = 0; round < 4; ++round) {
    distance = std::clamp(distance, kShortest * now, kLongest * now);
    r.fit = fit(means, first_within(means, now - (reach - 1) * distance), now, distance, terms);
    if (!r.fit) return {};
    r.xi = control == DrivenPath::Control::held_q_open ? r.fit->root_of_work() : r.fit->root();
    if (!r.xi) break;
    // Halfway, so that two windows do not call for each other for ever.
    distance = 0.5 * (*r.xi + 1) * r.fit->distance;
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

/// Where the onset will be, and how well that is known.
void foresee(const Fit& f, double xi, DrivenPath::Control control, EtaForecast& made) {
  const bool open = control == DrivenPath::Control::held_q_open;
  double ahead = xi * f.distance, between = 0;
  if (const auto slope = f.root_of_slope(); control == DrivenPath::Control::strain_path && slope &&
                                            std::fabs(*slope - xi) <= kApart * std::max(xi, 0.0)) {
    between = 0.5 * (*slope - xi) * f.distance;
    ahead += between;
  }
  const double model = control == DrivenPath::Control::strain_path ? kModel
                       : open                                      ? kModelOpen
                                                                   : kModelShut;
  const double of_fit =
      open ? 2 * std::fabs(ahead) * std::sqrt(f.variance(1, 1)) / std::fabs(f.y[1]) : f.error(xi);
  made.eta = made.now + ahead;
  made.error = std::hypot(of_fit, between, model * std::max(ahead, 0.0));
}

/// What the path does there: dη/dx, and whether p′ still falls.
void path_at_onset(const Fit& f, double xi, const PathMean& here, EtaForecast& made) {
  const double weight = std::sqrt(here.p);
  made.slope = weight * (f.y[1] - here.eta * f.beside[1]) / here.p;
  made.slope_there = -weight * made.eta * Fit::at(f.beside, xi) / here.p;
  made.fall = f.beside[1] < 0 ? Fit::at(f.beside, xi) / f.beside[1] : 0;
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
  made.error = 0.5 * std::fabs(after.eta - before.eta) / kOf90;
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

void OnsetForecast::start_stage(const StageInfo* stage, bool has_time) {
  *this = OnsetForecast();
  path_.start_stage(stage, has_time);
  if (stage) by_ = stage->control;
}

bool OnsetForecast::add(const State& state) {
  if (path_.control() == DrivenPath::Control::none) return false;
  path_.add(state);
  const std::int64_t readings = path_.readings();
  if (readings == looked_) return false;
  const bool near = forecast_ && forecast_->left() < kLooksFrom;
  const std::int64_t every = readings / (near ? kLooksNear : kLooksInAll);
  if (readings > looked_ && readings - looked_ < every) return false;
  looked_ = readings;
  forecast_ = made();
  return true;
}

std::optional<EtaForecast> OnsetForecast::made() {
  const auto& means = path_.means();
  clear_ = false;
  if (means.size() < kLeast) return std::nullopt;
  const std::size_t count = latest_of(means, path_.readings());
  const PathMean here = latest(means, count);
  const auto [f, xi] = fit_to_root(means, path_.control(), here.eta,
                                   forecast_ ? forecast_->eta - here.eta : here.eta);
  if (!f) return std::nullopt;
  const bool on_path = path_.control() == DrivenPath::Control::strain_path;
  const double weight = on_path ? std::sqrt(here.p) : 1, error = std::sqrt(f->variance(1, 1));
  stiffest_ = std::max(stiffest_, f->y[1] * weight);
  clear_ = f->y[1] > 3 * error;
  EtaForecast made{.now = here.eta};
  if (stiffest_ > 0) {
    made.stiffness = f->y[1] * weight / stiffest_;
    made.stiffness_error = error * weight / stiffest_;
  }
  made.covered = (here.eta - means.front().eta) / here.eta;
  made.by = by_;
  made.q = here.q;
  made.answer = f->y[1] * weight;
  if (on_path) made.work = f->work_along_path(path_.ratio(), path_.in_extension() ? -1 : 1);
  if (path_.control() == DrivenPath::Control::held_q_open) made.work = f->normalised_work(0);
  if (made.work < 1) made.work_error = error * std::fabs(made.work / f->y[1]);
  if (xi) {
    foresee(*f, *xi, path_.control(), made);
    if (on_path) path_at_onset(*f, *xi, here, made);
  } else if (!on_path || !look_back(means, count, made)) {
    return std::nullopt;
  }
  return made.covered * made.now < kCovered * made.eta ? std::nullopt : std::optional(made);
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
