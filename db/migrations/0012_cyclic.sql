-- Cyclic mobility is a kind of its own, and cycles of load are told as such.

DROP VIEW collapses;
DROP VIEW collapse_points;
DROP VIEW sweep_results;

CREATE TABLE new_verdicts (
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
) STRICT;
INSERT INTO new_verdicts SELECT * FROM verdicts;
DROP TABLE verdicts;
ALTER TABLE new_verdicts RENAME TO verdicts;

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

CREATE VIEW collapses AS
SELECT
  t.id AS test_id, t.name AS test, t.origin, t.programme, t.status,
  v.kind, v.inside_limit_surface,
  o.reading, o.time_s, o.axial_strain, o.q_kPa, o.p_eff_kPa, o.pore_pressure_kPa,
  o.q_kPa / o.p_eff_kPa AS eta,
  degrees(asin(CASE WHEN o.q_kPa / o.p_eff_kPa >= 0 THEN 1 ELSE -1 END
               * 3 * (o.q_kPa / o.p_eff_kPa) / (6 + o.q_kPa / o.p_eff_kPa))) AS phi_mob_deg,
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
  c.phi_mob_deg, c.eta, c.kind, c.inside_limit_surface, c.origin, c.test_id
FROM counted_tests t
JOIN collapses c ON c.test_id = t.test_id
LEFT JOIN consolidations k ON k.test_id = c.test_id
LEFT JOIN specimens b ON b.test_id = c.test_id
WHERE c.kind NOT IN ('none', 'cyclic_mobility');

CREATE VIEW sweep_results AS
SELECT
  m.sweep, m.place, m.test_id, t.name AS test, t.origin, t.status, t.seed, m.key, m.value,
  c.kind, c.time_s, c.eta, c.phi_mob_deg,
  u.lost_sustainability AS truly_lost_sustainability, u.time_s AS true_time_s,
  u.q_kPa / u.p_eff_kPa AS true_eta
FROM sweep_members m
JOIN tests t ON t.id = m.test_id
LEFT JOIN collapses c ON c.test_id = m.test_id
LEFT JOIN truths u ON u.test_id = m.test_id;
