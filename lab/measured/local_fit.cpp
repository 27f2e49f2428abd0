// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/measured/local_fit.hpp"

#include <cmath>

namespace triax::lab {

LocalFit fit_window(const BlockPyramid& pyramid, int level) {
  static_assert(BlockPyramid::kBlocks == 7, "the weights below are those of seven points");
  constexpr int n = BlockPyramid::kBlocks;
  constexpr int kMiddle = n / 2;
  const auto& middle = pyramid.block(level, kMiddle).signal;

  // Sums of y, i y, (i² − 4) y and y², y counted from the middle block so that nothing cancels.
  LocalFit::Values sum{}, first{}, second{}, square{};
  for (int b = 0; b < n; ++b) {
    const auto& signal = pyramid.block(level, b).signal;
    const double i = b - kMiddle;
    for (std::size_t k = 0; k < PathSample::kSignals; ++k) {
      const double y = signal[k] - middle[k];
      sum[k] += y;
      first[k] += i * y;
      second[k] += (i * i - 4) * y;
      square[k] += y * y;
    }
  }
  // The polynomials 1, i, i² − 4 are orthogonal over −3 … 3, with norms 7, 28 and 84.
  LocalFit fit;
  fit.middle.signal = middle;
  for (std::size_t k = 0; k < PathSample::kSignals; ++k) {
    fit.slope[k] = first[k] / 28;
    fit.curvature[k] = second[k] / 84;
    fit.value[k] = middle[k] + sum[k] / 7 - 4 * fit.curvature[k];
    const double residual =
        square[k] - sum[k] * sum[k] / 7 - first[k] * fit.slope[k] - second[k] * fit.curvature[k];
    fit.variance[k] = std::fmax(residual, 0.0) / (n - 3);
  }
  return fit;
}

}  // namespace triax::lab
