// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The tables of a report of grains, with units in their headings; what is unknown reads "–".
#include <string>
#include <utility>
#include <vector>

#include "lab/grains/grain_report.hpp"
#include "src/output/table.hpp"

namespace triax::src {

/// A row each stage: what it was, from where, what came of it.
Table stages_table(const lab::GrainReport& report);
/// A row each path, of each strain path, of each mark, of each rest, of each perturbation.
Table paths_table(const lab::GrainReport& report);
Table strain_paths_table(const lab::GrainReport& report);
Table marks_table(const lab::GrainReport& report);
Table rests_table(const lab::GrainReport& report);
Table perturbations_table(const lab::GrainReport& report);
/// Where the energy of each stage went, but of roses.
Table energies_table(const lab::GrainReport& report);
/// What their columns mean, a sentence each.
std::vector<std::string> paths_notes();
std::vector<std::string> strain_paths_notes();
std::vector<std::string> perturbations_notes();

/// A row each probe, the null probe last.
struct RoseTables {
  Table responses;  ///< strains, sliding and non-permanent contacts, kinetic energy
  Table work;       ///< second-order work in all its forms
  Table gap;        ///< what the macroscopic and the microscopic one differ by
  Table energy;     ///< where the energy of each probe went
};
/// What the columns of `gap` and of `energy` mean.
std::vector<std::string> gap_notes();
std::vector<std::string> energy_notes();
RoseTables rose_tables(const lab::ReportedGrainRose& rose);
/// Label and words: what the probes show together.
std::vector<std::pair<std::string, std::string>> rose_facts(const lab::ReportedGrainRose& rose);

/// What came of a stage, in a few words.
std::string came_to(const lab::ReportedGrainStage& stage);

}  // namespace triax::src
