#include "lab/devices/spoken_unit.hpp"

namespace triax::lab {

sim::Unit spoken_unit(Quantity channel) {
  return *sim::find_unit(channel == Quantity::axial_force ? "N" : info(channel).unit);
}

}  // namespace triax::lab
