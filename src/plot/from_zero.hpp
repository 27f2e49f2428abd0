// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <qcustomplot.h>

namespace triax::src {

/// The range from 0 where only the noise of a quantity that is never negative, and the margin that
/// this brought about, lie below (an eighth of the range at most).
inline QCPRange from_zero(const QCPRange& range) {
  return {range.lower < 0 && range.lower > -range.size() / 8 ? 0 : range.lower, range.upper};
}

}  // namespace triax::src
