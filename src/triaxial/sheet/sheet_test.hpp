// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A test with all that its sheet says.
#include <cmath>
#include <optional>
#include <vector>

#include "src/study/sheet/sheet_values.hpp"
#include "src/study/sheet/sheet_words.hpp"
#include "src/study/triaxial/test_result.hpp"

namespace triax::src {

struct SheetTest {
  study::TestResult result;
  study::SheetValues values;
  study::SheetWords words;
};

/// What is asked of all sheets.
struct SheetRequest {
  study::SheetOptions options;
  std::vector<study::SaidWord> said;
};

SheetTest load_sheet_test(const db::Store& store, std::int64_t id,
                          const SheetRequest& request = {});

inline std::optional<double> if_known(double value) {
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

}  // namespace triax::src
