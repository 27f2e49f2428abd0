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
  void add(const FitPoint& point, std::size_t test) {
    points.push_back(point);
    tests.push_back(test);
  }
};

/// What a fit is called, and how repeated tests scatter.
struct FitWords {
  std::string what;   ///< "the critical state line"
  std::string value;  ///< what lies off: "e"
  double usual = 0;   ///< odd_tests.hpp
};

/// Takes odd tests out of the points (unless they are kept) and says so, with its reason, in the
/// notes and at the test.
Gathered without_odd(Soil& soil, const SoilOptions& options, const Gathered& all, FitKind kind,
                     const FitWords& words, Gathered* odd = nullptr);
/// A line through what is left; a note, and nothing, for fewer than three or where x is all one.
std::optional<Trend> trend_of(Soil& soil, const SoilOptions& options, const Gathered& all,
                              const FitWords& words, bool say_missing = true);
std::optional<Level> level_of(Soil& soil, const SoilOptions& options, const Gathered& all,
                              const FitWords& words);

}  // namespace triax::study
