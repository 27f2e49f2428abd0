// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Words of stages, from lab/intake/lexicon/stages.toml. Codes of tests: lab/results/test_type.hpp.
#include <string_view>

#include "lab/results/record_header.hpp"

namespace triax::lab {

enum class LoadDirection { unknown, compression, extension };

/// Properties of a stage that follow from its name.
struct StageWords {
  StageRole role = StageRole::unknown;
  Drainage drainage = Drainage::unknown;
  LoadDirection direction = LoadDirection::unknown;
  bool is_cyclic = false;
};
/// Reads a cell of a stage column or the title of a block. The longest word that is found counts.
/// Every member is unknown for a text without known words, for a number and for a text of more than
/// 200 characters.
StageWords read_stage_words(std::string_view text);

}  // namespace triax::lab
