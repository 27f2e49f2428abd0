#include "sim/point/mixed_control.hpp"

namespace triax::sim {

MixedControl MixedControl::strain_path(double axial_strain, double R) {
  MixedControl c;
  c.strain << 1, 0, 1, 2 * R;
  c.increment << axial_strain, 0;
  return c;
}

MixedControl MixedControl::stress_path(double dp, double dq) {
  MixedControl c;
  c.stress << 1.0 / 3, 2.0 / 3, 1, -1;
  c.increment << dp, dq;
  return c;
}

MixedControl MixedControl::drained_compression(double axial_strain) {
  MixedControl c;
  c.strain << 1, 0, 0, 0;
  c.stress << 0, 0, 0, 1;
  c.increment << axial_strain, 0;
  return c;
}

}  // namespace triax::sim
