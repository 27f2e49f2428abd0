// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/programmes/transducer_reader.hpp"

#include <catch2/catch.hpp>

#include "lab/base/toml_reader.hpp"
#include "tests/lab/programmes/rig_text.hpp"

using namespace triax::lab;
using Catch::Contains;

namespace {
Transducer read_one_transducer(const std::string& lines,
                               Quantity channel = Quantity::pore_pressure) {
  return read_transducer(channel, std::nullopt, TomlTable::parse(lines, "t.toml"));
}
std::string complaint_of_transducer(const std::string& lines) {
  return test::complaint_of_rig("[rig.transducers.pore_pressure]\n" + lines);
}
}  // namespace

TEST_CASE("a transducer of which nothing is said is perfect") {
  const Transducer t = read_transducer(Quantity::axial_displacement, std::nullopt, std::nullopt);
  CHECK(t.unit.name == "mm");
  for (const double value :
       {t.range, t.step, t.noise_rms, t.offset, t.drift_per_hour, t.time_constant_s, t.hysteresis,
        t.nonlinearity, t.sensitivity_mV, t.sampling_interval_s})
    CHECK(value == 0);
  CHECK(t.calibration.empty());
}

TEST_CASE("every imperfection of a transducer has its key") {
  const Transducer t = read_one_transducer(R"(
range_kPa = 1000
resolution_kPa = 0.5
noise_kPa = 0.05
offset_kPa = -2
drift_kPa_per_h = 0.3
time_constant_s = 0.1
hysteresis_pct_of_range = 0.2
nonlinearity_pct_of_range = -0.1
sensitivity_mV = 100
calibration_kPa_of_mV = [0.5, 10, 0.001]
sampling_interval_s = 2
)");
  CHECK(t.range == 1000);
  CHECK(t.step == 0.5);
  CHECK(t.noise_rms == 0.05);
  CHECK(t.offset == -2);
  CHECK(t.drift_per_hour == 0.3);
  CHECK(t.time_constant_s == 0.1);
  // Rising and falling are 0.2 % of the range apart.
  CHECK(t.hysteresis == Approx(1));
  CHECK(t.nonlinearity == Approx(-1));
  CHECK(t.sensitivity_mV == 100);
  CHECK(t.calibration == std::vector<double>{0.5, 10, 0.001});
  CHECK(t.sampling_interval_s == 2);
}

TEST_CASE("a load cell is spoken of in newtons and kept in kilonewtons") {
  const Transducer t = read_one_transducer(R"(
range_N = 5000
drift_N_per_h = 2
hysteresis_pct_of_range = 0.1
sensitivity_mV = 20
calibration_N_of_mV = [10, 250]
)",
                                           Quantity::axial_force);
  CHECK(t.range == Approx(5));
  CHECK(t.drift_per_hour == Approx(2e-3));
  CHECK(t.hysteresis == Approx(2.5e-3));
  CHECK(t.calibration[0] == Approx(0.01));
  CHECK(t.calibration[1] == Approx(0.25));
}

TEST_CASE("the programme's own key is stronger than that of the set, the others stay") {
  const auto base = TomlTable::parse("range_kPa = 1000\nbits = 16\nnoise_kPa = 0.1\n", "b.toml");
  const auto over = [&](const char* own) {
    return read_transducer(Quantity::pore_pressure, base, TomlTable::parse(own, "o.toml"));
  };
  CHECK(over("noise_kPa = 0").noise_rms == 0);
  CHECK(over("noise_kPa = 0").step == converter_step(1000, 16));
  // The converter goes with the range.
  CHECK(over("range_kPa = 2000").step == converter_step(2000, 16));
  CHECK(over("bits = 20").step == converter_step(1000, 20));
  CHECK(over("resolution_kPa = 1").step == 1);
  CHECK(over("resolution_kPa = 0").step == 0);
  CHECK(over("sensitivity_mV = 5\ncalibration_kPa_of_mV = []").calibration.empty());
}

TEST_CASE("keys that need another one say so, at their line") {
  CHECK_THAT(complaint_of_transducer("hysteresis_pct_of_range = 1"),
             Contains("p.toml:15: [rig.transducers.pore_pressure] hysteresis_pct_of_range: needs "
                      "range_kPa as well"));
  CHECK_THAT(complaint_of_transducer("nonlinearity_pct_of_range = 1"), Contains("needs range_kPa"));
  CHECK_THAT(complaint_of_transducer("sensitivity_mV = 1"), Contains("needs range_kPa"));
  CHECK_THAT(complaint_of_transducer("range_kPa = 100\ncalibration_kPa_of_mV = [0, 1]"),
             Contains("p.toml:16") && Contains("needs sensitivity_mV"));
  CHECK_THAT(complaint_of_transducer("range_kPa = 100\nbits = 16\nresolution_kPa = 1"),
             Contains("p.toml:16") && Contains("either bits or resolution_kPa"));
  CHECK_THAT(complaint_of_transducer("range_kPa = 100\nresolution_kPa = 101"), Contains("coarser"));
}

TEST_CASE("values that no instrument has are refused") {
  for (const char* line :
       {"time_constant_s = -1", "time_constant_s = 1e9", "hysteresis_pct_of_range = -1",
        "hysteresis_pct_of_range = 21", "nonlinearity_pct_of_range = 21", "sensitivity_mV = -1",
        "time_constant_s = 5e-324", "sampling_interval_s = -1", "noise_kPa = 1e10",
        "offset_kPa = 1e300", "drift_kPa_per_h = nan", "drift_kPa_per_min = 1",
        "calibration_kPa_of_mV = 3", "calibration_kPa_of_mV = [1]",
        "calibration_kPa_of_mV = [1, 2, 3, 4, 5, 6, 7, 8, 9]"})
    CHECK_THAT(complaint_of_transducer(line), Contains("p.toml:15"));
  CHECK_THAT(complaint_of_transducer(
                 "calibration_kPa_of_mV = [0, 1e300]\nrange_kPa = 100\nsensitivity_mV = 50"),
             Contains("at full scale"));
}
