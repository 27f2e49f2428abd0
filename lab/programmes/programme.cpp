#include "lab/programmes/programme.hpp"

namespace triax::lab {

bool by_force(AxialAction action) {
  switch (action) {
    case AxialAction::load:
    case AxialAction::dead_load:
    case AxialAction::constant_q:
    case AxialAction::stress_ratio:
      return true;
    default:
      return false;
  }
}

}  // namespace triax::lab
