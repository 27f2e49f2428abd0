-- Tables of a triax database. Units stand in the names; NULL is "unknown", never 0.
-- What instruments or files gave is kept in units of the field, what reduction made of it in SI, so
-- that neither loses its last bit; the views (0002) give everything in units of the field.

CREATE TABLE tests (
  id INTEGER PRIMARY KEY CHECK (id BETWEEN 1 AND 2147483647),
  name TEXT NOT NULL,
  origin TEXT NOT NULL CHECK (origin IN ('recorded', 'simulated')),
  programme TEXT,
  source TEXT,
  dialect TEXT,
  seed INTEGER,              -- from 0 on
  status TEXT NOT NULL CHECK (status IN ('running', 'complete', 'interrupted')),
  recorded_at TEXT NOT NULL, -- ISO 8601, UTC
  has_time INTEGER NOT NULL CHECK (has_time IN (0, 1)),
  columns TEXT NOT NULL,     -- headings of what the record holds, separated by commas
  readings INTEGER,          -- NULL while the test runs
  writer_pid INTEGER NOT NULL,
  writer_started INTEGER NOT NULL, -- start of that process in ticks since boot: a pid is used again
  writer_host TEXT NOT NULL
) STRICT;
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

CREATE TABLE stages (
  test_id INTEGER NOT NULL REFERENCES tests (id) ON DELETE CASCADE,
  number INTEGER NOT NULL,
  name TEXT NOT NULL,
  role TEXT NOT NULL
    CHECK (role IN ('unknown', 'saturation', 'b_check', 'consolidation', 'shear')),
  drainage TEXT NOT NULL CHECK (drainage IN ('unknown', 'open', 'closed')),
  control TEXT NOT NULL CHECK (control IN ('unknown', 'displacement', 'load', 'constant_q')),
  PRIMARY KEY (test_id, number)
) STRICT;

-- Void ratio and area at zero strain, from which those of every scan of the stage follow.
CREATE TABLE stage_references (
  test_id INTEGER NOT NULL REFERENCES tests (id) ON DELETE CASCADE,
  stage INTEGER NOT NULL,
  void_ratio REAL,
  area_m2 REAL,
  PRIMARY KEY (test_id, stage)
) STRICT, WITHOUT ROWID;

-- One row a scan (docs/decisions). id = test << 32 | reading, so that the scans of a test lie together.
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

-- Only for scans that hold more than raw channels, or whose state does not follow from `scans`.
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

-- Work of the measured path; id as in `scans`. Pa per square of the unit of progress: s, or unit of
-- axial strain where tests.has_time = 0.
CREATE TABLE work_points (
  id INTEGER PRIMARY KEY,
  time_s REAL,
  small_strain REAL,
  eulerian REAL,
  semi_lagrangian REAL,
  normalised REAL,
  normalised_error REAL,
  window_readings INTEGER NOT NULL
) STRICT;

CREATE TABLE events (
  id INTEGER PRIMARY KEY,
  test_id INTEGER NOT NULL REFERENCES tests (id) ON DELETE CASCADE,
  reading INTEGER NOT NULL,
  time_s REAL,
  kind TEXT NOT NULL,
  detail TEXT NOT NULL
) STRICT;
CREATE INDEX events_by_test ON events (test_id);

CREATE TABLE consolidations (
  test_id INTEGER PRIMARY KEY REFERENCES tests (id) ON DELETE CASCADE,
  p_eff_kPa REAL,
  b_value REAL,
  void_ratio REAL,
  height_mm REAL,
  diameter_mm REAL
) STRICT;

-- Single instants of a test: the peak of q, the onset of collapse.
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

CREATE TABLE verdicts (
  test_id INTEGER PRIMARY KEY REFERENCES tests (id) ON DELETE CASCADE,
  kind TEXT NOT NULL CHECK (kind IN ('none', 'limited', 'flow')),
  inside_limit_surface INTEGER CHECK (inside_limit_surface IN (0, 1)),
  second_order_work_normalised REAL,
  second_order_work_error REAL,
  limit_stress_ratio REAL,
  limit_source TEXT
) STRICT;

CREATE TABLE criteria (
  id INTEGER PRIMARY KEY,
  test_id INTEGER NOT NULL REFERENCES tests (id) ON DELETE CASCADE,
  name TEXT NOT NULL,
  detected INTEGER NOT NULL CHECK (detected IN (0, 1)),
  reading INTEGER,
  time_s REAL,
  eta REAL,
  evidence TEXT
) STRICT;
CREATE INDEX criteria_by_test ON criteria (test_id);

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
