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
using Forms = std::vector<JudgedForm>;
/// The points as they are judged.
JudgedForm judged_form(const Gathered& all, FitKind kind, const FitWords& words);
/// One more x of each point, with the usual size of its slope.
void add_x(JudgedForm& form, const std::vector<double>& x, double usual_slope);

/// What sands have of a cohesion in η p′, kPa, by which a stress ratio goes with 1/p′.
inline constexpr double kUsualCohesion = 20;
/// A stress ratio that may go with 1/p′ at a state of each test.
template <class PressureOf>
void add_cohesion(JudgedForm& form, const Soil& soil, const Gathered& all, const PressureOf& of) {
  std::vector<double> x;
  for (const std::size_t test : all.tests) x.push_back(1 / of(soil.tests[test]));
  add_x(form, x, kUsualCohesion);
}

/// What falls with ψ₀ falls in a curve, and goes with p′₀ where the critical state line is one.
struct UsualCurve {
  double of_state = 0;     ///< of ψ², in the unit of y
  double of_pressure = 0;  ///< of ln p′₀
};
/// Points over ψ₀ of an undrained value.
JudgedForm form_over_state(const Soil& soil, const Gathered& all, const FitWords& words,
                           const UsualCurve& usual);

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
