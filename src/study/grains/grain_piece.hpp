// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Probes of one state of grains as a file, for batch systems: of the null probe (number 0) and the
// directions (number k is 360°/directions × (k − 1)) those with the numbers index − 1, index − 1 +
// count, ... (sim::numbers_of_piece), as one JSON document.
//
//   {"format": "triax grain probe piece", "version": 1, "program": "0.1.0", "origin": "simulated",
//    "piece": {"index": 2, "count": 8}, "specimen": {"programme", "stage", "fingerprint", ...},
//    "probing": {"directions": 36, "norm_Pa": 1000, ...}, "probes": [{"number": 1, ...}, ...],
//    "sha256": "..."}
//
// SI, as the engine has it, in digits that mean the same double: merged pieces are the run in one
// go to the bit. Compression positive.
#include <string>
#include <string_view>
#include <vector>

#include "lab/grains/grain_run.hpp"
#include "sim/grains/probes/grain_probe.hpp"
#include "sim/grains/state/grain_measures.hpp"

namespace triax::study {

inline constexpr const char* kGrainPieceFormat = "triax grain probe piece";
inline constexpr int kGrainPieceVersion = 3;

/// What is probed, and how; pieces of one rose agree in all of it.
struct ProbedGrains {
  std::string programme, stage;
  std::string fingerprint;         ///< of the state (sim::fingerprint), 16 hexadecimal digits
  std::int64_t grains = 0;         ///< > 0
  sim::AxisymmetricStress stress;  ///< that it carries, Pa
  sim::GrainMeasures measures;
  sim::GrainProbing probing;
  int directions = 36;  ///< 1 to 36000
};

struct GrainPiece {
  std::string file;     ///< it was read from
  std::string program;  ///< version that wrote it
  int index = 1, count = 1;
  ProbedGrains specimen;
  std::vector<sim::GrainProbe> probes;  ///< as sim::numbers_of_piece(directions, index, count)
};

/// Of a calm state, that is to be probed.
ProbedGrains probed_grains(const sim::GrainState& state, const std::string& programme,
                           const std::string& stage, const lab::GrainProbeStage& how);

/// Pre-condition: all probes are made.
std::string grain_piece_json(const GrainPiece& piece);

/// Reads one piece. Throws lab::BadInput, one line that names `file`: no JSON (cut off), something
/// else than a piece, another version, numbers or probes that do not belong to it.
GrainPiece read_grain_piece(std::string_view json, const std::string& file);

/// The same from a file on disk, which has to be what grain_piece_json() gave, to the byte.
GrainPiece load_grain_piece(const std::string& path);

/// "probing norm_Pa is 500.0, in FILE 1000.0": the first value of specimen or probing that differs,
/// FILE being that of `b`; empty where none does.
std::string difference(const GrainPiece& a, const GrainPiece& b);

/// All pieces of one rose as the run in one go. Throws lab::BadInput where specimen or probing
/// differ, a piece is missing or given twice. Pre-condition: at least one.
lab::GrainRose merged(const std::vector<GrainPiece>& pieces);

}  // namespace triax::study
