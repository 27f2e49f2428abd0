// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The tables behind a report of grains, with full digits: what is written as CSV and beside the
// figures.
#include <string>
#include <vector>

#include "lab/grains/grain_report.hpp"
#include "src/plot/figure_files.hpp"

namespace triax::src {

/// Every point with W₂ of the increment that led there (Eq. 30), for these paths together; a column
/// `stage` counts the stages of the report from 1, and a remark names them.
FigureData paths_data(const lab::GrainReport& report,
                      const std::vector<const lab::ReportedGrainStage*>& stages);
/// Every probe of a rose, the null probe last, without an angle. Pre-condition: the stage is one.
FigureData rose_data(const lab::GrainReport& report, const lab::ReportedGrainStage& stage);
/// Every point of these perturbations.
FigureData perturbations_data(const lab::GrainReport& report,
                              const std::vector<const lab::ReportedGrainStage*>& stages);

struct NamedBytes {
  std::string suffix;  ///< "_STAGE_points.csv", to be put behind the prefix of the file
  std::string bytes;
};

/// A CSV a stage: _STAGE_points.csv of paths and perturbations, _STAGE_probes.csv, with STAGE as
/// lab::in_file_name() has it. A rest has none.
std::vector<NamedBytes> grain_csvs(const lab::GrainReport& report);

}  // namespace triax::src
