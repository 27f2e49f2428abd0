// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How the forecasts of this very test have moved as it went on: what they err by.
//
// A forecast that errs by a share of its distance moves as the distance shrinks, and s = dη_f/dη of
// its own earlier ones tells the share. It is found by least squares over the forecasts made
// within about half of the distance, in constant memory.
#include <optional>

namespace triax::lab {

class ForecastDrift {
 public:
  struct Slope {
    double value = 0, error = 0;
  };
  /// A forecast made at η = `now`, the onset `ahead` of it, with the standard error of its fit.
  void add(double now, double ahead, double error);
  /// dη_f/dη, drawn to zero as far as the errors of the fits hide it; and its standard error, that
  /// of what no test has told where there is one forecast.
  Slope slope() const;

 private:
  double latest_ = 0;
  double n_ = 0, x_ = 0, y_ = 0, xx_ = 0, xy_ = 0, variance_ = 0;
};

}  // namespace triax::lab
