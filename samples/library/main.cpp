// SPDX-License-Identifier: GPL-3.0-or-later
// undrained [RECORD.csv]: finds the onset of instability of loose Hostun sand in undrained
// compression, of a law and of a recorded test.
#include <cstdio>

#include "db/store.hpp"
#include "lab/materials/material_library.hpp"
#include "lab/rig/recorded.hpp"
#include "sim/point/point_driver.hpp"
#include "src/study/triaxial/test_result.hpp"
#include "src/study/triaxial/test_run.hpp"

using namespace triax;
using Space = sim::Axisymmetric;

int main(int count, char** arguments) {
  // Law: applies axial strain at constant volume until the second-order work is not positive.
  const lab::MaterialSet sand = lab::find_material("inl2/S28-general");
  const auto& law = *sand.material.law<Space>();
  const auto increment = sim::MixedControl<Space>::strain_path(1e-4);
  auto state = law.isotropic(100e3, 1.086);
  for (int i = 1; i <= 1000; ++i) {
    const auto step = sim::advance_point(law, state, increment);
    state = step.state;
    if (step.outcome == sim::StepOutcome::accepted && step.second_order_work() > 0) continue;
    std::printf("law: unstable at %.2f %% of axial strain, eta = %.3f\n", 0.01 * i,
                state.q() / state.p());
    break;
  }

  // Record: reduces, monitors and stores the test like the program, then reads the result.
  if (count < 2) return 0;
  std::string database = "undrained.db";
  const auto id = study::run_test(*lab::open_record(arguments[1], {}), {}, database);
  const auto test = study::load_test_result(db::Store(database), id, study::WithCurves::no);
  if (const auto onset = study::collapse_onset(test.stored))
    std::printf("%s: unstable at eta = %.3f\n", test.stored.header.name.c_str(), *onset->eta());
}
