#pragma once
#include <functional>
#include <optional>

namespace triax::sim {

/// A number that is positive while something holds, along a line of states; empty where it has no
/// value, which counts as holding.
using Criterion = std::function<std::optional<double>(double at)>;

struct LossOptions {
  int steps = 100;  ///< equal ones, in which the loss is looked for: what comes and goes within one
                    ///< is not seen
  double precision = 1e-12;  ///< of the place, as a part of the whole line
};

/// The first place from `from` towards `to` (which may be less) where the criterion is ≤ 0, by
/// steps and bisection; at `from` if it is so there already. Empty: nowhere.
std::optional<double> first_loss(const Criterion& criterion, double from, double to,
                                 const LossOptions& options = {});

}  // namespace triax::sim
