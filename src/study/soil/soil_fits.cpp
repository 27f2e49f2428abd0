// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/soil/soil_fits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace triax::study {
namespace {

void say_odd(Soil& soil, const OddTest& odd, std::size_t test, const FitWords& words, bool kept) {
  auto& of = soil.tests[test];
  const std::string why =
      fmt::format("{} is {:.3g} {} the value of the others for {} ({:.1f} standard deviations)",
                  words.value, std::abs(odd.residual), odd.residual > 0 ? "above" : "below",
                  words.what, std::abs(odd.deviations));
  of.reason += (of.reason.empty() ? "" : "; ") + why;
  soil.notes.push_back(fmt::format("{}: {}; it is {}", of.name, why,
                                   kept ? "kept in the fit" : "not used in this fit"));
}

}  // namespace

JudgedForm judged_form(const Gathered& all, FitKind kind, const FitWords& words) {
  JudgedForm form;
  form.points.reserve(all.points.size());
  for (const FitPoint& p : all.points) {
    JudgedPoint judged{.y = p.y, .x = {}, .x_error = {}};
    judged.y_error =
        std::sqrt(std::max(p.y_error * p.y_error - all.least_error * all.least_error, 0.0));
    judged.usual = std::hypot(words.usual, words.usual_share * p.y);
    judged.usual_of_x = words.usual_of_x;
    if (kind == FitKind::line) judged.x = {p.x}, judged.x_error = {p.x_error};
    form.points.push_back(std::move(judged));
  }
  if (kind == FitKind::line) form.usual_slopes = {kUnknownSlope};
  return form;
}

void add_x(JudgedForm& form, const std::vector<double>& x, double usual_slope) {
  for (std::size_t i = 0; i < form.points.size(); ++i)
    form.points[i].x.push_back(x[i]), form.points[i].x_error.push_back(0);
  form.usual_slopes.push_back(usual_slope);
}

JudgedForm form_over_state(const Soil& soil, const Gathered& all, const FitWords& words,
                           const UsualCurve& usual) {
  JudgedForm form = judged_form(all, FitKind::line, words);
  std::vector<double> squares, pressures;
  for (std::size_t i = 0; i < all.tests.size(); ++i) {
    squares.push_back(all.points[i].x * all.points[i].x);
    pressures.push_back(std::log(*soil.tests[all.tests[i]].p_eff_kPa));
  }
  add_x(form, squares, usual.of_state);
  add_x(form, pressures, usual.of_pressure);
  return form;
}

std::vector<std::size_t> name_odd(Soil& soil, const SoilOptions& options, const Forms& forms,
                                  const std::vector<std::size_t>& tests, const FitWords& words) {
  std::vector<std::size_t> named;
  for (const auto& one : odd_tests(forms)) {
    named.push_back(tests[one.index]);
    say_odd(soil, one, named.back(), words, options.keep_odd);
  }
  return named;
}

Gathered without(const Gathered& all, const std::vector<std::size_t>& tests,
                 const SoilOptions& options, Gathered* odd) {
  if (options.keep_odd) return all;
  Gathered left;
  for (std::size_t i = 0; i < all.tests.size(); ++i) {
    const bool out = std::ranges::find(tests, all.tests[i]) != tests.end();
    if (!out) left.add(all.points[i], all.tests[i]);
    if (out && odd != nullptr) odd->add(all.points[i], all.tests[i]);
  }
  return left;
}

Gathered without_odd(Soil& soil, const SoilOptions& options, const Gathered& all,
                     const Forms& forms, const FitWords& words, Gathered* odd) {
  return without(all, name_odd(soil, options, forms, all.tests, words), options, odd);
}

Gathered without_odd(Soil& soil, const SoilOptions& options, const Gathered& all, FitKind kind,
                     const FitWords& words, Gathered* odd) {
  return without_odd(soil, options, all, Forms{judged_form(all, kind, words)}, words, odd);
}

std::optional<Trend> trend_through(Soil& soil, const Gathered& left, const Gathered& odd,
                                   const FitWords& words, bool say_missing) {
  if (const auto line = fit_line(left.points))
    return Trend{*line, left.points, left.tests, odd.points, odd.tests};
  if (say_missing)
    soil.notes.push_back(
        left.points.size() < 3
            ? fmt::format("{} needs three tests; found {}", words.what, left.points.size())
            : fmt::format("{} needs different tests; all {} are at one point", words.what,
                          left.points.size()));
  return std::nullopt;
}

std::optional<Trend> trend_of(Soil& soil, const SoilOptions& options, const Gathered& all,
                              const FitWords& words, bool say_missing) {
  return trend_of(soil, options, all, Forms{judged_form(all, FitKind::line, words)}, words,
                  say_missing);
}

std::optional<Trend> trend_of(Soil& soil, const SoilOptions& options, const Gathered& all,
                              const Forms& forms, const FitWords& words, bool say_missing) {
  Gathered odd;
  const Gathered left = without_odd(soil, options, all, forms, words, &odd);
  return trend_through(soil, left, odd, words, say_missing);
}

std::optional<Level> level_of(Soil& soil, const SoilOptions& options, const Gathered& all,
                              const Forms& forms, const FitWords& words) {
  const Gathered left = without_odd(soil, options, all, forms, words);
  if (const auto fit = fit_mean(left.points)) return Level{*fit, left.tests};
  if (!left.points.empty())
    soil.notes.push_back(fmt::format("{} needs two tests; found one", words.what));
  return std::nullopt;
}

}  // namespace triax::study
