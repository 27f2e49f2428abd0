// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <vector>

#include "lab/rig/recorded.hpp"
#include "src/study/intake/import_choices.hpp"

namespace triax::study {

/// The tables of a file as proposals.
struct ImportFile {
  std::vector<lab::Proposal> proposals;  ///< at least one; several for tables side by side
  ImportSource source;
};

/// Reads the first and last rows of a file. A worksheet is that of the options, else the first that
/// is recognised, else the one with the largest table. Throws BadInput for a file that holds no
/// table of numbers.
ImportFile read_proposals(const std::string& path, const lab::RecordOptions& options);

}  // namespace triax::study
