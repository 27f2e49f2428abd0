// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/grains/vtk_snapshot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "sim/grains/state/grain_measures.hpp"

namespace triax::lab {
namespace {

float brief(double x) { return static_cast<float>(x); }

VtkPolyData begun(const sim::GrainState& s, const std::string& title, const char* what) {
  VtkPolyData data;
  data.comment = fmt::format("simulated with triax: {}; {}", title, what);
  data.time_s = s.time_s;
  return data;
}

std::vector<double> centres(const sim::GrainState& s) {
  std::vector<double> points(3 * s.grains.size());
  for (std::size_t i = 0; i < s.grains.size(); ++i)
    std::copy_n(s.grains[i].position, 3, points.begin() + 3 * s.ids[i]);
  return points;
}

/// Places in the order of the description, as values of cells or points are wanted.
struct OfGrains {
  explicit OfGrains(const sim::GrainState& s)
      : radius(s.grains.size()),
        velocity(3 * s.grains.size()),
        spin(3 * s.grains.size()),
        energy(s.grains.size()),
        pressure(s.grains.size()),
        contacts(s.grains.size()),
        floating(s.grains.size()) {
    for (std::size_t i = 0; i < s.grains.size(); ++i) take(s.grains[i], s.ids[i]);
    std::vector<double> moment(s.grains.size());
    for (const sim::GrainContact& c : sim::contacts_of(s)) take(s, c, moment);
    for (std::size_t i = 0; i < s.grains.size(); ++i) {
      const double r = s.grains[i].radius;
      pressure[s.ids[i]] = brief(moment[i] / (4 * std::numbers::pi * r * r * r));
    }
    std::ranges::transform(contacts, floating.begin(), [](int n) { return n == 0 ? 1 : 0; });
  }

  std::vector<float> radius, velocity, spin, energy, pressure;
  std::vector<std::int32_t> contacts, floating;

 private:
  void take(const sim::Grain& g, std::int32_t id) {
    radius[id] = brief(g.radius);
    double v = 0, w = 0;
    for (int a = 0; a < 3; ++a) {
      velocity[3 * id + a] = brief(g.velocity[a]);
      spin[3 * id + a] = brief(g.spin[a]);
      v += g.velocity[a] * g.velocity[a];
      w += g.spin[a] * g.spin[a];
    }
    energy[id] = brief(0.5 * (v / g.inverse_mass + w / g.inverse_inertia));
  }
  /// A tangential force has no part in the pressure: it is across the arm.
  void take(const sim::GrainState& s, const sim::GrainContact& c, std::vector<double>& moment) {
    ++contacts[s.ids[c.i]];
    const double distance = c.branch_m.norm();
    if (c.j < 0) {
      moment[c.i] += c.normal_force_n * distance;
      return;
    }
    ++contacts[s.ids[c.j]];
    const double arm = 0.5 * (distance + s.grains[c.i].radius - s.grains[c.j].radius);
    moment[c.i] += c.normal_force_n * arm;
    moment[c.j] += c.normal_force_n * (distance - arm);
  }
};

void add_line(VtkPolyData& data, std::int32_t from, std::int32_t to) {
  data.connectivity.insert(data.connectivity.end(), {from, to});
  data.offsets.push_back(static_cast<std::int32_t>(data.connectivity.size()));
}

}  // namespace

std::string vtk_grains(const sim::GrainState& state, const std::string& title) {
  VtkPolyData data = begun(state, title, "grains");
  const OfGrains of(state);
  data.points_m = centres(state);
  std::vector<std::int32_t> ids;
  for (std::int32_t i = 0; i < static_cast<std::int32_t>(state.grains.size()); ++i) {
    ids.push_back(i);
    data.offsets.push_back(i + 1);
  }
  data.connectivity = ids;
  data.point_data = {vtk_array("radius_m", of.radius),
                     vtk_array("id", ids),
                     vtk_array("velocity_m_per_s", of.velocity, 3),
                     vtk_array("spin_rad_per_s", of.spin, 3),
                     vtk_array("kinetic_energy_J", of.energy),
                     vtk_array("contacts", of.contacts),
                     vtk_array("floating", of.floating),
                     vtk_array("pressure_Pa", of.pressure)};
  return vtk_document(data);
}

std::string vtk_contacts(const sim::GrainState& state, const std::string& title) {
  VtkPolyData data = begun(state, title, "contacts");
  data.lines = true;
  data.points_m = centres(state);
  std::vector<float> normal, tangential;
  std::vector<std::int32_t> slides, wall;
  for (const sim::GrainContact& c : sim::contacts_of(state)) {
    std::int32_t to = static_cast<std::int32_t>(data.points_m.size() / 3);
    if (c.j >= 0) {
      to = state.ids[c.j];
    } else {
      const sim::Grain& g = state.grains[c.i];
      const int w = -1 - c.j, axis = w / 2;
      for (int a = 0; a < 3; ++a) data.points_m.push_back(g.position[a]);
      data.points_m[3 * to + axis] = w % 2 == 0 ? state.box.low_m[axis] : state.box.high_m[axis];
    }
    add_line(data, state.ids[c.i], to);
    normal.push_back(brief(c.normal_force_n));
    tangential.push_back(brief(c.tangential_force_n));
    slides.push_back(c.slides ? 1 : 0);
    wall.push_back(c.j < 0 ? -1 - c.j : -1);
  }
  data.cell_data = {vtk_array("normal_force_N", normal),
                    vtk_array("tangential_force_N", tangential), vtk_array("slides", slides),
                    vtk_array("wall", wall)};
  return vtk_document(data);
}

std::string vtk_box(const sim::GrainState& state, const std::string& title) {
  VtkPolyData data = begun(state, title, "box");
  data.lines = true;
  for (int corner = 0; corner < 8; ++corner)
    for (int a = 0; a < 3; ++a)
      data.points_m.push_back((corner >> a & 1) == 0 ? state.box.low_m[a] : state.box.high_m[a]);
  for (std::int32_t corner = 0; corner < 8; ++corner)
    for (int a = 0; a < 3; ++a)
      if ((corner >> a & 1) == 0) add_line(data, corner, corner | 1 << a);
  std::vector<double> pressure;
  for (int w = 0; w < 6; ++w) pressure.push_back(state.walls.force_n[w] / state.box.area_m2(w / 2));
  const auto& rate = state.walls.strain_rate_per_s;
  data.field = {vtk_array("wall_pressure_Pa", pressure),
                vtk_array("strain_rate_per_s", std::vector<double>(rate.begin(), rate.end()))};
  return vtk_document(data);
}

}  // namespace triax::lab
