// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/health/record_health.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "lab/devices/noise.hpp"
#include "tests/lab/reduction/raw_record.hpp"

using namespace triax::lab;
using triax::lab::testing::raw_header;

namespace {

RecordHeader driven(Drainage drainage) {
  RecordHeader header = raw_header();
  header.stages[2].drainage = drainage;
  header.stages[2].control = AxialControl::displacement;
  return header;
}

/// A perfect test without noise in stage 3: 0.01 mm and a little force at each reading.
Reading shear(std::int64_t i) {
  const double x = static_cast<double>(i);
  return triax::lab::testing::reading({3, 0.01 * x, 0.3 * (1 - std::exp(-x / 300)), 400,
                                       300 + 50 * (1 - std::exp(-x / 200)), -0.7 * x},
                                      i);
}

template <class Break>
RecordHealth watched(const RecordHeader& header, std::int64_t n, Break broken) {
  RecordHealth health(header);
  for (std::int64_t i = 0; i < n; ++i) {
    Reading reading = shear(i);
    broken(reading);
    health.watch(reading);
  }
  return health;
}

bool found(const RecordHealth& health, const std::string& text) {
  for (const Warning& w : health.warnings())
    if (w.text.find(text) != std::string::npos) return true;
  return false;
}

}  // namespace

TEST_CASE("a perfect test without noise: nothing is found") {
  for (Drainage drainage : {Drainage::open, Drainage::closed}) {
    const RecordHealth health = watched(driven(drainage), 2000, [](Reading&) {});
    CHECK(health.warnings().empty());
    CHECK(health.news().empty());
  }
}

TEST_CASE("a force that stands still to the last digit while the area grows is stuck") {
  const auto broken = [held = 0.0](Reading& r) mutable {
    if (r.number == 400) held = r[Quantity::axial_force];
    if (r.number > 400) r[Quantity::axial_force] = held;
  };
  CHECK(found(watched(driven(Drainage::closed), 500, broken),
              "the load cell (axial_force) is stuck at 0.220921 kN from reading 401 (401 s) on"));
  // A coarse cell may stand still: a plateau.
  const auto coarse = [&](Reading& r) {
    r[Quantity::axial_force] = std::round(r[Quantity::axial_force] / 10) * 10;
  };
  CHECK(watched(driven(Drainage::closed), 3000, coarse).warnings().empty());
}

TEST_CASE(
    "a displacement that stands still while the load changes is stuck, a coarse dial is not") {
  const auto broken = [](Reading& r) {
    if (r.number > 100) r[Quantity::axial_displacement] = 1e-3;
  };
  CHECK(found(watched(driven(Drainage::closed), 300, broken), "(axial_displacement) is stuck"));
  const auto coarse = [](Reading& r) {
    r[Quantity::axial_displacement] = std::floor(r[Quantity::axial_displacement] * 2e3) / 2e3;
  };
  CHECK(watched(driven(Drainage::closed), 1000, coarse).warnings().empty());
}

TEST_CASE(
    "drained, a volume that stands still while p' changes is stuck; undrained it is at rest") {
  const auto broken = [](Reading& r) {
    if (r.number > 100) r[Quantity::back_volume] = -70e-9;
  };
  CHECK(found(watched(driven(Drainage::open), 300, broken), "(back_volume) is stuck"));
  CHECK(watched(driven(Drainage::closed), 300, broken).warnings().empty());
}

TEST_CASE("one channel alone jumps to a constant: saturated; with the others it is the specimen") {
  const auto alone = [](Reading& r) {
    if (r.number > 200) r[Quantity::pore_pressure] = 2e6;
  };
  CHECK(found(watched(driven(Drainage::closed), 220, alone),
              "the pore-pressure transducer (pore_pressure) is saturated: jumped to 2000 kPa and "
              "stays there, open circuit or overload, from reading 201 (201 s) on"));
  const auto together = [&](Reading& r) {
    if (r.number <= 200) return;
    r[Quantity::pore_pressure] = 390e3;
    r[Quantity::cell_pressure] = 440e3;
  };
  CHECK_FALSE(found(watched(driven(Drainage::closed), 220, together), "pore_pressure"));
}

TEST_CASE("findings of one kind are one warning with a count, each is news") {
  RecordHealth health(driven(Drainage::closed));
  int news = 0;
  for (std::int64_t i = 0; i < 1000; ++i) {
    Reading reading = shear(i);
    reading[Quantity::cell_pressure] += 50 * standard_normal(1, 1, std::uint64_t(i));
    if (i % 100 == 50) reading[Quantity::cell_pressure] += 300e3;
    health.watch(reading);
    news += static_cast<int>(health.news().size());
    for (const auto& wrong : health.wrong()) {
      CHECK(wrong.from % 100 == 50);
      CHECK(wrong.until == wrong.from);
    }
  }
  CHECK(news == 10);
  REQUIRE(health.warnings().size() == 1);
  CHECK(found(health, "and 9 more times"));
}

TEST_CASE("a specimen that falls between two readings outruns its water: the gauge is not stuck") {
  const auto stuck = [](double per_reading) {
    RecordHeader header = driven(Drainage::open);
    header.stages[2].control = AxialControl::constant_q;
    const RecordHealth health = watched(header, 600, [&](Reading& reading) {
      if (reading.number < 500) return;
      reading[Quantity::back_volume] = shear(500)[Quantity::back_volume];
      const double after = static_cast<double>(std::min<std::int64_t>(reading.number - 500, 80));
      if (reading.number > 540)
        reading[Quantity::axial_displacement] += std::min((after - 40) * per_reading, 20e-3);
    });
    return found(health, "back_volume");
  };
  CHECK_FALSE(stuck(20e-3));
  CHECK(stuck(0.2e-3));
}

TEST_CASE("along a strain path a volume that rests is stuck only where it was to flow") {
  const auto along = [](double R) {
    RecordHeader header = driven(Drainage::open);
    header.stages[2].strain_path_R = R;
    return header;
  };
  const auto broken = [](Reading& r) {
    if (r.number > 100) r[Quantity::back_volume] = -70e-9;
  };
  // dε_v = (1 − 1/R) dε₁: nothing flows at R = 1.
  CHECK(watched(along(1), 1500, broken).warnings().empty());
  CHECK(
      watched(along(1), 1500, [](Reading& r) { r[Quantity::back_volume] = 0; }).warnings().empty());
  for (const double R : {0.7, 1.5})
    CHECK(found(watched(along(R), 300, broken), "(back_volume) is stuck"));
}

TEST_CASE(
    "reduced: a volume that stands still is stuck, unless the water that is shut in answers") {
  const auto volume_is_stuck = [](bool pore_pressure_moves) {
    RecordHeader header;
    header.columns = {Quantity::axial_strain, Quantity::volumetric_strain,
                      Quantity::mean_effective_stress, Quantity::deviator_stress,
                      Quantity::pore_pressure};
    header.stages = {{.number = 1, .role = StageRole::shear, .drainage = Drainage::open}};
    RecordHealth health(header);
    for (int i = 0; i < 1500; ++i) {
      Reading r;
      r.number = i;
      r.stage = 1;
      const int shut = std::max(0, i - 500);  // the valve is shut, or the gauge dies, here
      const auto noise = [&](std::uint64_t k) {
        return standard_normal(3, k, static_cast<std::uint64_t>(i));
      };
      r[Quantity::axial_strain] = 1e-5 * i;
      r[Quantity::volumetric_strain] = shut > 0 ? 5e-3 : 1e-5 * i + 1e-6 * noise(1);
      r[Quantity::deviator_stress] = 100 * i + 50 * noise(2);
      r[Quantity::mean_effective_stress] = 100e3 + 30 * i;
      r[Quantity::pore_pressure] = 300e3 + 20 * noise(4) + (pore_pressure_moves ? 30.0 * shut : 0);
      health.watch(r);
    }
    return found(health, "volumetric_strain");
  };
  CHECK(volume_is_stuck(false));
  CHECK_FALSE(volume_is_stuck(true));
}

TEST_CASE("RecordHealth: a held pressure without noise is stuck in a record of triax alone") {
  const auto reports = [](const std::string& dialect, Quantity quantity) {
    RecordHeader header = driven(Drainage::closed);
    header.dialect = dialect;
    const RecordHealth health = watched(header, 2000, [&](Reading& r) {
      const auto noise = standard_normal(1, 1, static_cast<std::uint64_t>(r.number));
      if (r.number < 1000) r.si[index(quantity)] += 100 * std::round(10 * noise);
      if (r.number >= 1000) r.si[index(quantity)] = shear(1000)[quantity];
    });
    return found(health, "stuck");
  };
  CHECK(reports("triax", Quantity::cell_pressure));
  CHECK(reports("", Quantity::cell_pressure));
  CHECK_FALSE(reports("table", Quantity::cell_pressure));
  CHECK(reports("table", Quantity::pore_pressure));
}

TEST_CASE("RecordHealth: through an open valve the pore pressure rests with the back pressure") {
  const auto is_stuck = [](Drainage drainage, bool back_pressure_moves) {
    RecordHeader header = driven(drainage);
    header.dialect = "table";
    const RecordHealth health = watched(header, 2000, [&](Reading& r) {
      const auto noise = [&](std::uint64_t channel) {
        const auto number = static_cast<std::uint64_t>(r.number);
        return 100 * std::round(10 * standard_normal(1, channel, number));
      };
      r.si[index(Quantity::pore_pressure)] = 300e3 + (r.number < 1000 ? noise(1) : 0);
      const bool moves = back_pressure_moves && r.number > 1100;
      r.si[index(Quantity::back_pressure)] =
          300e3 + noise(2) + (moves ? 100.0 * static_cast<double>(r.number - 1100) : 0);
    });
    return found(health, "stuck");
  };
  CHECK_FALSE(is_stuck(Drainage::open, false));
  CHECK(is_stuck(Drainage::open, true));
  CHECK(is_stuck(Drainage::closed, false));
}
