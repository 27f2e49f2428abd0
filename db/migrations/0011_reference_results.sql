-- Results that a laboratory reported without readings (AGS4): reference values, to compare tests with. Nothing here was
-- measured, reduced or judged by triax. A file that is imported again replaces its rows.

CREATE TABLE reference_results (
  id INTEGER PRIMARY KEY,
  source TEXT NOT NULL,                -- the file as it was named
  source_path TEXT NOT NULL,           -- the same from the root: what tells files apart
  project TEXT,
  imported_at TEXT NOT NULL,
  group_name TEXT NOT NULL,            -- TRET, TREG: effective stress; TRIT, TRIG: total stress
  line INTEGER NOT NULL,               -- of the file
  location TEXT,
  sample_reference TEXT,
  sample_type TEXT,
  sample_id TEXT,
  specimen_reference TEXT,
  sample_top_m REAL,
  specimen_depth_m REAL,
  test_type TEXT,
  condition TEXT,
  stage TEXT,
  diameter_mm REAL,
  height_mm REAL,
  initial_water_content_pct REAL,
  final_water_content_pct REAL,
  bulk_density_Mg_m3 REAL,
  dry_density_Mg_m3 REAL,
  b_value REAL,
  back_pressure_kPa REAL,
  consolidation_pressure_kPa REAL,     -- effective, at the start of shear
  cell_pressure_kPa REAL,              -- total, during shear
  initial_pore_pressure_kPa REAL,      -- at the start of shear
  q_kPa REAL,                          -- from here on at failure
  pore_pressure_kPa REAL,
  axial_strain_pct REAL,
  volumetric_strain_pct REAL,
  undrained_strength_kPa REAL,
  failure_mode TEXT,
  cohesion_kPa REAL,                   -- of all stages together; effective in TRET and TREG
  friction_angle_deg REAL,
  failure_criterion TEXT,
  remarks TEXT,
  p_eff_kPa REAL,                      -- at failure, from the ones above: cell - u + q/3
  s_eff_kPa REAL,                      -- cell - u + q/2
  t_kPa REAL,                          -- q/2
  last_bits INTEGER
) STRICT;
CREATE INDEX reference_results_by_source ON reference_results (source_path);
