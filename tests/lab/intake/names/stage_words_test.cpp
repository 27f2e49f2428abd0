// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/intake/names/stage_words.hpp"

#include <catch2/catch.hpp>

using namespace triax::lab;

namespace {}  // namespace

TEST_CASE("read_stage_words: words in 13 languages have their role") {
  struct Case {
    std::string_view text;
    StageRole role;
  };
  for (const auto& [text, role] : std::to_array<Case>({
           {"Back Pressure Saturation", StageRole::saturation},
           {"SAT_1", StageRole::saturation},
           {"B check 2", StageRole::b_check},
           {"Konsolidation Stufe 3", StageRole::consolidation},
           {"Consolidation1", StageRole::consolidation},
           {"Cisaillement", StageRole::shear},
           {"corte", StageRole::shear},
           {"adensamento", StageRole::consolidation},
           {"Rottura", StageRole::shear},
           {"verzadigen", StageRole::saturation},
           {"ŚCINANIE", StageRole::shear},
           {"kesme", StageRole::shear},
           {"Консолидация", StageRole::consolidation},
           {"不排水剪切阶段", StageRole::shear},
           {"圧密過程", StageRole::consolidation},
           {"전단", StageRole::shear},
           {"Creep", StageRole::hold},
           {"Zzyzx", StageRole::unknown},
           {"2.5", StageRole::unknown},
           {"", StageRole::unknown},
       })) {
    INFO(text);
    CHECK(read_stage_words(text).role == role);
  }
}

TEST_CASE("read_stage_words: drainage, direction and cyclic loading are read, too") {
  const StageWords words = read_stage_words("Undrained extension, shear");
  CHECK(words.role == StageRole::shear);
  CHECK(words.drainage == Drainage::closed);
  CHECK(words.direction == LoadDirection::extension);
  CHECK_FALSE(words.is_cyclic);
  CHECK(read_stage_words("Drained shearing").drainage == Drainage::open);
  CHECK(read_stage_words("非排水せん断").drainage == Drainage::closed);
  CHECK(read_stage_words("cyclic loading").is_cyclic);
}
