-- Who writes a test or a run of grains says so every few seconds under a random name of its own, in place of the number
-- of its process, which says nothing in another PID namespace or on another host. The status of a row is what was last
-- written there; the views seen_tests and seen_grain_runs have it as a reader sees it now.

ALTER TABLE tests DROP COLUMN writer_pid;
ALTER TABLE tests DROP COLUMN writer_started;
ALTER TABLE tests DROP COLUMN writer_host;
ALTER TABLE grain_runs DROP COLUMN writer_pid;
ALTER TABLE grain_runs DROP COLUMN writer_started;
ALTER TABLE grain_runs DROP COLUMN writer_host;

-- Of what is not complete. One of test_id and run_id is NULL.
CREATE TABLE leases (
  writer TEXT PRIMARY KEY,          -- random
  test_id INTEGER UNIQUE REFERENCES tests (id) ON DELETE CASCADE,
  run_id INTEGER UNIQUE REFERENCES grain_runs (id) ON DELETE CASCADE,
  last_sign_of_life TEXT NOT NULL,  -- ISO 8601, UTC, by the clock of the writer
  CHECK ((test_id IS NULL) <> (run_id IS NULL))
) STRICT, WITHOUT ROWID;

-- A sign is due every 2 s. One from the future is as wrong as one of long ago: nothing runs for ever.
CREATE VIEW seen_leases AS
SELECT writer, test_id, run_id, last_sign_of_life, silent_s, abs(silent_s) < 20 AS alive
FROM (
  SELECT *, strftime('%s', 'now') - strftime('%s', last_sign_of_life) AS silent_s FROM leases
);

CREATE VIEW seen_tests AS
SELECT t.id AS test_id, t.name AS test, t.origin,
  CASE WHEN t.status = 'running' AND NOT coalesce(l.alive, 0) THEN 'interrupted' ELSE t.status END
    AS status,
  l.last_sign_of_life, l.silent_s,
  coalesce(t.readings, (SELECT count(*) FROM scans c WHERE c.id BETWEEN t.id << 32 AND t.id << 32 | 4294967295))
    AS readings  -- so far
FROM tests t LEFT JOIN seen_leases l ON l.test_id = t.id;

CREATE VIEW seen_grain_runs AS
SELECT r.id AS run_id, r.name AS run, r.origin,
  CASE WHEN r.status = 'running' AND NOT coalesce(l.alive, 0) THEN 'interrupted' ELSE r.status END
    AS status,
  l.last_sign_of_life, l.silent_s
FROM grain_runs r LEFT JOIN seen_leases l ON l.run_id = r.id;

DROP VIEW unfinished_tests;
CREATE VIEW unfinished_tests AS
SELECT
  t.id AS test_id, t.name AS test, t.origin, s.status, t.stored_at, s.readings, s.last_sign_of_life, s.silent_s
FROM tests t JOIN seen_tests s ON s.test_id = t.id
WHERE t.status <> 'complete';

DROP VIEW sweep_results;
CREATE VIEW sweep_results AS
SELECT
  m.sweep, m.place, m.test_id, t.name AS test, t.origin, s.status, t.seed, m.key, m.value,
  c.kind, c.time_s, c.eta, c.phi_mob_deg,
  u.lost_sustainability AS truly_lost_sustainability, u.time_s AS true_time_s,
  u.q_kPa / u.p_eff_kPa AS true_eta
FROM sweep_members m
JOIN tests t ON t.id = m.test_id
JOIN seen_tests s ON s.test_id = m.test_id
LEFT JOIN collapses c ON c.test_id = m.test_id
LEFT JOIN truths u ON u.test_id = m.test_id;
