// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Parameters of a law from tests: several global searches on coarse paths, least squares on the
// whole ones from the best members of each, and then how well the parameters are determined and
// what they predict.
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "src/study/calibrate/implied_domain.hpp"
#include "src/study/calibrate/uncertainty.hpp"
#include "src/study/progress.hpp"

namespace triax::study {

/// An end of a search: values of the free parameters in the units of the file, and the cost.
struct Optimum {
  std::vector<double> values;
  double cost = 0;  ///< Σ r² over the number of series (misfit.hpp)
  int found = 1;    ///< searches that ended here
};

/// One global search with what came of it downhill.
struct SearchEnd {
  int number = 1;  ///< from 1; its seed follows from it
  std::vector<Optimum> optima;
  std::int64_t runs = 0;  ///< of the driver, along a test each
};

struct CalibrationRequest {
  lab::MaterialSet start;              ///< of what is not free, and where the search begins
  std::vector<lab::SearchRange> free;  ///< what is searched
  std::vector<MeasuredPath> paths;
  int searches = 3;  ///< global ones
  std::uint64_t seed = 1;
  int threads = 0;                 ///< 0: all cores; results do not depend on it
  double void_ratio_error = 0;     ///< standard error of each test's void ratio
  bool left_out = true;            ///< predict each collapse from the other tests
  bool domain = false;             ///< draw the cones and the domain that the set implies
  std::vector<std::string> notes;  ///< what was taken from where
};

/// What separates one quantity of one test from the law.
struct SeriesMisfit {
  std::string test;
  Compared quantity = Compared::q;
  double rms = 0;       ///< weighted along the path, SI
  double noise = 0;     ///< of single values, SI
  double cost = 0;      ///< Σ r²; 1 is a misfit of kAccuracy of the span
  double reached = 1;   ///< share of the knots that the law reached
  std::string refusal;  ///< why not all; else empty
};

/// η at collapse of a test, from the parameters that the other tests give.
struct Prediction {
  std::int64_t id = 0;  ///< of the test in the database; 0: none
  std::string test;
  double measured = 0, measured_error = 0;
  std::optional<double> predicted;  ///< empty: the law does not collapse there
  double low = 0, high = 0;         ///< 90 % for what is measured; only where predicted
  bool holds() const { return predicted && low <= measured && measured <= high; }
};

struct Calibration {
  lab::MaterialSet start;
  lab::MaterialSet material;  ///< with the best parameters
  std::vector<ParameterEstimate> parameters;
  Eigen::MatrixXd correlation;
  double confidence = 0.95;
  double degrees_of_freedom = 0;
  double cost = 0;
  std::optional<double> start_cost;  ///< of the set that it started from; empty: out of the ranges
  std::vector<Optimum> optima;       ///< the best first; others only that fit about as well
  int searches = 0;                  ///< that ran to their end
  int ended_at_best = 0;             ///< of them, those whose own best is the best
  std::vector<SeriesMisfit> misfits;
  std::vector<MeasuredPath> measured;
  std::vector<ComputedPath> computed;  ///< with the best parameters, test by test
  std::vector<Prediction> predictions;
  std::optional<ImpliedDomain> domain;  ///< empty: not asked for, or stopped before
  bool interrupted = false;
  std::int64_t runs = 0;  ///< of the driver, along a test each
  std::vector<std::string> notes;
};

/// Asked now and then; false stops, with the best so far.
using GoOn = std::function<bool()>;

/// The searches number `first`, first + step, ... of the request; "calibrating" is what is told.
std::vector<SearchEnd> run_searches(const CalibrationRequest& request, int first, int step,
                                    const Progress& progress, const GoOn& go_on);

/// What follows from the ends of all searches; "cones and domain" is told, too. Pre-condition: at
/// least one has an optimum.
Calibration conclude(const CalibrationRequest& request, const std::vector<SearchEnd>& ends,
                     const Progress& progress, const GoOn& go_on);

/// Both. Throws lab::WorkFailed where it was stopped before anything was found.
Calibration calibrate(
    const CalibrationRequest& request, const Progress& progress = {},
    const GoOn& go_on = [] { return true; });

/// The path with so many knots at most, whose weights stand for those left out.
MeasuredPath thinned(const MeasuredPath& path, int knots);

}  // namespace triax::study
