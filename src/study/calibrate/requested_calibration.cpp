// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/calibrate/requested_calibration.hpp"

#include <fmt/format.h>

#include "lab/base/bad_input.hpp"
#include "src/study/calibrate/test_paths.hpp"

namespace triax::study {

CalibrationRequest requested_calibration(const StartWish& wish, const std::string& db,
                                         const std::vector<std::string>& tests) {
  CalibrationStart start = calibration_start(wish);
  if (!start.set.material.axisymmetric)
    throw lab::BadInput(fmt::format("{} has no triaxial form", start.set.law->name));
  const db::Store store(db);
  CalibrationRequest request{.start = std::move(start.set),
                             .free = std::move(start.free),
                             .paths = paths_of_tests(store, store.find(tests)),
                             .domain = true,
                             .notes = std::move(start.notes)};
  check_enough(request.free.size(), request.paths);
  return request;
}

}  // namespace triax::study
