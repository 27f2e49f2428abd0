// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/calibrate/calibration.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lab/base/bad_input.hpp"
#include "src/study/calibrate/global_search.hpp"
#include "src/study/calibrate/left_out.hpp"

namespace triax::study {
namespace {

constexpr int kCoarseKnots = 20;
constexpr DrivingOptions kCoarse{.tolerance = 1e-4, .step_limit = 400};
constexpr DrivingOptions kFine{.tolerance = 1e-7, .step_limit = 4000};
constexpr int kMostIterations = 60;
constexpr std::size_t kDownhill = 2;  // members of a population that go on
constexpr double kApart = 0.1;        // of a range: members that are not the same valley
constexpr double kGlobalShare = 0.6;  // of a search
constexpr double kSearchShare = 0.80, kPredictedShare = 0.90;
constexpr const char *kWhat = "calibrating", *kDomain = "cones and domain";

/// Optima whose cost is no worse than this are told.
double told_below(double best) { return std::max(1.1 * best, best + 0.01); }
/// Costs that count as one.
bool same_cost(double cost, double best) { return cost <= 1.01 * best + 1e-6; }

Optimum optimum_of(const SearchSpace& space, const Unknowns& x, double cost) {
  Optimum o{.values = {}, .cost = cost};
  for (Eigen::Index i = 0; i < x.size(); ++i) o.values.push_back(space.value(i, x(i)));
  return o;
}

Unknowns point_of(const SearchSpace& space, const Optimum& o) {
  Unknowns x(space.size());
  for (Eigen::Index i = 0; i < x.size(); ++i)
    x(i) = std::clamp(space.unknown(i, o.values[static_cast<std::size_t>(i)]), 0.0, 1.0);
  return x;
}

/// The best, and others of a population that are apart from those taken before.
std::vector<Unknowns> apart(const std::vector<Candidate>& population) {
  std::vector<Unknowns> chosen;
  for (const Candidate& member : population) {
    if (chosen.size() == kDownhill) break;
    if (std::ranges::all_of(chosen, [&](const Unknowns& other) {
          return (other - member.x).cwiseAbs().maxCoeff() > kApart;
        }))
      chosen.push_back(member.x);
  }
  return chosen;
}

SearchEnd run_search(const CalibrationRequest& request, const SearchSpace& space,
                     const Misfit& coarse, const Misfit& fine, int number,
                     const std::function<void(double)>& tell, const GoOn& go_on) {
  SearchEnd end{.number = number, .optima = {}};
  const std::int64_t before = coarse.runs() + fine.runs();
  const auto population =
      global_search(coarse, {.seed = request.seed * 1000003U + static_cast<std::uint64_t>(number)},
                    [&](double share) {
                      tell(kGlobalShare * share);
                      return go_on();
                    });
  const auto from = apart(population);
  for (std::size_t k = 0; k < from.size(); ++k) {
    tell(kGlobalShare +
         (1 - kGlobalShare) * static_cast<double>(k) / static_cast<double>(from.size()));
    // Where it was stopped, the best member so far counts, as it stands on the whole paths.
    const bool stopped = !go_on();
    int evaluations = 0;
    const auto found = least_squares(fine, from[k], stopped ? 1 : kMostIterations,
                                     [&] { return evaluations++ == 0 || go_on(); });
    if (std::isfinite(found.sum))
      end.optima.push_back(optimum_of(space, found.x, found.sum / fine.series()));
    if (stopped) break;
  }
  std::ranges::stable_sort(end.optima, {}, &Optimum::cost);
  end.runs = coarse.runs() + fine.runs() - before;
  return end;
}

/// Whether two optima are one: no parameter that the tests determine differs by more than its
/// interval and a twentieth of its range.
bool one_valley(const SearchSpace& space, const Optimum& a, const Optimum& b,
                const std::vector<ParameterEstimate>& parameters) {
  const Unknowns x = point_of(space, a), y = point_of(space, b);
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    const auto& p = parameters[static_cast<std::size_t>(i)];
    const double wide = (space.unknown(i, p.high) - space.unknown(i, p.low)) / 2;
    if (p.determined && std::abs(x(i) - y(i)) > std::max(kApart / 2, wide)) return false;
  }
  return true;
}

/// Those that fit about as well as the best, each valley once.
std::vector<Optimum> distinct(const SearchSpace& space, const std::vector<Optimum>& all,
                              const std::vector<ParameterEstimate>& parameters) {
  std::vector<Optimum> kept;
  for (const Optimum& o : all) {
    if (o.cost > told_below(all.front().cost)) break;
    const auto same = std::ranges::find_if(
        kept, [&](const Optimum& other) { return one_valley(space, o, other, parameters); });
    if (same == kept.end())
      kept.push_back(o);
    else
      ++same->found;
  }
  return kept;
}

std::vector<SeriesMisfit> misfits_of(const std::vector<MeasuredPath>& paths,
                                     const std::vector<ComputedPath>& computed) {
  std::vector<SeriesMisfit> all;
  for (std::size_t t = 0; t < paths.size(); ++t) {
    const Eigen::VectorXd r = residuals(paths[t], computed[t]);
    const auto quantities = compared_in(paths[t].imposed);
    for (std::size_t q = 0; q < 2; ++q) {
      const auto half = r.size() / 2;
      const double cost = r.segment(static_cast<Eigen::Index>(q) * half, half).squaredNorm();
      all.push_back({.test = paths[t].name,
                     .quantity = quantities[q],
                     .rms = std::sqrt(cost) * paths[t].scale[q],
                     .noise = paths[t].noise[q],
                     .cost = cost,
                     .reached = computed[t].reached / static_cast<double>(paths[t].knots.size()),
                     .refusal = computed[t].refusal});
    }
  }
  return all;
}

std::vector<ComputedPath> computed_at(const Misfit& misfit, const Unknowns& x) {
  std::vector<ComputedPath> computed(misfit.paths().size());
  misfit.each(computed.size(), [&](std::size_t t) {
    const MeasuredPath& path = misfit.paths()[t];
    const auto material = misfit.space().material(x, path.imposed);
    if (material) computed[t] = drive(*material->axisymmetric, path, kFine);
  });
  return computed;
}

/// Of the set itself; empty where one of its values is outside its range.
std::optional<double> cost_of_start(const Misfit& misfit, const CalibrationRequest& request) {
  Unknowns x(misfit.space().size());
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    const auto& key = request.free[static_cast<std::size_t>(i)].key;
    x(i) = misfit.space().unknown(i, value_of(request.start, key).value_or(0));
  }
  if (!x.allFinite() || !misfit.space().possible(x)) return std::nullopt;
  return misfit.residuals_of({x}).squaredNorm() / misfit.series();
}

lab::MaterialSet calibrated(const CalibrationRequest& request, const SearchSpace& space,
                            const Unknowns& x) {
  lab::MaterialSet set = request.start;
  set.parameters = space.parameters(x);
  set.name = fmt::format("{}/calibrated", set.law->name);
  set.material = space.material(x, Imposed::undrained).value_or(sim::Material{});
  double e_low = 1e9, e_high = 0, p_low = 1e18, p_high = 0;
  for (const MeasuredPath& path : request.paths) {
    e_low = std::min(e_low, path.void_ratio), e_high = std::max(e_high, path.void_ratio);
    for (const PathKnot& knot : path.knots)
      p_low = std::min(p_low, knot.p_eff), p_high = std::max(p_high, knot.p_eff);
  }
  set.void_ratio_range = {e_low, std::max(e_high, e_low * (1 + 1e-9))};
  set.p_eff_range_kPa = {p_low / 1e3, p_high / 1e3};
  return set;
}

}  // namespace

MeasuredPath thinned(const MeasuredPath& path, int knots) {
  const std::size_t count = path.knots.size();
  const auto most = static_cast<std::size_t>(knots);
  if (count <= most) return path;
  MeasuredPath thin = path;
  thin.knots.clear();
  double waiting = 0;
  for (std::size_t k = 0; k < count; ++k) {
    waiting += path.knots[k].weight;
    if ((k + 1) * most / count == k * most / count) continue;
    thin.knots.push_back(path.knots[k]);
    thin.knots.back().weight = waiting;
    waiting = 0;
  }
  return thin;
}

std::vector<SearchEnd> run_searches(const CalibrationRequest& request, int first, int step,
                                    const Progress& progress, const GoOn& go_on) {
  const SearchSpace space(request.start, request.free);
  std::vector<MeasuredPath> thin;
  for (const MeasuredPath& path : request.paths) thin.push_back(thinned(path, kCoarseKnots));
  const Misfit coarse(space, thin, request.threads, kCoarse);
  const Misfit fine(space, request.paths, request.threads, kFine);
  std::vector<int> numbers;
  for (int k = first; k <= request.searches; k += step) numbers.push_back(k);
  std::vector<SearchEnd> ends;
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    if (k > 0 && !go_on()) break;
    const auto tell = [&](double share) {
      show(progress, kWhat,
           kSearchShare * (static_cast<double>(k) + share) / static_cast<double>(numbers.size()));
    };
    ends.push_back(run_search(request, space, coarse, fine, numbers[k], tell, go_on));
  }
  return ends;
}

Calibration conclude(const CalibrationRequest& request, const std::vector<SearchEnd>& ends,
                     const Progress& progress, const GoOn& go_on) {
  const SearchSpace space(request.start, request.free);
  const Misfit fine(space, request.paths, request.threads, kFine);
  std::vector<Optimum> all;
  for (const SearchEnd& end : ends) all.insert(all.end(), end.optima.begin(), end.optima.end());
  if (all.empty()) throw lab::WorkFailed("stopped before a result was found");
  std::ranges::stable_sort(all, {}, &Optimum::cost);
  const Unknowns x = space.possible_near(point_of(space, all.front()));

  show(progress, kWhat, kSearchShare);
  const Uncertainty sure = uncertainty_at(fine, x, {.void_ratio_error = request.void_ratio_error});
  Calibration c{.start = request.start,
                .material = calibrated(request, space, x),
                .parameters = sure.parameters,
                .correlation = sure.correlation,
                .degrees_of_freedom = sure.degrees_of_freedom,
                .cost = all.front().cost,
                .start_cost = cost_of_start(fine, request),
                .optima = distinct(space, all, sure.parameters),
                .searches = static_cast<int>(ends.size()),
                .measured = request.paths,
                .computed = computed_at(fine, x)};
  for (const SearchEnd& end : ends)
    c.ended_at_best += !end.optima.empty() && same_cost(end.optima.front().cost, c.cost);
  c.misfits = misfits_of(c.measured, c.computed);
  if (request.left_out && go_on())
    c.predictions = predict_left_out(fine, x, request.void_ratio_error, [&](double share) {
      show(progress, kWhat, std::lerp(kSearchShare, kPredictedShare, share));
      return go_on();
    });
  if (request.domain && go_on())
    c.domain = implied_domain(fine, x, sure, {.seed = request.seed}, [&](double share) {
      show(progress, kDomain, std::lerp(kPredictedShare, 1, share));
      return go_on();
    });
  c.interrupted = !go_on();
  c.runs = fine.runs();
  c.notes = request.notes;
  for (const SearchEnd& end : ends) c.runs += end.runs;
  return c;
}

Calibration calibrate(const CalibrationRequest& request, const Progress& progress,
                      const GoOn& go_on) {
  return conclude(request, run_searches(request, 1, 1, progress, go_on), progress, go_on);
}

}  // namespace triax::study
