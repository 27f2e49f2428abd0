// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The parts of study_soil: each fits what it can, and notes what it cannot and why.
#include "src/study/soil/odd_tests.hpp"
#include "src/study/soil/soil.hpp"

namespace triax::study {

/// The critical state line in both forms, M and M_e.
void fit_critical_states(Soil& soil, const SoilOptions& options);
/// φ at the peak, stress-dilatancy, dilatancy and undrained strength over ψ.
void fit_peaks(Soil& soil, const SoilOptions& options);
void fit_strength(Soil& soil, const SoilOptions& options);
void fit_onsets(Soil& soil, const SoilOptions& options);
void fit_cyclic(Soil& soil, const SoilOptions& options);

/// Points of tests that may go into a fit.
struct Gathered {
  std::vector<FitPoint> points;
  std::vector<std::size_t> tests;  ///< their places in Soil::tests
  /// Part of each y_error that is no error but keeps one test from speaking for all.
  double least_error = 0;
  void add(const FitPoint& point, std::size_t test) {
    points.push_back(point);
    tests.push_back(test);
  }
};

/// What a fit is called, and how repeated tests of a good laboratory scatter (standard deviations).
struct FitWords {
  std::string what;        ///< "the critical state line"
  std::string value;       ///< what lies off: "e"
  double usual = 0;        ///< in the unit of y
  double usual_share = 0;  ///< of y, besides
  double usual_of_x = 0;
};

/// Of the ψ of repeated tests: that of their e.
inline constexpr double kUsualPsi = 0.01;

enum class FitKind { mean, line };
using Forms = std::vector<std::vector<JudgedPoint>>;
/// The points as they are judged.
std::vector<JudgedPoint> judged_points(const Gathered& all, FitKind kind, const FitWords& words);
/// The last form with one more x, of each point.
void add_form(Forms& forms, const std::vector<double>& x);
/// 1/p′ (1/kPa) at a state of each test, by which a stress ratio changes where there is cohesion.
template <class PressureOf>
std::vector<double> over_pressure(const Soil& soil, const Gathered& all, const PressureOf& of) {
  std::vector<double> x;
  for (const std::size_t test : all.tests) x.push_back(1 / of(soil.tests[test]));
  return x;
}

/// Points over ψ₀ of an undrained value, which falls with it in a curve, and with p′₀ where the
/// critical state line is one. The first and the last are beyond what the others tell of a curve.
Forms forms_over_state(const Soil& soil, const Gathered& all, const FitWords& words);

/// Says which tests are odd, with the reason, in the notes and at the test, and gives their places
/// in Soil::tests. `forms`: odd_tests.hpp, one point for each of `tests`.
std::vector<std::size_t> name_odd(Soil& soil, const SoilOptions& options, const Forms& forms,
                                  const std::vector<std::size_t>& tests, const FitWords& words);
/// Without those tests, which go into `odd`; all where they are kept.
Gathered without(const Gathered& all, const std::vector<std::size_t>& tests,
                 const SoilOptions& options, Gathered* odd = nullptr);
/// Names and takes out odd tests.
Gathered without_odd(Soil& soil, const SoilOptions& options, const Gathered& all, FitKind kind,
                     const FitWords& words, Gathered* odd = nullptr);
/// The same, by several forms.
Gathered without_odd(Soil& soil, const SoilOptions& options, const Gathered& all,
                     const Forms& forms, const FitWords& words, Gathered* odd = nullptr);
/// A line through them; a note, and nothing, for fewer than three or where x is all one.
std::optional<Trend> trend_through(Soil& soil, const Gathered& left, const Gathered& odd,
                                   const FitWords& words, bool say_missing = true);
/// The same, odd tests named and taken out before.
std::optional<Trend> trend_of(Soil& soil, const SoilOptions& options, const Gathered& all,
                              const FitWords& words, bool say_missing = true);
std::optional<Trend> trend_of(Soil& soil, const SoilOptions& options, const Gathered& all,
                              const Forms& forms, const FitWords& words, bool say_missing = true);
std::optional<Level> level_of(Soil& soil, const SoilOptions& options, const Gathered& all,
                              const Forms& forms, const FitWords& words);

}  // namespace triax::study
