-- All that a report of a run of grains tells, to the bit, so that it is told from here alone. What older
-- versions did not store stays NULL, or has no row. `last_bits`: three bits for each number of the row in the
-- order of its columns, the units in the last place that lead back to the SI value (and tell -0 from 0).

ALTER TABLE grain_runs ADD COLUMN smallest_grain_mm REAL; -- diameters by count
ALTER TABLE grain_runs ADD COLUMN median_grain_mm REAL;
ALTER TABLE grain_runs ADD COLUMN largest_grain_mm REAL;
ALTER TABLE grain_runs ADD COLUMN compaction_pressure_kPa REAL;
ALTER TABLE grain_runs ADD COLUMN porosity_wanted REAL;
ALTER TABLE grain_runs ADD COLUMN last_bits INTEGER;

-- Natural strains of the start of the stage since the specimen was made.
ALTER TABLE grain_stages ADD COLUMN axial_strain_at_start REAL;
ALTER TABLE grain_stages ADD COLUMN radial_strain_at_start REAL;
ALTER TABLE grain_stages ADD COLUMN last_bits INTEGER;

ALTER TABLE grain_points ADD COLUMN last_bits INTEGER;

ALTER TABLE grain_probes ADD COLUMN stopped INTEGER CHECK (stopped IN (0, 1));
ALTER TABLE grain_probes ADD COLUMN axial_stress_kPa REAL; -- the increment that was reached
ALTER TABLE grain_probes ADD COLUMN radial_stress_kPa REAL;
ALTER TABLE grain_probes ADD COLUMN normal_part_J_per_m3 REAL; -- the next three sum up to work_microscopic
ALTER TABLE grain_probes ADD COLUMN tangential_part_J_per_m3 REAL;
ALTER TABLE grain_probes ADD COLUMN non_permanent_part_J_per_m3 REAL;
ALTER TABLE grain_probes ADD COLUMN contacts_before INTEGER;
ALTER TABLE grain_probes ADD COLUMN contacts_opened INTEGER;
ALTER TABLE grain_probes ADD COLUMN contacts_closed INTEGER;
ALTER TABLE grain_probes ADD COLUMN unbalanced REAL;
ALTER TABLE grain_probes ADD COLUMN stress_error_Pa REAL;
ALTER TABLE grain_probes ADD COLUMN last_bits INTEGER;

ALTER TABLE grain_perturbations ADD COLUMN floating_share REAL;
ALTER TABLE grain_perturbations ADD COLUMN seed INTEGER;
ALTER TABLE grain_perturbations ADD COLUMN last_bits INTEGER;
ALTER TABLE grain_perturbation_points ADD COLUMN last_bits INTEGER;

-- The specimen as made (stage 0), and before and after each stage.
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

-- How a path was asked for; axis 1 goes by strain, or by load where that rate is not 0.
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

-- States kept on the way of a path; NULL values: never passed.
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

-- The stress that was probed.
CREATE TABLE grain_roses (
  run_id INTEGER NOT NULL,
  stage INTEGER NOT NULL,
  norm_kPa REAL NOT NULL,
  axial_stress_kPa REAL NOT NULL,
  radial_stress_kPa REAL NOT NULL,
  last_bits INTEGER NOT NULL,
  PRIMARY KEY (run_id, stage),
  FOREIGN KEY (run_id, stage) REFERENCES grain_stages (run_id, number) ON DELETE CASCADE
) STRICT, WITHOUT ROWID;
