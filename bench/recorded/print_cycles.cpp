// SPDX-License-Identifier: GPL-3.0-or-later
// bench_recorded_cycles FILE...
// Prints what CyclicWarning finds in each reading of undrained cyclic tests: the probability, 1 if
// the warning is in force, 1 if q has turned and the load was carried, and the four numbers ("-"
// without any). A file has lines with q in kPa, p' in kPa and axial strain in % (compression
// positive), separated by spaces. Files are separated by an empty line in the output.
#include <fmt/format.h>

#include <fstream>

#include "lab/warning/cyclic_warning.hpp"

namespace {

void print_cycles(const char* file) {
  using namespace triax::lab;
  CyclicWarning warning(false);
  std::ifstream lines(file);
  double q_kpa = 0, p_kpa = 0, strain_percent = 0;
  while (lines >> q_kpa >> p_kpa >> strain_percent) {
    State state;
    state.q = q_kpa * 1e3;
    state.p_eff = p_kpa * 1e3;
    state.strain.axial = strain_percent / 100;
    state.cycle = 0;
    warning.add(state);
    fmt::print("{:.6g} {:d} {:d}", warning.probability(), warning.is_imminent(),
               warning.load_was_carried());
    if (!warning.numbers()) fmt::print(" -");
    if (warning.numbers())
      for (const double x : *warning.numbers()) fmt::print(" {:.6g}", x);
    fmt::print("\n");
  }
}

}  // namespace

int main(int argc, char** argv) {
  for (int i = 1; i < argc; ++i) {
    print_cycles(argv[i]);
    fmt::print("\n");
  }
}
