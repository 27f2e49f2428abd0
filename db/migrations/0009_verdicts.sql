-- Three answers, never mixed: a test that was not judged, or not to the end of shear while nothing was found before,
-- has no kind (NULL), and its criteria neither detected nor did not detect. A failure is no collapse: kind 'none' with
-- an onset. What was lost, and what came nearest where nothing was, stand beside the verdict.

DROP VIEW collapses;
DROP VIEW collapse_points;
DROP VIEW sweep_results;

CREATE TABLE new_verdicts (
  test_id INTEGER PRIMARY KEY REFERENCES tests (id) ON DELETE CASCADE,
  kind TEXT CHECK (kind IN ('none', 'limited', 'partial', 'flow')),
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
INSERT INTO new_verdicts
SELECT test_id,
  CASE WHEN kind <> 'none' THEN kind
       WHEN EXISTS (SELECT 1 FROM instants i WHERE i.test_id = v.test_id AND i.kind = 'onset') THEN kind
       WHEN judged_until_reason IS NOT NULL THEN NULL
       WHEN EXISTS (SELECT 1 FROM work_points w WHERE w.id BETWEEN v.test_id << 32 AND (v.test_id << 32) | 4294967295)
         THEN kind
  END,
  inside_limit_surface, second_order_work_normalised, second_order_work_error, limit_stress_ratio, limit_source,
  judged_until_reading, judged_until_reason, NULL, NULL, NULL, NULL, NULL
FROM verdicts v;
DROP TABLE verdicts;
ALTER TABLE new_verdicts RENAME TO verdicts;

CREATE TABLE new_criteria (
  id INTEGER PRIMARY KEY,
  test_id INTEGER NOT NULL REFERENCES tests (id) ON DELETE CASCADE,
  name TEXT NOT NULL,
  detected INTEGER CHECK (detected IN (0, 1)),
  reading INTEGER,
  time_s REAL,
  eta REAL,
  evidence TEXT
) STRICT;
INSERT INTO new_criteria
SELECT id, test_id, name,
  CASE WHEN detected = 0 AND test_id IN (SELECT test_id FROM verdicts WHERE kind IS NULL) THEN NULL ELSE detected END,
  reading, time_s, eta, evidence
FROM criteria;
DROP TABLE criteria;
ALTER TABLE new_criteria RENAME TO criteria;
CREATE INDEX criteria_by_test ON criteria (test_id);

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
FROM collapses c
LEFT JOIN consolidations k ON k.test_id = c.test_id
LEFT JOIN specimens b ON b.test_id = c.test_id
WHERE c.kind <> 'none';

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

-- Of the import, or of the simulation; when the soil was tested only the record can say.
ALTER TABLE tests RENAME COLUMN recorded_at TO stored_at;
ALTER TABLE tests ADD COLUMN membrane_correction TEXT; -- 'none', 'astm', 'iso'; NULL: reduced elsewhere, or not known

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
