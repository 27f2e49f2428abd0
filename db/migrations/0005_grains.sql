-- Runs of specimens of grains: programmes of their own beside the tests of the apparatus. All of it is
-- simulated. Compression positive; strains are natural, since the start of their stage.

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
  writer_pid INTEGER NOT NULL,
  writer_started INTEGER NOT NULL,
  writer_host TEXT NOT NULL
) STRICT;

CREATE TABLE grain_stages (
  run_id INTEGER NOT NULL REFERENCES grain_runs (id) ON DELETE CASCADE,
  number INTEGER NOT NULL CHECK (number >= 1),
  name TEXT NOT NULL,
  action TEXT NOT NULL,
  started_from TEXT NOT NULL,
  strain_path_R REAL,        -- d eps_1 + 2 R d eps_3 = 0
  ending TEXT NOT NULL,
  settled INTEGER CHECK (settled IN (0, 1)),
  porosity REAL NOT NULL,    -- at the end, as all that follows
  coordination REAL NOT NULL,
  floating_grains INTEGER NOT NULL,
  axial_stress_kPa REAL NOT NULL,
  radial_stress_kPa REAL NOT NULL,
  unbalanced REAL NOT NULL,
  kinetic_energy_J REAL NOT NULL,
  engine_steps INTEGER NOT NULL,
  wall_clock_s REAL,         -- NULL: put together from pieces
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
  sliding_pct REAL NOT NULL,
  PRIMARY KEY (run_id, stage, number),
  FOREIGN KEY (run_id, stage) REFERENCES grain_stages (run_id, number) ON DELETE CASCADE
) STRICT, WITHOUT ROWID;

-- Number 0 is the null probe. Work per volume of the state that was probed.
CREATE TABLE grain_probes (
  run_id INTEGER NOT NULL,
  stage INTEGER NOT NULL,
  number INTEGER NOT NULL CHECK (number >= 0),
  alpha_deg REAL,
  norm_kPa REAL NOT NULL,
  settled INTEGER NOT NULL CHECK (settled IN (0, 1)),
  axial_strain REAL NOT NULL,
  radial_strain REAL NOT NULL,
  work_lagrangian_J_per_m3 REAL NOT NULL,  -- Eq. (7)
  work_eulerian_J_per_m3 REAL NOT NULL,    -- Eq. (10), the sum of the next three
  stress_part_J_per_m3 REAL NOT NULL,
  volume_part_J_per_m3 REAL NOT NULL,
  transport_part_J_per_m3 REAL NOT NULL,
  work_microscopic_J_per_m3 REAL NOT NULL, -- Eq. (11)
  work_fixed_frame_J_per_m3 REAL NOT NULL, -- the sum over contacts in a frame at rest, Eq. (20) without turns
  boundary_part_J_per_m3 REAL NOT NULL,    -- of Eq. (22), as far as two states tell
  normalised_work REAL NOT NULL,
  sliding_pct REAL NOT NULL,
  non_permanent_pct REAL NOT NULL,
  largest_kinetic_energy_J REAL NOT NULL,
  engine_steps INTEGER NOT NULL,
  PRIMARY KEY (run_id, stage, number),
  FOREIGN KEY (run_id, stage) REFERENCES grain_stages (run_id, number) ON DELETE CASCADE
) STRICT, WITHOUT ROWID;

CREATE TABLE grain_perturbations (
  run_id INTEGER NOT NULL,
  stage INTEGER NOT NULL,
  load_step_Pa REAL NOT NULL,
  kinetic_energy_J REAL NOT NULL,
  grains_hit INTEGER NOT NULL,
  largest_kinetic_energy_J REAL NOT NULL,
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
  unbalanced REAL NOT NULL,
  PRIMARY KEY (run_id, stage, number),
  FOREIGN KEY (run_id, stage) REFERENCES grain_stages (run_id, number) ON DELETE CASCADE
) STRICT, WITHOUT ROWID;

-- Peak of sigma_1 - sigma_3/R of every strain path, and what came after it.
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
