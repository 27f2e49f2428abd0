// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What a laboratory reported of a triaxial test: results without readings, to compare with.
#include <cstdint>
#include <optional>
#include <string>

namespace triax::lab {

/// Where a specimen came from, as the laboratory names it. Empty and nullopt: not said.
struct ReferenceSpecimen {
  std::string location;  ///< the borehole, trial pit, ...
  std::string sample_reference;
  std::string sample_type;
  std::string sample_id;
  std::string specimen_reference;
  std::optional<double> sample_top_m;      ///< below ground level
  std::optional<double> specimen_depth_m;  ///< to its top

  friend bool operator==(const ReferenceSpecimen&, const ReferenceSpecimen&) = default;
};

/// One test, or one stage of a test with several. SI; compression positive. What the laboratory
/// left blank is unknown.
struct ReferenceResult {
  std::string group;      ///< "TRET": effective stress, "TRIT": total stress; "TREG", "TRIG" where
                          ///< only the general part is there
  std::int64_t line = 0;  ///< in the file
  ReferenceSpecimen specimen;
  std::string test_type;  ///< "CIUC", "UU", ...
  std::string condition;  ///< undisturbed, remoulded, ...
  std::string stage;      ///< the number of the test or stage

  std::optional<double> diameter_m, height_m;
  std::optional<double> initial_water_content, final_water_content;  ///< of the dry mass
  std::optional<double> bulk_density_kg_m3, dry_density_kg_m3;       ///< initial ones
  std::optional<double> b_value;
  std::optional<double> back_pressure_pa;
  std::optional<double> consolidation_pressure_pa;  ///< effective, at the start of shear
  std::optional<double> cell_pressure_pa;           ///< total, during shear
  std::optional<double> initial_pore_pressure_pa;   ///< at the start of shear

  // At failure, by the laboratory's own criterion.
  std::optional<double> q_pa;
  std::optional<double> pore_pressure_pa;
  std::optional<double> axial_strain, volumetric_strain;
  std::optional<double> undrained_strength_pa;
  std::string failure_mode;

  // Of all stages and specimens of the test together; effective ones in TRET and TREG.
  std::optional<double> cohesion_pa, friction_angle_rad;
  std::string failure_criterion;
  std::string remarks;

  /// q with its sign: an extension test (CADE, CAUE, CIDE, ...) of which a laboratory gives the
  /// magnitude is unknown here.
  std::optional<double> signed_q_pa() const;
  /// p′ = σ₃ − u + q/3 at failure
  std::optional<double> p_eff_pa() const;
  /// s′ = (σ₁′ + σ₃′)/2 = σ₃ − u + q/2 at failure
  std::optional<double> s_eff_pa() const;
  /// t = (σ₁ − σ₃)/2 = q/2 at failure
  std::optional<double> t_pa() const;
};

}  // namespace triax::lab
