// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/measured/local_fit.hpp"

#include <Eigen/Core>

namespace triax::lab {
namespace {

/// All signals at once: the same operations as one by one, in two thirds of the time.
using Signals = Eigen::Array<double, PathSample::kSignals, 1>;

void copy_signals(const Signals& from, LocalFit::Values& into) {
  Eigen::Map<Signals>(into.data()) = from;
}

}  // namespace

LocalFit fit_window(const BlockPyramid& pyramid, int level) {
  static_assert(BlockPyramid::kBlocks == 7, "the weights below are those of seven points");
  constexpr int n = BlockPyramid::kBlocks;
  constexpr int kMiddle = n / 2;
  const auto block = [&](int b) {
    return Eigen::Map<const Signals>(pyramid.block(level, b).signal.data());
  };
  const Signals middle = block(kMiddle);

  // Sums of y, i y, (i² − 4) y and y², y counted from the middle block so that nothing cancels.
  Signals sum = Signals::Zero(), first = sum, second = sum, square = sum;
  for (int b = 0; b < n; ++b) {
    const double i = b - kMiddle;
    const Signals y = block(b) - middle;
    sum += y;
    first += i * y;
    second += (i * i - 4) * y;
    square += y * y;
  }
  // The polynomials 1, i, i² − 4 are orthogonal over −3 … 3, with norms 7, 28 and 84.
  const Signals slope = first / 28, curvature = second / 84;
  LocalFit fit;
  copy_signals(middle, fit.middle.signal);
  copy_signals(slope, fit.slope);
  copy_signals(curvature, fit.curvature);
  copy_signals(middle + sum / 7 - 4 * curvature, fit.value);
  copy_signals(square - sum * sum / 7 - first * slope - second * curvature, fit.variance);
  // std::fmax is a call.
  for (double& residual : fit.variance) residual = (residual > 0 ? residual : 0.0) / (n - 3);
  return fit;
}

}  // namespace triax::lab
