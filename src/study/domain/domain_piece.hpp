// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A piece of a bifurcation domain as a file, for batch systems and MPI: columns index, index +
// count, ... of a grid, as one JSON document.
//
//   {"format": "triax bifurcation domain piece", "version": 1, "program": "0.1.0",
//    "origin": "simulated", "piece": {"index": 2, "count": 8}, "material": {...}, "grid": {...},
//    "warnings": [...], "columns": [{"column": 1, "p_eff_kPa": ..., "compression": {...},
//    "extension": {...}, "refusal": ..., "states": [...]}, ...], "sha256": "..."}
//
// Numbers have the digits that mean the same value, so that merged pieces are the run in one go to
// the byte.
#include <string>
#include <string_view>
#include <vector>

#include "src/study/domain/domain_report.hpp"

namespace triax::study {

inline constexpr const char* kPieceFormat = "triax bifurcation domain piece";
inline constexpr int kPieceVersion = 1;

struct DomainPiece {
  std::string file;     ///< it was read from
  std::string program;  ///< version that wrote it
  int index = 1, count = 1;
  ReportedDomain domain;  ///< the columns of the piece only
};

/// The bounds of a grid, of the options and of a file alike. Throws lab::BadInput with `subject`
/// before what is wrong.
void check_grid(const DomainSettings::Grid& grid, const std::string& subject);

std::string piece_json(const ReportedDomain& columns, int index, int count);

/// Reads one piece. Throws lab::BadInput, one line that names `file`: no JSON (cut off), something
/// else than a piece, another version, numbers that do not belong to its grid.
DomainPiece read_piece(std::string_view json, const std::string& file);

/// The same from a file on disk, which has to be what piece_json() gave, to the byte.
DomainPiece load_piece(const std::string& path);

/// All pieces of one domain as one. Throws lab::BadInput where settings differ, a piece is missing
/// or given twice.
ReportedDomain merged(std::vector<DomainPiece> pieces);

}  // namespace triax::study
