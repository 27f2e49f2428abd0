// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/soil/soil_fits.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace triax::study {
namespace {

void name_odd(Soil& soil, const OddTest& odd, std::size_t test, const FitWords& words, bool kept) {
  auto& of = soil.tests[test];
  const std::string why =
      fmt::format("{} lies {:.3g} {} what the others give for {} ({:.1f} standard deviations)",
                  words.value, std::abs(odd.residual), odd.residual > 0 ? "above" : "below",
                  words.what, std::abs(odd.deviations));
  of.reason += (of.reason.empty() ? "" : "; ") + why;
  soil.notes.push_back(fmt::format("{}: {}; it is {}", of.name, why,
                                   kept ? "kept in the fit" : "left out of that fit"));
}

}  // namespace

Gathered without_odd(Soil& soil, const SoilOptions& options, const Gathered& all, FitKind kind,
                     const FitWords& words, Gathered* odd) {
  Gathered left = all;
  for (const auto& one : odd_tests(all.points, kind, words.usual)) {
    const std::size_t test = all.tests[one.index];
    name_odd(soil, one, test, words, options.keep_odd);
    if (options.keep_odd) continue;
    if (odd != nullptr) odd->add(all.points[one.index], test);
    const auto at = std::ranges::find(left.tests, test) - left.tests.begin();
    left.tests.erase(left.tests.begin() + at);
    left.points.erase(left.points.begin() + at);
  }
  return left;
}

std::optional<Trend> trend_of(Soil& soil, const SoilOptions& options, const Gathered& all,
                              const FitWords& words, bool say_missing) {
  Gathered odd;
  const Gathered left = without_odd(soil, options, all, FitKind::line, words, &odd);
  if (const auto line = fit_line(left.points))
    return Trend{*line, left.points, left.tests, odd.points, odd.tests};
  if (say_missing)
    soil.notes.push_back(
        left.points.size() < 3
            ? fmt::format("{} needs three tests and has {}", words.what, left.points.size())
            : fmt::format("{} needs tests that differ: all {} lie at one place", words.what,
                          left.points.size()));
  return std::nullopt;
}

std::optional<Level> level_of(Soil& soil, const SoilOptions& options, const Gathered& all,
                              const FitWords& words) {
  const Gathered left = without_odd(soil, options, all, FitKind::mean, words);
  if (const auto fit = fit_mean(left.points)) return Level{*fit, left.tests};
  if (!left.points.empty())
    soil.notes.push_back(fmt::format("{} needs two tests and has one", words.what));
  return std::nullopt;
}

}  // namespace triax::study
