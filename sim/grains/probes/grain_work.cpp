// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/grains/probes/grain_work.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "sim/grains/probes/contact_increment.hpp"
#include "sim/grains/state/grain_measures.hpp"
#include "sim/grains/state/triaxial_axes.hpp"

namespace triax::sim {
namespace {

using Eigen::Vector3d;

Vector3d vector(const double* v) { return {v[0], v[1], v[2]}; }

/// Grains by their number in the description.
struct Placed {
  Vector3d centre;
  double radius = 0;
};
std::vector<Placed> placed(const GrainState& s) {
  std::vector<Placed> by_id(s.grains.size());
  for (std::size_t i = 0; i < s.grains.size(); ++i) {
    const Grain& g = s.grains[i];
    by_id[s.ids[i]] = {vector(g.position) - s.time_step_s * vector(g.velocity), g.radius};
  }
  return by_id;
}

/// A contact of grain a < b, or of grain a with a wall (b = −1 − wall); numbers of the description.
struct Known {
  std::int32_t a, b;
  double normal_n;
  Vector3d tangential_n;  // on a
  bool slides;
};
bool earlier(const Known& x, const Known& y) { return std::pair(x.a, x.b) < std::pair(y.a, y.b); }

std::vector<Known> known_contacts(const GrainState& s) {
  std::vector<Known> known;
  for (const GrainContact& c : contacts_of(s)) {
    const Vector3d tangential = c.force_n + c.normal_force_n * c.normal;
    Known k{s.ids[c.i], c.j < 0 ? c.j : s.ids[c.j], c.normal_force_n, tangential, c.slides};
    if (c.j >= 0 && k.b < k.a) {
      std::swap(k.a, k.b);
      k.tangential_n = -k.tangential_n;
    }
    known.push_back(k);
  }
  std::sort(known.begin(), known.end(), earlier);
  return known;
}

class Sums {
 public:
  Sums(const GrainState& before, const GrainState& after, const std::vector<Vector3d>& turned)
      : from_(placed(before)),
        to_(placed(after)),
        from_box_(box_of_forces(before)),
        to_box_(box_of_forces(after)),
        turned_(turned),
        resultant_change_(turned.size(), Vector3d::Zero()),
        moment_change_(turned.size(), Vector3d::Zero()),
        volume_(from_box_.volume_m3()) {}

  void add(GrainWork& w, const Known* before, const Known* after) {
    const Known& any = before ? *before : *after;
    const ContactIncrement one =
        any.b < 0 ? at_wall(any, before, after) : between(any, before, after);
    if (before && after) {
      w.normal_part += one.normal_work / volume_;
      w.tangential_part += one.tangential_work / volume_;
    } else {
      w.non_permanent_part += (one.normal_work + one.tangential_work) / volume_;
      ++(before ? w.opened : w.closed);
    }
    w.fixed_frame += one.at_rest_work / volume_;
    w.contacts_turning += one.frame_turning / volume_;
    w.grains_turning += one.grain_turning / volume_;
    resultant_change_[any.a] += one.force_change_n;
    moment_change_[any.a] += one.moment_change_a_nm;
    if (any.b >= 0) {
      resultant_change_[any.b] -= one.force_change_n;
      moment_change_[any.b] += one.moment_change_b_nm;
    }
    w.contacts_before += before != nullptr;
    w.slides_after += after && after->slides;
  }

  /// −1/V Σ ΔR · Δx + ΔM · θ
  double out_of_balance() const {
    double sum = 0;
    for (std::size_t p = 0; p < turned_.size(); ++p)
      sum += resultant_change_[p].dot(to_[p].centre - from_[p].centre) +
             moment_change_[p].dot(turned_[p]);
    return -sum / volume_;
  }

 private:
  static ContactInstant instant(const Known* c, const Vector3d& branch) {
    if (!c) return {branch, 0, Vector3d::Zero()};
    return {branch, c->normal_n, c->tangential_n};
  }
  ContactIncrement between(const Known& c, const Known* before, const Known* after) const {
    return contact_increment(instant(before, from_[c.b].centre - from_[c.a].centre),
                             instant(after, to_[c.b].centre - to_[c.a].centre), from_[c.a].radius,
                             from_[c.b].radius, turned_[c.a], turned_[c.b]);
  }
  static double wall_gap(const GrainBox& box, const Placed& grain, int wall) {
    const int axis = wall / 2;
    return wall % 2 == 0 ? grain.centre[axis] - box.low_m[axis]
                         : box.high_m[axis] - grain.centre[axis];
  }
  ContactIncrement at_wall(const Known& c, const Known* before, const Known* after) const {
    const int wall = -1 - c.b;
    const double closer = wall_gap(from_box_, from_[c.a], wall) - wall_gap(to_box_, to_[c.a], wall);
    const double force = (after ? after->normal_n : 0) - (before ? before->normal_n : 0);
    ContactIncrement increment;
    increment.normal_work = increment.at_rest_work = force * closer;
    increment.force_change_n[wall / 2] = wall % 2 == 0 ? force : -force;
    return increment;
  }

  std::vector<Placed> from_, to_;
  GrainBox from_box_, to_box_;
  const std::vector<Vector3d>& turned_;
  std::vector<Vector3d> resultant_change_, moment_change_;
  double volume_;
};

void add_contacts(GrainWork& w, const GrainState& before, const GrainState& after,
                  const std::vector<Vector3d>& turned) {
  Sums sums(before, after, turned);
  const std::vector<Known> old = known_contacts(before), now = known_contacts(after);
  auto o = old.begin();
  auto n = now.begin();
  while (o != old.end() || n != now.end()) {
    const bool has_old = o != old.end() && (n == now.end() || !earlier(*n, *o));
    const bool has_new = n != now.end() && (o == old.end() || !earlier(*o, *n));
    sums.add(w, has_old ? &*o : nullptr, has_new ? &*n : nullptr);
    o += has_old;
    n += has_new;
  }
  w.out_of_balance = sums.out_of_balance();
}

void add_walls(GrainWork& w, const GrainState& before, const GrainState& after) {
  const GrainBox from = box_of_forces(before), to = box_of_forces(after);
  w.strain = natural_strain(from, to);
  std::array<double, 3> stress{};
  double power = 0, volumetric = 0, stress_square = 0, strain_square = 0;
  for (int a = 0; a < 3; ++a) {
    const double low = after.walls.force_n[2 * a] - before.walls.force_n[2 * a],
                 high = after.walls.force_n[2 * a + 1] - before.walls.force_n[2 * a + 1];
    w.lagrangian += low * (to.low_m[a] - from.low_m[a]) - high * (to.high_m[a] - from.high_m[a]);
    stress[a] = wall_stress(before.walls, from, a);
    w.stress_change_pa[a] = wall_stress(after.walls, to, a) - stress[a];
    w.stress_part += w.stress_change_pa[a] * w.strain[a];
    w.transport_part += stress[a] * w.strain[a] * w.strain[a];
    power += stress[a] * w.strain[a];
    volumetric += w.strain[a];
    stress_square += w.stress_change_pa[a] * w.stress_change_pa[a];
    strain_square += w.strain[a] * w.strain[a];
  }
  w.lagrangian /= from.volume_m3();
  w.volume_part = -volumetric * power;
  const double norms = std::sqrt(stress_square * strain_square);
  w.normalised = norms > 0 ? w.stress_part / norms : 0;
}

}  // namespace

double GrainWork::non_permanent_share() const {
  if (contacts_before == 0) return 0;
  return static_cast<double>(opened + closed) / static_cast<double>(contacts_before);
}

GrainBox box_of_forces(const GrainState& state) {
  GrainBox box = state.box;
  for (int a = 0; a < 3; ++a) {
    const double growth = std::expm1(state.walls.strain_rate_per_s[a] * state.time_step_s);
    const double travel = 0.5 * box.length_m(a) * growth;
    box.low_m[a] -= travel;
    box.high_m[a] += travel;
  }
  return box;
}

GrainWork grain_work(const GrainState& before, const GrainState& after,
                     const std::vector<Vector3d>& turned) {
  if (before.grains.size() != after.grains.size() || turned.size() != before.grains.size())
    throw std::invalid_argument("second-order work: the states are not of one specimen");
  GrainWork w;
  add_walls(w, before, after);
  add_contacts(w, before, after, turned);
  w.kinetic_before_j = kinetic_energy(before);
  w.kinetic_after_j = kinetic_energy(after);
  return w;
}

}  // namespace triax::sim
