-- What the deeper virtual apparatus knows: stages that ask nothing of the specimen, strain paths,
-- run-aways, verdicts that rest on a part of the test, and sweeps.

-- The CHECK of a column cannot be altered: the table is built anew, rows keep their order.
CREATE TABLE stages_0004 (
  test_id INTEGER NOT NULL REFERENCES tests (id) ON DELETE CASCADE,
  number INTEGER NOT NULL,
  name TEXT NOT NULL,
  role TEXT NOT NULL
    CHECK (role IN ('unknown', 'saturation', 'b_check', 'consolidation', 'shear', 'hold')),
  drainage TEXT NOT NULL CHECK (drainage IN ('unknown', 'open', 'closed')),
  control TEXT NOT NULL CHECK (control IN ('unknown', 'displacement', 'load', 'constant_q')),
  strain_path_R REAL,        -- d eps_1 + 2 R d eps_3 = 0 is prescribed
  PRIMARY KEY (test_id, number)
) STRICT;
INSERT INTO stages_0004 (rowid, test_id, number, name, role, drainage, control)
  SELECT rowid, test_id, number, name, role, drainage, control FROM stages;
DROP TABLE stages;
ALTER TABLE stages_0004 RENAME TO stages;

-- NULL: the verdict rests on the whole test.
ALTER TABLE verdicts ADD COLUMN judged_until_reading INTEGER;
ALTER TABLE verdicts ADD COLUMN judged_until_reason TEXT;

-- What the moving mass of a simulation did while the specimen could not carry its load.
CREATE TABLE run_aways (
  test_id INTEGER NOT NULL REFERENCES tests (id) ON DELETE CASCADE,
  number INTEGER NOT NULL CHECK (number >= 1),
  start_s REAL NOT NULL,     -- test time, as the other two
  largest_kinetic_energy_J REAL CHECK (largest_kinetic_energy_J >= 0),
  largest_at_s REAL CHECK (largest_at_s >= start_s),
  kinetic_energy_J REAL,     -- that the specimen set free until Eq. (5) was compared
  second_order_work_J REAL,
  expected_ratio REAL,       -- of kinetic energy to minus half the work: 1 past a peak, 2/3 from one
  end_s REAL CHECK (end_s >= start_s), -- NULL: it still ran when the test ended
  ending TEXT,
  PRIMARY KEY (test_id, number)
) STRICT, WITHOUT ROWID;

-- Which values of a sweep a test was run with, one row a swept key of the programme.
CREATE TABLE sweep_members (
  test_id INTEGER NOT NULL REFERENCES tests (id) ON DELETE CASCADE,
  sweep TEXT NOT NULL,
  place INTEGER NOT NULL CHECK (place >= 1), -- of the test in the order of the sweep
  position INTEGER NOT NULL CHECK (position >= 1), -- of the key in the order it was asked for
  key TEXT NOT NULL,
  value ANY NOT NULL,        -- a number where the programme holds a number
  PRIMARY KEY (test_id, key)
) STRICT, WITHOUT ROWID;
CREATE INDEX sweep_members_by_sweep ON sweep_members (sweep, place);

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
