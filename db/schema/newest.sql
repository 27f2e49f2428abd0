-- SPDX-License-Identifier: GPL-3.0-or-later
-- Written by tools/schema from db/migrations: not to be edited.
CREATE TABLE tests (
  id INTEGER PRIMARY KEY CHECK (id BETWEEN 1 AND 2147483647),
  name TEXT NOT NULL,
  origin TEXT NOT NULL CHECK (origin IN ('recorded', 'simulated')),
  programme TEXT,
  source TEXT,
  dialect TEXT,
  seed INTEGER,              -- from 0 on
  status TEXT NOT NULL CHECK (status IN ('running', 'complete', 'interrupted')),
  stored_at TEXT NOT NULL, -- ISO 8601, UTC
  has_time INTEGER NOT NULL CHECK (has_time IN (0, 1)),
  columns TEXT NOT NULL,     -- headings of what the record holds, separated by commas
  readings INTEGER,          -- NULL while the test runs
  test_id INTEGER GENERATED ALWAYS AS (id) VIRTUAL, test TEXT GENERATED ALWAYS AS (name) VIRTUAL, axis TEXT
  GENERATED ALWAYS AS (CASE WHEN has_time THEN 'time' ELSE 'axial_strain' END) VIRTUAL, membrane_correction TEXT, digest TEXT) STRICT;
CREATE INDEX tests_by_name ON tests (name);
CREATE INDEX tests_running ON tests (status) WHERE status = 'running';
CREATE TABLE specimens (
  test_id INTEGER PRIMARY KEY REFERENCES tests (id) ON DELETE CASCADE,
  height_mm REAL,
  diameter_mm REAL,
  void_ratio REAL,
  consolidated_void_ratio REAL,
  consolidated_height_mm REAL,
  dry_mass_g REAL,
  specific_gravity REAL,
  membrane_thickness_mm REAL,
  membrane_modulus_kPa REAL,
  limit_friction_angle_deg REAL,
  material TEXT
) STRICT;
CREATE TABLE stage_references (
  test_id INTEGER NOT NULL REFERENCES tests (id) ON DELETE CASCADE,
  stage INTEGER NOT NULL,
  void_ratio REAL,
  area_m2 REAL,
  PRIMARY KEY (test_id, stage)
) STRICT, WITHOUT ROWID;
CREATE TABLE scans (
  id INTEGER PRIMARY KEY,
  time_s REAL,
  stage INTEGER NOT NULL,
  axial_displacement_mm REAL,
  axial_force_kN REAL,
  cell_pressure_kPa REAL,
  back_pressure_kPa REAL,
  pore_pressure_kPa REAL,
  back_volume_mm3 REAL,
  cell_volume_mm3 REAL,
  axial_strain REAL,
  volumetric_strain REAL,
  q_Pa REAL,
  p_eff_Pa REAL,
  last_bits INTEGER          -- where the numbers above do not give the last bit (db/scan_codec.hpp)
) STRICT;
CREATE TABLE scan_details (
  id INTEGER PRIMARY KEY,
  given_axial_strain REAL,
  given_radial_strain REAL,
  given_volumetric_strain REAL,
  given_shear_strain REAL,
  given_axial_stress_kPa REAL,
  given_radial_stress_kPa REAL,
  given_effective_axial_stress_kPa REAL,
  given_effective_radial_stress_kPa REAL,
  given_deviator_stress_kPa REAL,
  given_mean_effective_stress_kPa REAL,
  given_stress_ratio REAL,
  given_excess_pore_pressure_kPa REAL,
  given_void_ratio REAL,
  given_current_area_mm2 REAL,
  given_last_bits INTEGER,
  state_radial_strain REAL,
  state_void_ratio REAL,
  state_area_m2 REAL,
  state_effective_axial_stress_Pa REAL,
  state_effective_radial_stress_Pa REAL,
  state_pore_pressure_Pa REAL,
  state_missing INTEGER NOT NULL -- bit i: the i-th of the state_ columns is unknown, whatever follows
) STRICT;
CREATE TABLE work_points (
  id INTEGER PRIMARY KEY,
  time_s REAL,
  small_strain REAL,
  eulerian REAL,
  semi_lagrangian REAL,
  normalised REAL,
  normalised_error REAL,
  window_readings INTEGER NOT NULL
, axial_strain_path REAL) STRICT;
CREATE TABLE events (
  id INTEGER PRIMARY KEY,
  test_id INTEGER NOT NULL REFERENCES tests (id) ON DELETE CASCADE,
  reading INTEGER NOT NULL,
  time_s REAL,
  kind TEXT NOT NULL,
  detail TEXT NOT NULL
, noticed_reading INTEGER, noticed_time_s REAL) STRICT;
CREATE INDEX events_by_test ON events (test_id);
CREATE TABLE consolidations (
  test_id INTEGER PRIMARY KEY REFERENCES tests (id) ON DELETE CASCADE,
  p_eff_kPa REAL,
  b_value REAL,
  void_ratio REAL,
  height_mm REAL,
  diameter_mm REAL
) STRICT;
CREATE TABLE instants (
  test_id INTEGER NOT NULL REFERENCES tests (id) ON DELETE CASCADE,
  kind TEXT NOT NULL CHECK (kind IN ('peak', 'onset')),
  reading INTEGER NOT NULL,
  time_s REAL,
  axial_strain REAL,
  q_kPa REAL,
  p_eff_kPa REAL,
  pore_pressure_kPa REAL,
  PRIMARY KEY (test_id, kind)
) STRICT, WITHOUT ROWID;
CREATE TABLE truths (
  test_id INTEGER PRIMARY KEY REFERENCES tests (id) ON DELETE CASCADE,
  lost_sustainability INTEGER NOT NULL CHECK (lost_sustainability IN (0, 1)),
  time_s REAL,
  axial_strain REAL,
  q_kPa REAL,
  p_eff_kPa REAL,
  pore_pressure_kPa REAL
) STRICT;
CREATE TABLE checks (
  id INTEGER PRIMARY KEY,
  test_id INTEGER NOT NULL REFERENCES tests (id) ON DELETE CASCADE,
  name TEXT NOT NULL,
  measured REAL,
  limit_value REAL,
  ok INTEGER NOT NULL CHECK (ok IN (0, 1)),
  note TEXT
) STRICT;
CREATE INDEX checks_by_test ON checks (test_id);
CREATE TABLE warnings (
  id INTEGER PRIMARY KEY,
  test_id INTEGER NOT NULL REFERENCES tests (id) ON DELETE CASCADE,
  found TEXT NOT NULL CHECK (found IN ('at_start', 'at_end')),
  line INTEGER,
  text TEXT NOT NULL
) STRICT;
CREATE INDEX warnings_by_test ON warnings (test_id);
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
CREATE VIEW peaks AS
SELECT
  t.id AS test_id, t.name AS test, t.origin, i.reading, i.time_s, i.axial_strain, i.q_kPa,
  i.p_eff_kPa, i.pore_pressure_kPa, i.q_kPa / i.p_eff_kPa AS eta
FROM tests t
JOIN instants i ON i.test_id = t.id AND i.kind = 'peak';
CREATE TABLE "stages" (
  test_id INTEGER NOT NULL REFERENCES tests (id) ON DELETE CASCADE,
  number INTEGER NOT NULL,
  name TEXT NOT NULL,
  role TEXT NOT NULL
    CHECK (role IN ('unknown', 'saturation', 'b_check', 'consolidation', 'shear', 'hold')),
  drainage TEXT NOT NULL CHECK (drainage IN ('unknown', 'open', 'closed')),
  control TEXT NOT NULL CHECK (control IN ('unknown', 'displacement', 'load', 'constant_q')),
  strain_path_R REAL,        -- d eps_1 + 2 R d eps_3 = 0 is prescribed
  PRIMARY KEY (test_id, number)
) STRICT;
CREATE TABLE run_aways (
  test_id INTEGER NOT NULL REFERENCES tests (id) ON DELETE CASCADE,
  number INTEGER NOT NULL CHECK (number >= 1),
  start_s REAL NOT NULL,     -- test time, as the other two
  largest_kinetic_energy_J REAL CHECK (largest_kinetic_energy_J >= 0),
  largest_at_s REAL CHECK (largest_at_s >= start_s),
  kinetic_energy_J REAL,     -- that the specimen set free until Eq. (5) was compared
  second_order_work_J REAL,
  expected_ratio REAL,       -- of kinetic energy to minus half the work: 1 past a peak, 2/3 from one
  end_s REAL CHECK (end_s >= start_s), -- NULL: it still ran when the test ended
  ending TEXT,
  PRIMARY KEY (test_id, number)
) STRICT, WITHOUT ROWID;
CREATE TABLE sweep_members (
  test_id INTEGER NOT NULL REFERENCES tests (id) ON DELETE CASCADE,
  sweep TEXT NOT NULL,
  place INTEGER NOT NULL CHECK (place >= 1), -- of the test in the order of the sweep
  position INTEGER NOT NULL CHECK (position >= 1), -- of the key in the order it was asked for
  key TEXT NOT NULL,
  value ANY NOT NULL,        -- a number where the programme holds a number
  PRIMARY KEY (test_id, key)
) STRICT, WITHOUT ROWID;
CREATE INDEX sweep_members_by_sweep ON sweep_members (sweep, place);
CREATE TABLE grain_runs (
  id INTEGER PRIMARY KEY,
  name TEXT NOT NULL,
  origin TEXT NOT NULL DEFAULT 'simulated' CHECK (origin = 'simulated'),
  source TEXT NOT NULL,      -- file of the programme
  programme TEXT NOT NULL,   -- its text
  settings TEXT,             -- KEY=VALUE that were put in place of the programme's own, a line each
  state_file TEXT,           -- of a state or a packing; NULL: the specimen was made
  status TEXT NOT NULL CHECK (status IN ('running', 'complete', 'interrupted')),
  recorded_at TEXT NOT NULL, -- ISO 8601, UTC
  grains INTEGER NOT NULL,
  seed INTEGER,
  compaction_friction_deg REAL,
  compactions INTEGER,       -- made to find it
  stiffness_reading TEXT NOT NULL CHECK (stiffness_reading IN ('in_series', 'literal')),
  stiffness_over_diameter_MPa REAL NOT NULL,
  tangential_ratio REAL NOT NULL,
  friction_angle_deg REAL NOT NULL,
  density_kg_per_m3 REAL NOT NULL,
  damping REAL NOT NULL,
  time_step_s REAL NOT NULL,
  porosity REAL NOT NULL,
  void_ratio REAL NOT NULL,
  coordination REAL NOT NULL, -- floating grains included
  floating_grains INTEGER NOT NULL,
  grains_outside INTEGER NOT NULL,
  smallest_grain_mm REAL, median_grain_mm REAL, largest_grain_mm REAL, compaction_pressure_kPa REAL, porosity_wanted REAL, last_bits INTEGER) STRICT;
CREATE TABLE grain_stages (
  run_id INTEGER NOT NULL REFERENCES grain_runs (id) ON DELETE CASCADE,
  number INTEGER NOT NULL CHECK (number >= 1),
  name TEXT NOT NULL,
  action TEXT NOT NULL,
  started_from TEXT NOT NULL,
  strain_path_R REAL,        -- d eps_1 + 2 R d eps_3 = 0
  ending TEXT NOT NULL,
  at_rest INTEGER CHECK (at_rest IN (0, 1)),
  porosity REAL NOT NULL,    -- at the end, as all that follows
  coordination REAL NOT NULL,
  floating_grains INTEGER NOT NULL,
  axial_stress_kPa REAL NOT NULL,
  radial_stress_kPa REAL NOT NULL,
  unbalanced REAL NOT NULL,
  kinetic_energy_J REAL NOT NULL,
  engine_steps INTEGER NOT NULL,
  wall_clock_s REAL, axial_strain_at_start REAL, radial_strain_at_start REAL, last_bits INTEGER,         -- NULL: put together from pieces
  PRIMARY KEY (run_id, number)
) STRICT, WITHOUT ROWID;
CREATE TABLE grain_points (
  run_id INTEGER NOT NULL,
  stage INTEGER NOT NULL,
  number INTEGER NOT NULL,
  time_s REAL NOT NULL,      -- of the engine
  axial_strain_pct REAL NOT NULL,
  radial_strain_pct REAL NOT NULL,
  volumetric_strain_pct REAL NOT NULL,
  axial_stress_kPa REAL NOT NULL,
  radial_stress_kPa REAL NOT NULL,
  p_kPa REAL NOT NULL,
  q_kPa REAL NOT NULL,
  path_stress_kPa REAL NOT NULL, -- sigma_1 - sigma_3/R
  kinetic_energy_J REAL NOT NULL, -- the most since the point before
  unbalanced REAL NOT NULL,
  porosity REAL NOT NULL,
  coordination REAL NOT NULL,
  sliding_pct REAL NOT NULL, last_bits INTEGER,
  PRIMARY KEY (run_id, stage, number),
  FOREIGN KEY (run_id, stage) REFERENCES grain_stages (run_id, number) ON DELETE CASCADE
) STRICT, WITHOUT ROWID;
CREATE TABLE grain_perturbations (
  run_id INTEGER NOT NULL,
  stage INTEGER NOT NULL,
  load_step_Pa REAL NOT NULL,
  kinetic_energy_J REAL NOT NULL,
  grains_hit INTEGER NOT NULL,
  largest_kinetic_energy_J REAL NOT NULL, floating_share REAL, seed INTEGER, last_bits INTEGER,
  PRIMARY KEY (run_id, stage),
  FOREIGN KEY (run_id, stage) REFERENCES grain_stages (run_id, number) ON DELETE CASCADE
) STRICT, WITHOUT ROWID;
CREATE TABLE grain_perturbation_points (
  run_id INTEGER NOT NULL,
  stage INTEGER NOT NULL,
  number INTEGER NOT NULL,
  time_s REAL NOT NULL,      -- of the engine, since the perturbation
  path_stress_kPa REAL NOT NULL,
  stress_share REAL NOT NULL, -- chi: path stress over that of the equilibrium
  p_kPa REAL NOT NULL,
  axial_strain_pct REAL NOT NULL,
  kinetic_energy_J REAL NOT NULL,
  unbalanced REAL NOT NULL, last_bits INTEGER,
  PRIMARY KEY (run_id, stage, number),
  FOREIGN KEY (run_id, stage) REFERENCES grain_stages (run_id, number) ON DELETE CASCADE
) STRICT, WITHOUT ROWID;
CREATE VIEW grain_peaks AS
WITH peaks AS (
  SELECT run_id, stage, max(path_stress_kPa) AS peak_path_stress_kPa, -- the row of the maximum
    number, axial_strain_pct, p_kPa, q_kPa
  FROM grain_points GROUP BY run_id, stage
)
SELECT r.id AS run_id, r.name AS run, r.origin, s.number AS stage, s.name AS stage_name, s.action,
  s.strain_path_R, k.peak_path_stress_kPa, k.axial_strain_pct AS at_axial_strain_pct,
  k.p_kPa, k.q_kPa, k.q_kPa / nullif(k.p_kPa, 0) AS eta,
  (SELECT e.path_stress_kPa FROM grain_points e WHERE e.run_id = s.run_id AND e.stage = s.number
   ORDER BY e.number DESC LIMIT 1) AS path_stress_at_end_kPa,
  (SELECT max(e.kinetic_energy_J) FROM grain_points e
   WHERE e.run_id = s.run_id AND e.stage = s.number) AS largest_kinetic_energy_J, s.ending
FROM grain_stages s
JOIN grain_runs r ON r.id = s.run_id
JOIN peaks k ON k.run_id = s.run_id AND k.stage = s.number
WHERE s.strain_path_R IS NOT NULL;
CREATE VIEW second_order_work AS
SELECT
  t.id AS test_id, t.name AS test, t.origin, t.axis, w.id & 4294967295 AS reading,
  w.time_s, w.axial_strain_path,
  CASE WHEN t.has_time THEN w.small_strain END AS small_strain_Pa_per_s2,
  CASE WHEN t.has_time THEN w.eulerian END AS eulerian_Pa_per_s2,
  CASE WHEN t.has_time THEN w.semi_lagrangian END AS semi_lagrangian_Pa_per_s2,
  CASE WHEN NOT t.has_time THEN w.small_strain END AS small_strain_Pa_per_strain2,
  CASE WHEN NOT t.has_time THEN w.eulerian END AS eulerian_Pa_per_strain2,
  CASE WHEN NOT t.has_time THEN w.semi_lagrangian END AS semi_lagrangian_Pa_per_strain2,
  w.normalised, w.normalised_error, w.window_readings
FROM tests t
JOIN work_points w ON w.id BETWEEN t.id << 32 AND t.id << 32 | 4294967295;
CREATE TABLE grain_measures (
  run_id INTEGER NOT NULL REFERENCES grain_runs (id) ON DELETE CASCADE,
  stage INTEGER NOT NULL CHECK (stage >= 0),
  moment TEXT NOT NULL CHECK (moment IN ('made', 'before', 'after')),
  wall_stress_1_kPa REAL,
  wall_stress_2_kPa REAL,
  wall_stress_3_kPa REAL,
  porosity REAL,
  void_ratio REAL,
  coordination REAL,
  kinetic_energy_J REAL,
  unbalanced REAL,
  grain_contacts INTEGER NOT NULL,
  wall_contacts INTEGER NOT NULL,
  sliding_contacts INTEGER NOT NULL,
  floating_grains INTEGER NOT NULL,
  grains_outside INTEGER NOT NULL,
  last_bits INTEGER NOT NULL,
  PRIMARY KEY (run_id, stage, moment)
) STRICT, WITHOUT ROWID;
CREATE TABLE grain_paths (
  run_id INTEGER NOT NULL,
  stage INTEGER NOT NULL,
  kind TEXT NOT NULL CHECK (kind IN ('isotropic', 'drained', 'strain_path')),
  R REAL NOT NULL,
  strain_rate_per_s REAL NOT NULL,
  load_rate_Pa_per_s REAL NOT NULL,
  samples INTEGER NOT NULL,
  last_bits INTEGER NOT NULL,
  PRIMARY KEY (run_id, stage),
  FOREIGN KEY (run_id, stage) REFERENCES grain_stages (run_id, number) ON DELETE CASCADE
) STRICT, WITHOUT ROWID;
CREATE TABLE grain_marks (
  run_id INTEGER NOT NULL,
  stage INTEGER NOT NULL,
  number INTEGER NOT NULL,
  name TEXT NOT NULL,
  passed INTEGER NOT NULL CHECK (passed IN (0, 1)),
  time_s REAL,
  axial_strain_pct REAL,
  radial_strain_pct REAL,
  volumetric_strain_pct REAL,
  axial_stress_kPa REAL,
  radial_stress_kPa REAL,
  p_kPa REAL,
  q_kPa REAL,
  path_stress_kPa REAL,
  kinetic_energy_J REAL,
  unbalanced REAL,
  porosity REAL,
  coordination REAL,
  sliding_pct REAL,
  last_bits INTEGER NOT NULL,
  PRIMARY KEY (run_id, stage, number),
  FOREIGN KEY (run_id, stage) REFERENCES grain_stages (run_id, number) ON DELETE CASCADE
) STRICT, WITHOUT ROWID;
CREATE TABLE grain_rests (
  run_id INTEGER NOT NULL,
  stage INTEGER NOT NULL,
  held TEXT NOT NULL CHECK (held IN ('walls', 'stresses')),
  engine_steps INTEGER NOT NULL,
  unbalanced REAL NOT NULL,
  stress_error_Pa REAL NOT NULL,
  path_stress_kPa REAL NOT NULL, -- at the end
  last_bits INTEGER NOT NULL,
  PRIMARY KEY (run_id, stage),
  FOREIGN KEY (run_id, stage) REFERENCES grain_stages (run_id, number) ON DELETE CASCADE
) STRICT, WITHOUT ROWID;
CREATE TABLE "criteria" (
  id INTEGER PRIMARY KEY,
  test_id INTEGER NOT NULL REFERENCES tests (id) ON DELETE CASCADE,
  name TEXT NOT NULL,
  detected INTEGER CHECK (detected IN (0, 1)),
  reading INTEGER,
  time_s REAL,
  eta REAL,
  evidence TEXT
, noticed_reading INTEGER, noticed_time_s REAL) STRICT;
CREATE INDEX criteria_by_test ON criteria (test_id);
CREATE TABLE record_notes ( -- all of what the preamble of a file says
  id INTEGER PRIMARY KEY,
  test_id INTEGER NOT NULL REFERENCES tests (id) ON DELETE CASCADE,
  label TEXT,
  text TEXT NOT NULL
) STRICT;
CREATE INDEX record_notes_by_test ON record_notes (test_id);
CREATE TABLE guesses ( -- what the record does not say and was taken
  id INTEGER PRIMARY KEY,
  test_id INTEGER NOT NULL REFERENCES tests (id) ON DELETE CASCADE,
  what TEXT NOT NULL,
  taken TEXT NOT NULL,
  evidence TEXT NOT NULL,
  remedy TEXT NOT NULL -- options that say it instead
) STRICT;
CREATE INDEX guesses_by_test ON guesses (test_id);
CREATE INDEX tests_by_digest ON tests (digest);
CREATE TABLE tags (
  test_id INTEGER NOT NULL REFERENCES tests (id) ON DELETE CASCADE,
  tag TEXT NOT NULL CHECK (tag <> ''),
  PRIMARY KEY (test_id, tag)
) STRICT, WITHOUT ROWID;
CREATE INDEX tags_by_tag ON tags (tag);
CREATE VIEW counted_tests AS
SELECT t.id AS test_id, t.name AS test, t.origin
FROM tests t
WHERE NOT EXISTS (
  SELECT 1 FROM tests other
  WHERE other.digest = t.digest
    AND (other.status = 'complete', other.id) > (t.status = 'complete', t.id)
);
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
CREATE TABLE "verdicts" (
  test_id INTEGER PRIMARY KEY REFERENCES tests (id) ON DELETE CASCADE,
  kind TEXT CHECK (kind IN ('none', 'limited', 'partial', 'flow', 'cyclic_mobility')),
  inside_limit_surface INTEGER CHECK (inside_limit_surface IN (0, 1)),
  second_order_work_normalised REAL,
  second_order_work_error REAL,
  limit_stress_ratio REAL,
  limit_source TEXT,
  judged_until_reading INTEGER,
  judged_until_reason TEXT,
  judged_from_reading INTEGER,
  strength_lost REAL,           -- share of q at the onset
  nearest_reading INTEGER,      -- where second-order work was least
  nearest_normalised REAL,
  nearest_error REAL
, eta_low REAL, eta_high REAL, q_low_kPa REAL, q_high_kPa REAL, p_eff_low_kPa REAL, p_eff_high_kPa REAL, noticed_reading INTEGER, noticed_time_s REAL) STRICT;
CREATE TABLE cyclic_loadings (
  test_id INTEGER PRIMARY KEY REFERENCES tests (id) ON DELETE CASCADE,
  cycles REAL NOT NULL,                    -- two turns of q each
  q_low_kPa REAL NOT NULL,                 -- means of the turns
  q_high_kPa REAL NOT NULL,
  cyclic_stress_ratio REAL,                -- (q_high - q_low)/2 over 2 p'0
  largest_pore_pressure_ratio REAL,        -- r_u
  largest_double_amplitude REAL,           -- of the axial strain within a cycle
  liquefied_reading INTEGER,               -- r_u of 0.95
  liquefied_cycle INTEGER,
  double_amplitude_reading INTEGER,        -- of 5 %
  double_amplitude_cycle INTEGER
) STRICT;
CREATE TABLE leases (
  writer TEXT PRIMARY KEY,          -- random
  test_id INTEGER UNIQUE REFERENCES tests (id) ON DELETE CASCADE,
  run_id INTEGER UNIQUE REFERENCES grain_runs (id) ON DELETE CASCADE,
  last_sign_of_life TEXT NOT NULL,  -- ISO 8601, UTC, by the clock of the writer
  CHECK ((test_id IS NULL) <> (run_id IS NULL))
) STRICT, WITHOUT ROWID;
CREATE VIEW seen_leases AS
SELECT writer, test_id, run_id, last_sign_of_life, silent_s, abs(silent_s) < 20 AS alive
FROM (
  SELECT *, strftime('%s', 'now') - strftime('%s', last_sign_of_life) AS silent_s FROM leases
);
CREATE VIEW seen_tests AS
SELECT t.id AS test_id, t.name AS test, t.origin,
  CASE WHEN t.status = 'running' AND NOT coalesce(l.alive, 0) THEN 'interrupted' ELSE t.status END
    AS status,
  l.last_sign_of_life, l.silent_s,
  coalesce(t.readings, (SELECT count(*) FROM scans c WHERE c.id BETWEEN t.id << 32 AND t.id << 32 | 4294967295))
    AS readings  -- so far
FROM tests t LEFT JOIN seen_leases l ON l.test_id = t.id;
CREATE VIEW seen_grain_runs AS
SELECT r.id AS run_id, r.name AS run, r.origin,
  CASE WHEN r.status = 'running' AND NOT coalesce(l.alive, 0) THEN 'interrupted' ELSE r.status END
    AS status,
  l.last_sign_of_life, l.silent_s
FROM grain_runs r LEFT JOIN seen_leases l ON l.run_id = r.id;
CREATE VIEW unfinished_tests AS
SELECT
  t.id AS test_id, t.name AS test, t.origin, s.status, t.stored_at, s.readings, s.last_sign_of_life, s.silent_s
FROM tests t JOIN seen_tests s ON s.test_id = t.id
WHERE t.status <> 'complete';
CREATE VIEW sweep_results AS
SELECT
  m.sweep, m.place, m.test_id, t.name AS test, t.origin, s.status, t.seed, m.key, m.value,
  c.kind, c.time_s, c.eta, c.phi_mob_deg,
  u.lost_sustainability AS truly_lost_sustainability, u.time_s AS true_time_s,
  u.q_kPa / u.p_eff_kPa AS true_eta
FROM sweep_members m
JOIN tests t ON t.id = m.test_id
JOIN seen_tests s ON s.test_id = m.test_id
LEFT JOIN collapses c ON c.test_id = m.test_id
LEFT JOIN truths u ON u.test_id = m.test_id;
CREATE TABLE "grain_probes" (
  run_id INTEGER NOT NULL,
  stage INTEGER NOT NULL,
  number INTEGER NOT NULL CHECK (number >= 0),
  alpha_deg REAL,
  norm_kPa REAL,
  at_rest INTEGER NOT NULL CHECK (at_rest IN (0, 1)),
  axial_strain REAL NOT NULL,
  radial_strain REAL NOT NULL,
  work_lagrangian_J_per_m3 REAL NOT NULL,  -- Eq. (7)
  work_eulerian_J_per_m3 REAL NOT NULL,    -- Eq. (10), the sum of the next three
  stress_part_J_per_m3 REAL NOT NULL,
  volume_part_J_per_m3 REAL NOT NULL,
  transport_part_J_per_m3 REAL NOT NULL,
  work_microscopic_J_per_m3 REAL NOT NULL, -- Eq. (11)
  work_fixed_frame_J_per_m3 REAL NOT NULL, -- the sum over contacts in a frame at rest, grains as points
  boundary_part_J_per_m3 REAL,             -- of Eq. (22)
  normalised_work REAL NOT NULL,
  sliding_pct REAL NOT NULL,
  non_permanent_pct REAL NOT NULL,
  largest_kinetic_energy_J REAL NOT NULL,
  engine_steps INTEGER NOT NULL,
  stopped INTEGER CHECK (stopped IN (0, 1)),
  axial_stress_kPa REAL, -- the increment that was reached
  radial_stress_kPa REAL,
  normal_part_J_per_m3 REAL, -- the next three sum up to work_microscopic
  tangential_part_J_per_m3 REAL,
  non_permanent_part_J_per_m3 REAL,
  contacts_before INTEGER,
  contacts_opened INTEGER,
  contacts_closed INTEGER,
  unbalanced REAL,
  stress_error_Pa REAL,
  last_bits INTEGER,
  PRIMARY KEY (run_id, stage, number),
  FOREIGN KEY (run_id, stage) REFERENCES grain_stages (run_id, number) ON DELETE CASCADE
) STRICT, WITHOUT ROWID;
CREATE TABLE "grain_roses" (
  run_id INTEGER NOT NULL,
  stage INTEGER NOT NULL,
  norm_kPa REAL, -- NULL of strain probes
  axial_stress_kPa REAL NOT NULL,
  radial_stress_kPa REAL NOT NULL,
  norm_strain REAL, -- NULL of stress probes
  probed TEXT NOT NULL CHECK (probed IN ('stress', 'strain')),
  last_bits INTEGER NOT NULL,
  PRIMARY KEY (run_id, stage),
  FOREIGN KEY (run_id, stage) REFERENCES grain_stages (run_id, number) ON DELETE CASCADE
) STRICT, WITHOUT ROWID;
CREATE TABLE grain_gaps (
  run_id INTEGER NOT NULL,
  stage INTEGER NOT NULL,
  number INTEGER NOT NULL, -- of the probe
  contacts_turning_J_per_m3 REAL,
  grains_turning_J_per_m3 REAL,
  out_of_balance_J_per_m3 REAL,
  left_J_per_m3 REAL,
  last_bits INTEGER NOT NULL,
  PRIMARY KEY (run_id, stage, number),
  FOREIGN KEY (run_id, stage, number) REFERENCES grain_probes (run_id, stage, number) ON DELETE CASCADE
) STRICT, WITHOUT ROWID;
CREATE TABLE grain_energies (
  run_id INTEGER NOT NULL,
  stage INTEGER NOT NULL,
  number INTEGER NOT NULL, -- of the probe; 0 of a stage without probes
  walls_J REAL,
  elastic_start_J REAL,
  elastic_end_J REAL,
  kinetic_start_J REAL,
  kinetic_end_J REAL,
  friction_J REAL,
  damping_J REAL,
  stopped_J REAL,
  error_J REAL,
  last_bits INTEGER NOT NULL,
  PRIMARY KEY (run_id, stage, number),
  FOREIGN KEY (run_id, stage) REFERENCES grain_stages (run_id, number) ON DELETE CASCADE
) STRICT, WITHOUT ROWID;
CREATE TABLE grain_momenta (
  run_id INTEGER NOT NULL,
  stage INTEGER NOT NULL,
  number INTEGER NOT NULL,
  axis TEXT NOT NULL CHECK (axis IN ('x', 'y', 'z')),
  walls_kg_m_per_s REAL,
  damping_kg_m_per_s REAL,
  stopped_kg_m_per_s REAL,
  start_kg_m_per_s REAL,
  end_kg_m_per_s REAL,
  last_bits INTEGER NOT NULL,
  PRIMARY KEY (run_id, stage, number, axis),
  FOREIGN KEY (run_id, stage) REFERENCES grain_stages (run_id, number) ON DELETE CASCADE
) STRICT, WITHOUT ROWID;
CREATE VIEW collapses AS
SELECT
  t.id AS test_id, t.name AS test, t.origin, t.programme, t.status,
  v.kind, v.inside_limit_surface,
  o.reading, o.time_s, o.axial_strain, o.q_kPa, o.p_eff_kPa, o.pore_pressure_kPa,
  o.q_kPa / o.p_eff_kPa AS eta,
  degrees(asin(CASE WHEN o.q_kPa / o.p_eff_kPa >= 0 THEN 1 ELSE -1 END
               * 3 * (o.q_kPa / o.p_eff_kPa) / (6 + o.q_kPa / o.p_eff_kPa))) AS phi_mob_deg,
  v.eta_low, v.eta_high, v.q_low_kPa, v.q_high_kPa, v.p_eff_low_kPa, v.p_eff_high_kPa,
  v.noticed_reading, v.noticed_time_s,
  v.second_order_work_normalised, v.second_order_work_error, v.strength_lost, v.limit_stress_ratio, v.limit_source,
  v.judged_from_reading, v.judged_until_reading, v.judged_until_reason, v.nearest_reading, v.nearest_normalised,
  v.nearest_error
FROM tests t
JOIN verdicts v ON v.test_id = t.id
LEFT JOIN instants o ON o.test_id = t.id AND o.kind = 'onset';
CREATE VIEW collapse_points AS
SELECT
  c.programme AS type_of_test, c.test, k.p_eff_kPa AS p0_eff_kPa,
  coalesce(k.void_ratio, b.consolidated_void_ratio, b.void_ratio) AS void_ratio,
  c.phi_mob_deg, c.eta, c.eta_low, c.eta_high, c.kind, c.inside_limit_surface, c.origin, c.test_id
FROM counted_tests t
JOIN collapses c ON c.test_id = t.test_id
LEFT JOIN consolidations k ON k.test_id = c.test_id
LEFT JOIN specimens b ON b.test_id = c.test_id
WHERE c.kind NOT IN ('none', 'cyclic_mobility');
CREATE TABLE outlooks (
  test_id INTEGER NOT NULL REFERENCES tests (id) ON DELETE CASCADE,
  level TEXT NOT NULL CHECK (level IN ('approaching', 'imminent')),
  reading INTEGER NOT NULL,   -- the last that had been taken
  time_s REAL,
  eta_forecast REAL NOT NULL, -- at the onset to come
  eta_low REAL NOT NULL,      -- its 90 % interval
  eta_high REAL NOT NULL,
  left_quantity TEXT,         -- what drives the test: deviator_stress_kPa, axial_strain, mean_effective_stress_kPa
  left_value REAL,            -- of it, in its unit (axial strain as a ratio)
  left_time_s REAL,           -- at the present rate
  PRIMARY KEY (test_id, level)
) STRICT;
CREATE TABLE forecast_points (
  id INTEGER PRIMARY KEY,
  time_s REAL,
  eta_forecast REAL NOT NULL, -- at the onset to come
  eta_low REAL NOT NULL,      -- its 90 % interval
  eta_high REAL NOT NULL,
  left_quantity TEXT,         -- what drives the test: deviator_stress_kPa, axial_strain, mean_effective_stress_kPa
  left_value REAL,            -- of it, in its unit (axial strain as a ratio)
  left_time_s REAL            -- at the present rate
) STRICT;
CREATE VIEW forecasts AS
SELECT
  t.id AS test_id, t.name AS test, t.origin, f.id & 4294967295 AS reading, f.time_s, s.stage,
  s.q_Pa / s.p_eff_Pa AS eta, f.eta_forecast, f.eta_low, f.eta_high,
  f.left_quantity, f.left_value, f.left_time_s
FROM tests t
JOIN forecast_points f ON f.id BETWEEN t.id << 32 AND t.id << 32 | 4294967295
LEFT JOIN scans s ON s.id = f.id;
CREATE TABLE guards (
  test_id INTEGER PRIMARY KEY REFERENCES tests (id) ON DELETE CASCADE,
  level TEXT NOT NULL CHECK (level IN ('approaching', 'imminent', 'lost')), -- that it acted on
  done TEXT NOT NULL,              -- in words
  reading INTEGER NOT NULL,        -- at which it acted, as the next five
  time_s REAL,
  axial_strain REAL,
  q_kPa REAL,
  p_eff_kPa REAL,
  second_order_work_normalised REAL,
  last_axial_strain REAL,          -- at the end of the test
  without_kind TEXT CHECK (without_kind IN ('none', 'limited', 'partial', 'flow', 'cyclic_mobility')), -- empty: not run
  without_last_axial_strain REAL,
  without_lost_reading INTEGER,    -- after which the specimen ran away
  without_lost_time_s REAL
) STRICT;
