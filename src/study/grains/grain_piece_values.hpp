// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The keys of a piece of a grains' rose and what they hold, once for writing and reading:
// visit(key, member) for each member, in the order of the file.
#include "src/study/grains/grain_piece.hpp"

namespace triax::study {

template <class Visit, class Specimen>
void visit_specimen(Visit& v, Specimen& s) {
  v("programme", s.programme), v("stage", s.stage), v("fingerprint", s.fingerprint);
  v("grains", s.grains);
  v("axial_stress_Pa", s.stress.axial), v("radial_stress_Pa", s.stress.radial);
  auto& m = s.measures;
  v("kinetic_energy_J", m.kinetic_energy_j), v("unbalanced", m.unbalanced);
  v("void_ratio", m.void_ratio), v("porosity", m.porosity), v("coordination", m.coordination);
  v("grain_contacts", m.grain_contacts), v("wall_contacts", m.wall_contacts);
  v("sliding_contacts", m.sliding_contacts), v("floating_grains", m.floating_grains);
  v("grains_outside", m.grains_outside), v("wall_stress_Pa", m.wall_stress_pa);
  v("stress_Pa", m.stress_pa);
}

template <class Visit, class Specimen>
void visit_probing(Visit& v, Specimen& s) {
  auto& p = s.probing;
  v("directions", s.directions), v("kind", p.kind), v("norm_Pa", p.norm_pa);
  v("norm_strain", p.norm_strain), v("ramp_steps", p.ramp_steps);
  v("unbalanced", p.unbalanced), v("stress_error_Pa", p.stress_error_pa);
  v("check_every", p.check_every), v("most_steps", p.most_steps);
  v("sample_every", p.sample_every), v("speed_limit_m_per_s", p.speed_limit_m_per_s);
}

template <class Visit, class Probe>
void visit_probe(Visit& v, Probe& p) {
  v("angle_rad", p.angle), v("norm_Pa", p.norm_pa), v("norm_strain", p.norm_strain);
  v("at_rest", p.at_rest);
  v("axial_stress_Pa", p.stress.axial), v("radial_stress_Pa", p.stress.radial);
  v("axial_strain", p.strain.axial), v("radial_strain", p.strain.radial);
  auto& w = p.work;
  v("w2_lagrangian_J_per_m3", w.lagrangian), v("w2_stress_part_J_per_m3", w.stress_part);
  v("w2_volume_part_J_per_m3", w.volume_part), v("w2_transport_part_J_per_m3", w.transport_part);
  v("w2_normalised", w.normalised), v("w2_normal_part_J_per_m3", w.normal_part);
  v("w2_tangential_part_J_per_m3", w.tangential_part);
  v("w2_non_permanent_part_J_per_m3", w.non_permanent_part);
  v("w2_fixed_frame_J_per_m3", w.fixed_frame), v("boundary_part_J_per_m3", w.boundary_part);
  v("w2_contacts_turning_J_per_m3", w.contacts_turning);
  v("w2_grains_turning_J_per_m3", w.grains_turning);
  v("w2_out_of_balance_J_per_m3", w.out_of_balance);
  v("kinetic_before_J", w.kinetic_before_j), v("kinetic_after_J", w.kinetic_after_j);
  v("contacts_before", w.contacts_before), v("opened", w.opened), v("closed", w.closed);
  v("slides_after", w.slides_after);
  v("stress_change_Pa", w.stress_change_pa), v("strain", w.strain);
  v("most_kinetic_J", p.most_kinetic_j), v("sliding_share", p.sliding_share);
  v("steps", p.steps), v("end_unbalanced", p.unbalanced);
  v("end_stress_error_Pa", p.stress_error_pa);
  auto& l = p.ledger;
  v("walls_J", l.walls_j), v("friction_J", l.friction_j), v("damping_J", l.damping_j);
  v("stopped_J", l.stopped_j), v("elastic_start_J", l.elastic_start_j);
  v("elastic_end_J", l.elastic_end_j), v("kinetic_start_J", l.kinetic_start_j);
  v("kinetic_end_J", l.kinetic_end_j), v("walls_kg_m_per_s", l.walls_impulse);
  v("damping_kg_m_per_s", l.damping_impulse), v("stopped_kg_m_per_s", l.stopped_impulse);
  v("momentum_start_kg_m_per_s", l.momentum_start);
  v("momentum_end_kg_m_per_s", l.momentum_end);
}

}  // namespace triax::study
