// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/lab/health/spoiled_record.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace triax::lab::testing {
namespace {

constexpr double kHeight_mm = 140, kArea_mm2 = std::numbers::pi / 4 * 70 * 70;
constexpr double kCell_kPa = 400;

double hyperbola(double e) { return e / (e + 0.01); }
double bend(double e) { return e / (e + 0.012); }
/// q up to a peak at 1 % and down to a fifth of it.
double softening(double e) {
  return 60 * (e < 0.01 ? 2 * e / 0.01 - e * e / 1e-4
                        : 0.2 + 0.8 / (1 + std::pow((e - 0.01) / 0.02, 2)));
}

std::string preamble_of(bool drained) {
  return fmt::format(
      "# [test]\n# name = \"g\"\n# programme = \"{}\"\n# [specimen]\n# height_mm = 140\n"
      "# diameter_mm = 70\n# [[stages]]\n# number = 1\n# name = \"s\"\n# role = \"shear\"\n"
      "# drainage = \"{}\"\n# control = \"displacement\"\n",
      drained ? "CID" : "CIU", drained ? "open" : "closed");
}

struct Point {
  double time, strain, q, p, volume;
  double axial() const { return p + 2 * q / 3; }
  double radial() const { return p - q / 3; }
  double pore() const { return kCell_kPa - radial(); }
};

std::vector<double> raw_cells(const Point& s) {
  const double area = kArea_mm2 * (1 - s.volume) / (1 - s.strain);
  const double water = s.volume * kHeight_mm * kArea_mm2;
  return {s.time, 1,        s.strain * kHeight_mm, s.q * area * 1e-6, kCell_kPa,
          300,    s.pore(), 0.0 - water,           500 + 1.02 * water};
}

std::vector<std::string> headings_of(const std::string& columns) {
  if (columns == "raw")
    return {"time_s",
            "stage",
            "axial_displacement_mm",
            "axial_force_kN",
            "cell_pressure_kPa",
            "back_pressure_kPa",
            "pore_pressure_kPa",
            "back_volume_mm3",
            "cell_volume_mm3"};
  const std::vector<std::string> strains{"time_s", "axial_strain_pct", "volumetric_strain_pct"};
  std::vector<std::string> all = strains;
  if (columns == "q p'")
    all.insert(all.end(), {"deviator_stress_kPa", "mean_effective_stress_kPa"});
  if (columns == "s1' s3'" || columns == "all")
    all.insert(all.end(), {"effective_axial_stress_kPa", "effective_radial_stress_kPa"});
  if (columns == "q u")
    all.insert(all.end(), {"deviator_stress_kPa", "cell_pressure_kPa", "pore_pressure_kPa"});
  if (columns == "all") all.insert(all.end(), {"deviator_stress_kPa", "mean_effective_stress_kPa"});
  return all;
}

std::vector<double> cells_of(const std::string& columns, const Point& s) {
  if (columns == "raw") return raw_cells(s);
  std::vector<double> all{s.time, s.strain * 100, s.volume * 100};
  if (columns == "q p'") all.insert(all.end(), {s.q, s.p});
  if (columns == "s1' s3'" || columns == "all") all.insert(all.end(), {s.axial(), s.radial()});
  if (columns == "q u") all.insert(all.end(), {s.q, kCell_kPa, s.pore()});
  if (columns == "all") all.insert(all.end(), {s.q, s.p});
  return all;
}

}  // namespace

const std::vector<ClosedFormTest>& hardening_tests() {
  const auto none = [](double) { return 0.0; };
  static const std::vector<ClosedFormTest> kTests{
      {"contracting", false, [](double e) { return 88 * hyperbola(e); },
       [](double e) { return 100 - 35 * hyperbola(e); }, none},
      {"dilating", false, [](double e) { return 60 * hyperbola(e) + 900 * e; },
       [](double e) { return 100 - 30 * e / (e + 0.004) + 720 * e; }, none},
      {"straight", false, [](double e) { return 10 + 700 * e; },
       [](double e) { return 100 - 300 * e; }, none},
      {"drained, contracting", true, [](double e) { return 207 * hyperbola(e); },
       [](double e) { return 100 + 69 * hyperbola(e); },
       [](double e) { return 0.02 * hyperbola(e); }},
      {"drained, dilating", true, [](double e) { return 250 * bend(e); },
       [](double e) { return 100 + 250 * bend(e) / 3; },
       [](double e) { return 0.004 * hyperbola(e) - 0.15 * e * e / (e + 0.02); }},
      {"drained, straight", true, [](double e) { return 20 + 1500 * e; },
       [](double e) { return 100 + 20.0 / 3 + 500 * e; }, [](double e) { return 0.3 * e; }}};
  return kTests;
}

const std::vector<ClosedFormTest>& collapsing_tests() {
  static const std::vector<ClosedFormTest> kTests{
      {"flowing", false, softening,
       [](double e) { return softening(e) / 1.2 + 50 * std::exp(-e / 0.006); },
       [](double) { return 0.0; }}};
  return kTests;
}

std::string Sheet::text() const {
  std::string all = preamble + fmt::format("{}\n", fmt::join(headings, ","));
  for (const auto& row : rows) all += fmt::format("{}\n", fmt::join(row, ","));
  return all;
}

Sheet write_sheet(const ClosedFormTest& test, const RecordForm& form, std::mt19937& random) {
  Sheet sheet;
  const bool raw = form.columns == "raw";
  if (raw) sheet.preamble = preamble_of(test.drained);
  sheet.headings = headings_of(form.columns);
  const std::size_t first = raw ? 2 : 1;
  for (std::size_t c = first; c < sheet.headings.size(); ++c) sheet.channels.push_back(c);
  std::normal_distribution<double> normal;
  for (int i = 0; i < form.readings; ++i) {
    const double t = double(i) / (form.readings - 1);
    const double e = form.last_strain * (form.equal_steps ? t : t * (0.1 + 0.9 * t));
    auto cells = cells_of(form.columns, {10.0 * i, e, test.q(e), test.p(e), test.volume(e)});
    auto& row = sheet.rows.emplace_back();
    for (std::size_t c = 0; c < cells.size(); ++c) {
      if (c >= first) cells[c] += form.noise * (std::fabs(cells[c]) + 1e-3) * normal(random);
      row.push_back(fmt::format("{:.5f}", cells[c] + 0.0));
    }
  }
  return sheet;
}

std::size_t spoil(Sheet& sheet, std::size_t column, const Spoiler& spoiler) {
  double largest = 0;
  for (const auto& row : sheet.rows)
    largest = std::max(largest, std::fabs(std::stod(row.at(column))));
  if (largest == 0) largest = 5;
  const std::string text = spoiler.code.starts_with('x')
                               ? fmt::format("{:.4f}", largest * std::stod(spoiler.code.substr(1)))
                               : spoiler.code;
  const auto count = static_cast<std::size_t>(spoiler.cells);
  const auto last_start = double(sheet.rows.size() - count);
  const auto from = static_cast<std::size_t>(std::lround(spoiler.where * last_start));
  for (std::size_t i = from; i < from + count; ++i) sheet.rows[i].at(column) = text;
  return from;
}

}  // namespace triax::lab::testing
