// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The columns that a path of one material point is told in, with their units.
#include <string>
#include <vector>

#include "src/study/element/path_result.hpp"

namespace triax::study {

/// Without the points' segments.
template <class Space>
std::vector<std::string> column_names(const sim::Law<Space>& law);

/// Values in the order of column_names; what is unknown or not finite is empty.
template <class Space>
ResultPoint result_point(const sim::Path<Space>& path, const sim::PathPoint<Space>& at);

/// Empty for NaN and infinity.
std::optional<double> finite(std::optional<double> value);

extern template std::vector<std::string> column_names(const sim::Law<sim::Axisymmetric>&);
extern template std::vector<std::string> column_names(const sim::Law<sim::Tensor>&);
extern template ResultPoint result_point(const sim::Path<sim::Axisymmetric>&,
                                         const sim::PathPoint<sim::Axisymmetric>&);
extern template ResultPoint result_point(const sim::Path<sim::Tensor>&,
                                         const sim::PathPoint<sim::Tensor>&);

}  // namespace triax::study
