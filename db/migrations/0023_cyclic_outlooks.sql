-- A warning may also be issued for an undrained cyclic test, with the probability of failure within one load cycle and
-- without a forecast of eta.

CREATE TABLE outlooks_new (
  test_id INTEGER NOT NULL REFERENCES tests (id) ON DELETE CASCADE,
  level TEXT NOT NULL CHECK (level IN ('approaching', 'imminent')),
  reading INTEGER NOT NULL,   -- the last that had been taken
  time_s REAL,
  eta_forecast REAL,          -- at the onset to come; NULL: failure_probability instead
  eta_low REAL,               -- its 90 % interval
  eta_high REAL,
  left_quantity TEXT,         -- what drives the test: deviator_stress_kPa, axial_strain, mean_effective_stress_kPa
  left_value REAL,            -- of it, in its unit (axial strain as a ratio)
  left_time_s REAL,           -- at the present rate
  failure_probability REAL,   -- of failure within one load cycle
  load_cycles REAL,           -- applied until then
  PRIMARY KEY (test_id, level)
) STRICT;

INSERT INTO outlooks_new SELECT *, NULL, NULL FROM outlooks;
DROP TABLE outlooks;
ALTER TABLE outlooks_new RENAME TO outlooks;
