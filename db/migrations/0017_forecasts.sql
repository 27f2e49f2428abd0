-- What the alarm forecast at every point of second-order work; id as in `scans`: the last reading that had been taken.
-- No row where it forecast none, nor of what was stored before.

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
