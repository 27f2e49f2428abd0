// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/verdicts/forms.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>
#include <thread>

#include "lab/measured/path_sampler.hpp"
#include "lab/records/record_writer.hpp"

namespace triax::bench {
namespace {

using lab::Quantity;

std::string number(double value, int digits) {
  return std::isnan(value) ? "" : fmt::format("{:.{}f}", value, digits);
}

/// Our own form, as the program writes it; without the friction angle, which no laboratory's file
/// knows, and without the truth.
std::string own(const SimulatedTest& test, std::uint64_t) {
  lab::RecordHeader header = test.header;
  header.specimen.limit_friction_angle_rad.reset();
  const std::string path = (std::filesystem::temp_directory_path() /
                            fmt::format("triax_verdicts_{}_{}.csv", getpid(),
                                        std::hash<std::thread::id>()(std::this_thread::get_id())))
                               .string();
  lab::RecordWriter writer(path, header);
  for (const lab::Reading& reading : test.readings) writer.write(reading);
  writer.finish({}, std::nullopt);  // loggers do not say how a test ended
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  std::filesystem::remove(path);
  return text.str();
}

/// Raw channels under the names of a vendor's export, decimal comma or point.
std::string numbered_stages(const SimulatedTest& test, std::uint64_t seed) {
  struct Column {
    Quantity quantity;
    const char* heading;
    double scale;
    int digits;
  };
  static constexpr auto kColumns = std::to_array<Column>({
      {Quantity::cell_pressure, "Radial Pressure (kPa)", 1e-3, 3},
      {Quantity::back_pressure, "Back Pressure (kPa)", 1e-3, 3},
      {Quantity::back_volume, "Back Volume (mm³)", 1e9, 1},
      {Quantity::axial_force, "Load Cell (kN)", 1e-3, 6},
      {Quantity::pore_pressure, "Pore Pressure (kPa)", 1e-3, 3},
      {Quantity::axial_displacement, "Axial Displacement (mm)", 1e3, 5},
  });
  const bool comma = seed % 2 == 0;
  const auto cell = [&](std::string value) {
    if (comma) std::ranges::replace(value, '.', ',');
    return "\"" + value + "\"";
  };
  const auto& s = test.header.specimen;
  std::string text = fmt::format(
      "\"Description of Sample\",\"simulated, not measured\"\r\n\"Initial Height (mm)\",{}\r\n"
      "\"Initial Diameter (mm)\",{}\r\n",
      cell(number(*s.height_m * 1e3, 2)), cell(number(*s.diameter_m * 1e3, 2)));
  text += "\"Stage Number\",\"Time since start of test (s)\",\"Time since start of stage (s)\"";
  for (const Column& c : kColumns)
    if (test.header.has(c.quantity)) text += fmt::format(",\"{}\"", c.heading);
  text += "\r\n";
  double begun = 0;
  int stage = -1;
  for (const lab::Reading& reading : test.readings) {
    if (stage != reading.stage) begun = reading.time_s;
    stage = reading.stage;
    text += fmt::format("\"{}\",{},{}", stage, cell(number(reading.time_s, 3)),
                        cell(number(reading.time_s - begun, 3)));
    for (const Column& c : kColumns)
      if (test.header.has(c.quantity))
        text += "," + cell(number(reading[c.quantity] * c.scale, c.digits));
    text += "\r\n";
  }
  return text;
}

/// Reduced stresses and strains of shear, without time; a volume only where water could flow.
std::string reduced_table(const SimulatedTest& test, std::uint64_t) {
  bool drained = false;
  for (const lab::StageInfo& stage : test.header.stages)
    drained = drained || (lab::is_watched(&stage) && stage.drainage == lab::Drainage::open);
  std::string text =
      drained ? "eps1  epsv  p  q  u\n%  %  kPa  kPa  kPa\n" : "eps1  p  q  u\n%  kPa  kPa  kPa\n";
  for (std::size_t i = test.shear; i < test.states.size(); ++i) {
    const lab::State& s = test.states[i];
    if (!lab::complete(s)) continue;
    text += fmt::format("{:.5f}  ", s.strain.axial * 100);
    if (drained) text += fmt::format("{:.5f}  ", s.volumetric_strain * 100);
    text +=
        fmt::format("{:.4f}  {:.4f}  {:.4f}\n", s.p_eff / 1e3, s.q / 1e3, s.pore_pressure / 1e3);
  }
  return text;
}

constexpr auto kForms = std::to_array<Form>({
    {"described stages", ".csv", own},
    {"numbered stages", ".gds", numbered_stages},
    {"reduced table", ".dat", reduced_table},
});

}  // namespace

std::span<const Form> forms() { return kForms; }

}  // namespace triax::bench
