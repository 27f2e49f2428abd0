// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/records/stage_inference.hpp"

#include <catch2/catch.hpp>

#include "lab/records/tables/table_recognition.hpp"

using namespace triax::lab;
using enum Quantity;

namespace {
// One stage from start to end values, linear in 20 rows (kPa, mm3, mm, kN).
struct Ends {
  double cell[2], pore[2], volume[2], displacement[2], force[2];
};
StageSummary stage(int number, const Ends& ends, double typed_height_m = 0) {
  StageSummary summary;
  summary.number = number;
  constexpr int kRows = 20;
  for (int i = 0; i < kRows; ++i) {
    const double x = i / (kRows - 1.0);
    const auto at = [&](const double(&pair)[2]) { return pair[0] + x * (pair[1] - pair[0]); };
    Row row;
    row.si.fill(kMissing);
    row.line = i + 10;
    row.time_s = 10 * x;
    row.si[index(cell_pressure)] = 1e3 * at(ends.cell);
    row.si[index(pore_pressure)] = 1e3 * at(ends.pore);
    row.si[index(back_volume)] = 1e-9 * at(ends.volume);
    row.si[index(axial_displacement)] = 1e-3 * at(ends.displacement);
    row.si[index(axial_force)] = 1e3 * at(ends.force);
    if (typed_height_m > 0)
      row.si[index(axial_strain)] = row.si[index(axial_displacement)] / typed_height_m;
    summary.add(row);
  }
  return summary;
}
SpecimenInfo specimen() {
  SpecimenInfo info;
  info.height_m = 0.1;
  info.diameter_m = 0.05;
  return info;
}
}  // namespace

TEST_CASE("each stage is told by what moved in it") {
  const auto stages =
      infer_stages({stage(1, {{4, 100}, {2, 15}, {0, 0}, {0, 0}, {0, 0}}),
                    stage(2, {{100, 300}, {15, 299}, {0, 10000}, {0, 0}, {0, 0}}),
                    stage(3, {{300, 350}, {299, 335}, {10000, 10000}, {0, 0}, {0, 0}}),
                    stage(4, {{350, 350}, {335, 300}, {10000, 8000}, {0, 3}, {0, 0}}),
                    stage(5, {{350, 350}, {300, 330}, {8000, 8000}, {3, 27}, {0, 0.18}}),
                    stage(6, {{350, 350}, {330, 330}, {8000, 5000}, {27, 40}, {0.18, 0.3}}),
                    stage(7, {{350, 350}, {330, 330}, {5000, 5000}, {40, 40}, {0.3, 0.3}})},
                   specimen());
  REQUIRE(stages.size() == 7);
  CHECK(stages[0].role == StageRole::saturation);
  CHECK(stages[1].role == StageRole::saturation);
  CHECK(stages[2].role == StageRole::b_check);
  CHECK(stages[2].drainage == Drainage::closed);
  CHECK(stages[3].role == StageRole::consolidation);
  CHECK(stages[3].drainage == Drainage::open);
  CHECK(stages[4].role == StageRole::shear);
  CHECK(stages[4].drainage == Drainage::closed);
  CHECK(stages[4].control == AxialControl::displacement);
  CHECK(stages[5].role == StageRole::shear);
  CHECK(stages[5].drainage == Drainage::open);
  CHECK(stages[6].role == StageRole::unknown);
}

TEST_CASE("after the last B check nothing saturates: cell and back pressure are raised together") {
  const Ends raised{{300, 400}, {200, 290}, {5000, 4000}, {0, 0}, {0, 0}};
  const Ends check{{300, 350}, {200, 245}, {5000, 5000}, {0, 0}, {0, 0}};
  const auto before = infer_stages({stage(1, raised), stage(2, check)}, specimen());
  CHECK(before[0].role == StageRole::saturation);
  const auto after = infer_stages({stage(1, check), stage(2, raised)}, specimen());
  CHECK(after[1].role == StageRole::consolidation);
  const auto again = infer_stages({stage(1, check), stage(2, raised), stage(3, check)}, specimen());
  CHECK(again[1].role == StageRole::saturation);
}

TEST_CASE(
    "an axis that is loaded while the cell pressure rises consolidates, if shear comes later") {
  const Ends anisotropic{{300, 400}, {200, 200}, {5000, 3000}, {0, 2}, {0, 0.15}};
  const Ends shear{{400, 400}, {200, 250}, {3000, 3000}, {2, 20}, {0.15, 0.3}};
  const auto stages = infer_stages({stage(1, anisotropic), stage(2, shear)}, specimen());
  CHECK(stages[0].role == StageRole::consolidation);
  CHECK(stages[1].role == StageRole::shear);
  // By itself it is a stress path, and so it is at constant cell pressure (q of a CSD or CSU test).
  CHECK(infer_stages({stage(1, anisotropic)}, specimen())[0].role == StageRole::shear);
  const Ends drained{{400, 400}, {200, 200}, {5000, 3000}, {0, 2}, {0, 0.15}};
  CHECK(infer_stages({stage(1, drained), stage(2, shear)}, specimen())[0].role == StageRole::shear);
}

TEST_CASE("a deviator load at small strain is shear, and so is what follows while it stays (CSD)") {
  const Ends consolidated{{350, 350}, {335, 300}, {10000, 8000}, {0, 1}, {0, 0}};
  const Ends loads{{350, 350}, {300, 300}, {8000, 7800}, {1, 1.1}, {0, 0.06}};
  const Ends loosens{{350, 350}, {300, 340}, {7800, 8000}, {1.1, 1.15}, {0.06, 0.06}};
  const Ends rests{{350, 350}, {340, 340}, {8000, 8000}, {1.15, 1.15}, {0.06, 0.06}};
  const Ends taken_down{{350, 300}, {340, 340}, {8000, 8200}, {1.15, 1.1}, {0.06, 0}};
  const auto stages = infer_stages({stage(1, consolidated), stage(2, loads), stage(3, loosens),
                                    stage(4, rests), stage(5, taken_down)},
                                   specimen());
  CHECK(stages[0].role == StageRole::consolidation);
  CHECK(stages[1].role == StageRole::shear);
  CHECK(stages[2].role == StageRole::shear);
  CHECK(stages[3].role == StageRole::unknown);
  CHECK(stages[4].role != StageRole::shear);

  const auto alone = infer_stages({stage(1, loads), stage(2, loosens)}, specimen());
  CHECK(alone[0].role == StageRole::shear);
  CHECK(alone[1].role == StageRole::shear);

  // Before anything was consolidated the piston is being docked.
  const Ends confines{{300, 350}, {300, 300}, {7800, 5000}, {1.1, 1.3}, {0.06, 0.06}};
  const auto docked = infer_stages({stage(1, loads), stage(2, confines)}, specimen());
  CHECK(docked[0].role != StageRole::shear);
}

TEST_CASE("a stage that rests before consolidation is none of shear; one after it is unknown") {
  const Ends rests{{350, 350}, {335, 335}, {10000, 10000}, {0, 0}, {0, 0}};
  const Ends consolidates{{350, 350}, {335, 300}, {10000, 8000}, {0, 3}, {0, 0}};
  const Ends sheared{{350, 350}, {300, 330}, {8000, 8000}, {3, 27}, {0, 0.18}};
  const Ends stands{{350, 350}, {330, 330}, {8000, 8000}, {27, 27}, {0.18, 0.18}};
  const auto stages = infer_stages(
      {stage(1, rests), stage(2, consolidates), stage(3, sheared), stage(4, stands)}, specimen());
  CHECK(stages[0].role == StageRole::hold);
  CHECK(stages[1].role == StageRole::consolidation);
  CHECK(stages[2].role == StageRole::shear);
  CHECK(stages[3].role == StageRole::unknown);
}

TEST_CASE("a load that was there before and stays while the effective stress moves is held") {
  // The cap runs away unevenly in time: not by displacement.
  auto runs = stage(1, {{350, 350}, {300, 340}, {8000, 9000}, {1, 1}, {0.2, 0.2}});
  Row row;
  row.si.fill(kMissing);
  row.time_s = 11;
  row.si[index(cell_pressure)] = 350e3;
  row.si[index(pore_pressure)] = 340e3;
  row.si[index(back_volume)] = 9000e-9;
  row.si[index(axial_displacement)] = 9e-3;
  row.si[index(axial_force)] = 187;
  runs.add(row);
  const auto inferred = infer_stages({runs}, specimen())[0];
  CHECK(inferred.role == StageRole::shear);
  CHECK(inferred.control == AxialControl::constant_q);
}

TEST_CASE("what moved leaves some answers open and rules others out") {
  const auto said = [](const Ends& ends, StageRole role, Drainage drainage) {
    std::string all;
    for (const Guess::Said& one : other_answers(
             stage(5, ends), {.number = 5, .role = role, .drainage = drainage}, specimen()))
      all += one.key + "=" + one.value + " ";
    return all;
  };
  constexpr auto shear = StageRole::shear, consolidation = StageRole::consolidation;
  constexpr auto open = Drainage::open, closed = Drainage::closed;
  // Volume of the specimen: 196,350 mm3.
  CHECK(said({{350, 350}, {300, 330}, {8000, 8000}, {3, 27}, {0, 0.18}}, shear, closed).empty());
  CHECK(said({{350, 350}, {300, 301}, {8000, 8000}, {3, 27}, {0, 0.18}}, shear, closed) ==
        "stages.5.drainage=open ");
  CHECK(said({{350, 350}, {300, 300}, {8000, 5000}, {3, 27}, {0, 0.18}}, shear, open).empty());
  CHECK(said({{350, 350}, {300, 330}, {8000, 7900}, {3, 27}, {0, 0.18}}, shear, open) ==
        "stages.5.drainage=closed stages.5.control=constant_q ");
  CHECK(said({{350, 350}, {300, 300}, {8000, 5000}, {3, 3.1}, {0, 0.18}}, shear, open) ==
        "stages.5.role=consolidation ");
  CHECK(said({{350, 350}, {300, 340}, {8000, 5000}, {3, 27}, {0.18, 0.18}}, shear, open) ==
        "stages.5.control=constant_q ");
  CHECK(said({{350, 450}, {300, 300}, {8000, 5000}, {3, 4}, {0, 0.18}}, consolidation, open) ==
        "stages.5.role=shear ");
  CHECK(said({{350, 450}, {300, 300}, {8000, 5000}, {3, 4}, {0, 0}}, consolidation, open).empty());
}

TEST_CASE("a typed-in start height is found from the file's own strain") {
  const Ends shear{{350, 350}, {300, 330}, {0, 0}, {3, 27}, {0, 0.18}};
  const auto typed = typed_height(stage(5, shear, 0.0978), 0.09703);
  REQUIRE(typed);
  CHECK(*typed == Approx(0.0978).epsilon(1e-9));
  CHECK_FALSE(typed_height(stage(5, shear, 0.0978), 0.0978));
  CHECK_FALSE(typed_height(stage(5, shear), 0.09703));
  const Ends little{{350, 350}, {300, 330}, {0, 0}, {3, 3.5}, {0, 0.18}};
  CHECK_FALSE(typed_height(stage(5, little, 0.0978), 0.09703));
}

TEST_CASE("a line fit gives slope, scatter and explained share") {
  LineFit fit;
  for (int i = 0; i < 10; ++i) fit.add(i, 2.0 * i + 1 + (i % 2 ? 0.1 : -0.1));
  CHECK(fit.slope() == Approx(2).epsilon(0.01));
  CHECK(fit.residual() == Approx(0.1).epsilon(0.05));
  CHECK(fit.r_squared() > 0.999);
  fit.add(std::nan(""), 1);
  CHECK(fit.n == 10);
  CHECK(LineFit{}.r_squared() == 0);
}

TEST_CASE("stages are gathered in the order of the rows") {
  const auto source = open_memory(
      "m",
      "stage,axial_displacement_mm,axial_force_kN,cell_pressure_kPa\n2,0,0,1\n2,1,0,1\n3,5,0,1\n");
  std::vector<Warning> warnings;
  Findings findings(warnings);
  const auto layout = recognise_table(*source, {}, findings);
  TableReader reader(*source, layout, findings);
  const auto stages =
      summarise_stages(reader, [](double value, auto) { return static_cast<int>(value); });
  REQUIRE(stages.size() == 2);
  CHECK(stages[0].number == 2);
  CHECK(stages[0].rows == 2);
  CHECK(stages[0][axial_displacement].change() == Approx(1e-3));
  CHECK(stages[1].first_line == 4);
}
