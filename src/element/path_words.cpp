// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/element/path_words.hpp"

namespace triax::src {

std::string word_of(sim::StepOutcome outcome) {
  switch (outcome) {
    case sim::StepOutcome::accepted:
      return "accepted";
    case sim::StepOutcome::inaccurate:
      return "inaccurate";
    case sim::StepOutcome::lost_control:
      return "lost_control";
    case sim::StepOutcome::failed:
      break;
  }
  return "failed";
}

std::string word_of(sim::PathEventKind kind) {
  switch (kind) {
    case sim::PathEventKind::end_condition:
      return "end_condition";
    case sim::PathEventKind::second_order_work:
      return "second_order_work";
    case sim::PathEventKind::peak:
      return "peak";
    case sim::PathEventKind::control_limit:
      break;
  }
  return "control_limit";
}

}  // namespace triax::src
