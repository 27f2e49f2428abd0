-- Probes of grains by strain, what macroscopic and microscopic second-order work differ by, and where energy and
-- momentum of every stage and probe went. What older versions did not store is NULL, or has no row.

-- norm_kPa: NULL of strain probes. boundary_part: from walls half-way now; what older versions had there was a change of
-- speed times a time, and goes.
CREATE TABLE grain_probes_now (
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
INSERT INTO grain_probes_now
SELECT run_id, stage, number, alpha_deg, norm_kPa, at_rest, axial_strain, radial_strain, work_lagrangian_J_per_m3,
  work_eulerian_J_per_m3, stress_part_J_per_m3, volume_part_J_per_m3, transport_part_J_per_m3, work_microscopic_J_per_m3,
  work_fixed_frame_J_per_m3, NULL, normalised_work, sliding_pct, non_permanent_pct, largest_kinetic_energy_J,
  engine_steps, stopped, axial_stress_kPa, radial_stress_kPa, normal_part_J_per_m3, tangential_part_J_per_m3,
  non_permanent_part_J_per_m3, contacts_before, contacts_opened, contacts_closed, unbalanced, stress_error_Pa, last_bits
FROM grain_probes;
DROP TABLE grain_probes;
ALTER TABLE grain_probes_now RENAME TO grain_probes;

-- The stress that was probed.
CREATE TABLE grain_roses_now (
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
INSERT INTO grain_roses_now
SELECT run_id, stage, norm_kPa, axial_stress_kPa, radial_stress_kPa, NULL, 'stress', last_bits FROM grain_roses;
DROP TABLE grain_roses;
ALTER TABLE grain_roses_now RENAME TO grain_roses;

-- work_microscopic − work_lagrangian of a probe is the sum of these and of what they leave.
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

-- From the end of the first step to the end of a stage, or of a probe:
-- walls = (elastic_end - elastic_start) + (kinetic_end - kinetic_start) + friction + damping + stopped + error.
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

-- Along the axes x, y and z of the box (z is axis 1), kg m/s: end = start + walls + damping - stopped, to round-off.
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
