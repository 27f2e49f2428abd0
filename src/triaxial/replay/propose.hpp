// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

#include "lab/rig/recorded.hpp"

namespace triax::src {

enum class ProposalFormat {
  dialect,  ///< TOML for --dialect
  meaning,  ///< columns in canonical units, for comparison with a known meaning
};

/// The text of `triax replay FILE --propose`. Throws BadInput for a file that holds no table.
std::string proposal_of(const std::string& path, const lab::RecordOptions& options,
                        ProposalFormat format);

}  // namespace triax::src
