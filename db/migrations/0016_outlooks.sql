-- What the alarm said of the onset while the test ran, where it was said first and not taken back.

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
