// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/sheet/sheet_test.hpp"

namespace triax::src {

SheetTest load_sheet_test(const db::Store& store, std::int64_t id, const SheetRequest& request) {
  SheetTest test{study::load_test_result(store, id, study::WithCurves::yes), {}, {}};
  test.words = study::sheet_words(test.result.stored, request.said);
  auto options = request.options;
  if (const auto at = study::drained_at(test.words)) {
    options.drained_at = *at;
    options.boundary_is_said = true;
  }
  test.values = study::sheet_values(store, test.result.stored, options);
  return test;
}

}  // namespace triax::src
