-- Values of a stored test can be corrected: it is then reduced and assessed again from its stored readings, under the
-- same id. All other tables have the newest revision.

-- A test as it was first stored, as far as other tables do not have it or a correction changes it. JSON, SI. No row:
-- stored by an older triax.
CREATE TABLE first_headers (
  test_id INTEGER PRIMARY KEY REFERENCES tests (id) ON DELETE CASCADE,
  header TEXT NOT NULL,
  ending TEXT                -- known at the end of the test
) STRICT;

-- The test as first stored is revision 1, without a row.
CREATE TABLE revisions (
  test_id INTEGER NOT NULL REFERENCES tests (id) ON DELETE CASCADE,
  revision INTEGER NOT NULL CHECK (revision >= 2),
  revised_at TEXT NOT NULL,  -- ISO 8601, UTC
  former_kind TEXT,          -- result of the revision before; as in verdicts and collapses
  former_eta REAL,           -- at its onset
  PRIMARY KEY (test_id, revision)
) STRICT, WITHOUT ROWID;

CREATE TABLE revised_values (
  test_id INTEGER NOT NULL,
  revision INTEGER NOT NULL,
  position INTEGER NOT NULL, -- of the key in the command
  key TEXT NOT NULL,         -- as in --set
  old_value TEXT,            -- NULL: unknown
  new_value TEXT,            -- NULL: as first stored
  PRIMARY KEY (test_id, revision, key),
  FOREIGN KEY (test_id, revision) REFERENCES revisions (test_id, revision) ON DELETE CASCADE
) STRICT, WITHOUT ROWID;
