// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/grains/lammps_export.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>

#include "lab/grains/lammps_script.hpp"

namespace triax::lab {
namespace {

constexpr int kMostBins = 64;
/// Room around the walls, of their distance: LAMMPS wants every grain in its box at the start.
constexpr double kRoom = 0.05;

void check(const sim::GrainPath& path) {
  const auto positive = [](double x) { return x > 0 && std::isfinite(x); };
  const bool isotropic = path.kind == sim::GrainPathKind::isotropic;
  const bool strained = isotropic || (positive(std::abs(path.strain_rate_per_s)) &&
                                      positive(path.axial_strain) && path.samples > 0);
  const bool stressed = path.kind == sim::GrainPathKind::strain_path || positive(path.pressure_pa);
  if (!strained || !stressed || !positive(path.ratio))
    throw std::invalid_argument("LAMMPS: pressure, strain rate, strain and R must be above 0");
}

void check_name(const std::string& name) {
  const bool plain = std::ranges::all_of(name, [](unsigned char c) {
    return c > ' ' && c < 127 &&
           std::string_view("\"'`$&#/\\*?").find(static_cast<char>(c)) == std::string_view::npos;
  });
  if (name.empty() || !plain)
    throw std::invalid_argument(
        "LAMMPS: names of its files must be of letters, digits, dots, dashes and underscores");
}

/// On one line that LAMMPS does not continue.
std::string plain(std::string text) {
  for (char& c : text)
    if (c == '&' || c == '$' || static_cast<unsigned char>(c) < ' ') c = ' ';
  return text;
}

std::string data_of(const sim::GrainState& s, const SizeBins& bins, const std::string& title) {
  std::string out =
      fmt::format("simulated with triax, written for LAMMPS: {}\n\n{} atoms\n{} atom types\n\n",
                  title, s.grains.size(), bins.radius_m.size());
  const auto add = std::back_inserter(out);
  for (int a = 0; a < 3; ++a) {
    const double room = kRoom * s.box.length_m(a);
    fmt::format_to(add, "{0} {1} {2}lo {2}hi\n", s.box.low_m[a] - room, s.box.high_m[a] + room,
                   "xyz"[a]);
  }
  out += "\nAtoms # sphere\n\n";
  for (std::size_t i = 0; i < s.grains.size(); ++i) {
    const sim::Grain& g = s.grains[i];
    fmt::format_to(add, "{} {} {} {} {} {} {}\n", s.ids[i] + 1, bins.of[i] + 1, 2 * g.radius,
                   s.law.density_kg_per_m3, g.position[0], g.position[1], g.position[2]);
  }
  out += "\nVelocities\n\n";
  for (std::size_t i = 0; i < s.grains.size(); ++i) {
    const sim::Grain& g = s.grains[i];
    fmt::format_to(add, "{} {} {} {} {} {} {}\n", s.ids[i] + 1, g.velocity[0], g.velocity[1],
                   g.velocity[2], g.spin[0], g.spin[1], g.spin[2]);
  }
  return out;
}

}  // namespace

LammpsExport lammps_export(const sim::GrainState& state, const sim::GrainPath& path,
                           const LammpsOptions& options) {
  check(path);
  check_name(options.data_file);
  check_name(options.table_file);
  if (options.bins < 1 || options.bins > kMostBins)
    throw std::invalid_argument("LAMMPS: 1 to 64 bins of size are possible");
  const SizeBins bins = size_bins(state, options.bins);
  LammpsOptions named = options;
  named.title = plain(options.title);
  return {data_of(state, bins, named.title), lammps_script(state, path, bins, named)};
}

}  // namespace triax::lab
