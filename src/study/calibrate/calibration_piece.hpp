// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Some of the searches of a calibration as a file, for batch systems: search I, I + N, ... as one
// JSON document. What follows from all of them is computed by whoever merges them, from the same
// tests.
//
//   {"format": "triax calibration piece", "version": 1, "program": "0.2.0",
//    "piece": {"index": 2, "count": 4}, "settings": "SHA-256 of law, start, ranges and tests",
//    "searches": [{"number": 2, "runs": 12345, "optima": [{"cost": 0.8, "values": [...]}]}],
//    "sha256": "..."}
#include <string>
#include <vector>

#include "src/study/calibrate/calibration.hpp"

namespace triax::study {

std::string calibration_piece_json(const CalibrationRequest& request,
                                   const std::vector<SearchEnd>& ends, int index, int count);

/// The ends of all searches, in their order, from the files of all pieces. Throws lab::BadInput for
/// a file that is none, was changed, belongs to another calibration than this request, is given
/// twice or is missing.
std::vector<SearchEnd> merged_searches(const CalibrationRequest& request,
                                       const std::vector<std::string>& files);

}  // namespace triax::study
