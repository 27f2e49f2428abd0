-- What users ask, in units of the field. Filters on test_id become ranges of scans.id.

CREATE VIEW readings AS
SELECT
  t.id AS test_id, t.name AS test, t.origin, s.id & 4294967295 AS reading,
  s.time_s, s.stage,
  s.axial_displacement_mm, s.axial_force_kN, s.cell_pressure_kPa, s.back_pressure_kPa,
  s.pore_pressure_kPa, s.back_volume_mm3, s.cell_volume_mm3,
  d.given_axial_strain, d.given_radial_strain, d.given_volumetric_strain, d.given_shear_strain,
  d.given_axial_stress_kPa, d.given_radial_stress_kPa,
  d.given_effective_axial_stress_kPa, d.given_effective_radial_stress_kPa,
  d.given_deviator_stress_kPa, d.given_mean_effective_stress_kPa, d.given_stress_ratio,
  d.given_excess_pore_pressure_kPa, d.given_void_ratio, d.given_current_area_mm2
FROM tests t
JOIN scans s ON s.id BETWEEN t.id << 32 AND t.id << 32 | 4294967295
LEFT JOIN scan_details d ON d.id = s.id;

-- Bit 26 of last_bits says that the effective stresses follow from p' and q, not from the channels.
CREATE VIEW states AS
SELECT
  test_id, test, origin, reading, time_s, stage,
  axial_strain, radial_strain, volumetric_strain,
  2 * (axial_strain - radial_strain) / 3 AS shear_strain,
  void_ratio,
  area_m2 * 1e6 AS current_area_mm2,
  effective_axial_stress_Pa / 1000 AS effective_axial_stress_kPa,
  effective_radial_stress_Pa / 1000 AS effective_radial_stress_kPa,
  pore_pressure_Pa / 1000 AS pore_pressure_kPa,
  q_Pa / 1000 AS q_kPa,
  p_eff_Pa / 1000 AS p_eff_kPa,
  q_Pa / p_eff_Pa AS eta,
  degrees(asin(CASE WHEN q_Pa / p_eff_Pa >= 0 THEN 1 ELSE -1 END
               * 3 * (q_Pa / p_eff_Pa) / (6 + q_Pa / p_eff_Pa))) AS phi_mob_deg
FROM (
  SELECT
    t.id AS test_id, t.name AS test, t.origin, s.id & 4294967295 AS reading,
    s.time_s, s.stage, s.axial_strain, s.volumetric_strain, s.q_Pa, s.p_eff_Pa,
    CASE WHEN d.state_missing & 1 THEN NULL
         ELSE coalesce(d.state_radial_strain, (s.volumetric_strain - s.axial_strain) / 2)
    END AS radial_strain,
    CASE WHEN d.state_missing & 2 THEN NULL
         ELSE coalesce(d.state_void_ratio,
                       r.void_ratio - s.volumetric_strain * (1 + r.void_ratio))
    END AS void_ratio,
    CASE WHEN d.state_missing & 4 THEN NULL
         ELSE coalesce(d.state_area_m2,
                       r.area_m2 * (1 - s.volumetric_strain) / (1 - s.axial_strain))
    END AS area_m2,
    CASE WHEN d.state_missing & 8 THEN NULL
         WHEN d.state_effective_axial_stress_Pa IS NOT NULL THEN d.state_effective_axial_stress_Pa
         WHEN s.last_bits >> 26 & 1 THEN s.p_eff_Pa + 2 * s.q_Pa / 3
         ELSE s.cell_pressure_kPa * 1000 + s.q_Pa - s.pore_pressure_kPa * 1000
    END AS effective_axial_stress_Pa,
    CASE WHEN d.state_missing & 16 THEN NULL
         WHEN d.state_effective_radial_stress_Pa IS NOT NULL THEN d.state_effective_radial_stress_Pa
         WHEN s.last_bits >> 26 & 1 THEN s.p_eff_Pa - s.q_Pa / 3
         ELSE s.cell_pressure_kPa * 1000 - s.pore_pressure_kPa * 1000
    END AS effective_radial_stress_Pa,
    CASE WHEN d.state_missing & 32 THEN NULL
         ELSE coalesce(d.state_pore_pressure_Pa, s.pore_pressure_kPa * 1000)
    END AS pore_pressure_Pa
  FROM tests t
  JOIN scans s ON s.id BETWEEN t.id << 32 AND t.id << 32 | 4294967295
  LEFT JOIN scan_details d ON d.id = s.id
  LEFT JOIN stage_references r ON r.test_id = t.id AND r.stage = s.stage
);

-- Pa per square of the unit of progress: s, or unit of axial strain where tests.has_time = 0.
CREATE VIEW second_order_work AS
SELECT
  t.id AS test_id, t.name AS test, t.origin, w.id & 4294967295 AS reading, w.time_s,
  w.small_strain AS small_strain_Pa_per_progress2,
  w.eulerian AS eulerian_Pa_per_progress2,
  w.semi_lagrangian AS semi_lagrangian_Pa_per_progress2,
  w.normalised, w.normalised_error, w.window_readings
FROM tests t
JOIN work_points w ON w.id BETWEEN t.id << 32 AND t.id << 32 | 4294967295;

CREATE VIEW collapses AS
SELECT
  t.id AS test_id, t.name AS test, t.origin, t.programme, t.status,
  v.kind, v.inside_limit_surface,
  o.reading, o.time_s, o.axial_strain, o.q_kPa, o.p_eff_kPa, o.pore_pressure_kPa,
  o.q_kPa / o.p_eff_kPa AS eta,
  degrees(asin(CASE WHEN o.q_kPa / o.p_eff_kPa >= 0 THEN 1 ELSE -1 END
               * 3 * (o.q_kPa / o.p_eff_kPa) / (6 + o.q_kPa / o.p_eff_kPa))) AS phi_mob_deg,
  v.second_order_work_normalised, v.second_order_work_error, v.limit_stress_ratio, v.limit_source
FROM tests t
JOIN verdicts v ON v.test_id = t.id
LEFT JOIN instants o ON o.test_id = t.id AND o.kind = 'onset';

-- As the paper's Table 2: one row a test that collapsed.
CREATE VIEW collapse_points AS
SELECT
  c.programme AS type_of_test, c.test, k.p_eff_kPa AS p0_eff_kPa,
  coalesce(k.void_ratio, b.consolidated_void_ratio, b.void_ratio) AS void_ratio,
  c.phi_mob_deg, c.eta, c.kind, c.inside_limit_surface, c.origin, c.test_id
FROM collapses c
LEFT JOIN consolidations k ON k.test_id = c.test_id
LEFT JOIN specimens b ON b.test_id = c.test_id
WHERE c.kind <> 'none';

CREATE VIEW peaks AS
SELECT
  t.id AS test_id, t.name AS test, t.origin, i.reading, i.time_s, i.axial_strain, i.q_kPa,
  i.p_eff_kPa, i.pore_pressure_kPa, i.q_kPa / i.p_eff_kPa AS eta
FROM tests t
JOIN instants i ON i.test_id = t.id AND i.kind = 'peak';

CREATE VIEW unfinished_tests AS
SELECT
  t.id AS test_id, t.name AS test, t.origin, t.status, t.recorded_at,
  (SELECT count(*) FROM scans s WHERE s.id BETWEEN t.id << 32 AND t.id << 32 | 4294967295)
    AS readings
FROM tests t
WHERE t.status <> 'complete';
