-- Cohesion of the limit surface, q = M p' + k, and the strength of tests in total stresses.
ALTER TABLE specimens ADD COLUMN cohesion_kPa REAL;
ALTER TABLE verdicts ADD COLUMN limit_intercept_kPa REAL;

-- c_u = |q|/2 at the largest q up to 20 % axial strain (ISO 17892-8); where that is beyond 15 %, also there (ASTM D2850).
CREATE TABLE undrained_strengths (
  test_id INTEGER PRIMARY KEY REFERENCES tests (id) ON DELETE CASCADE,
  c_u_kPa REAL NOT NULL,
  reading INTEGER NOT NULL,
  time_s REAL,
  axial_strain REAL,
  q_kPa REAL,
  peaked INTEGER NOT NULL CHECK (peaked IN (0, 1)),
  last_axial_strain REAL,
  reading_at_15_pct INTEGER,
  time_at_15_pct_s REAL,
  axial_strain_at_15_pct REAL,
  q_at_15_pct_kPa REAL
) STRICT;
