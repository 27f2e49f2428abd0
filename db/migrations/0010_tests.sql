-- A file that is read twice is one test, and tests have tags.

ALTER TABLE tests ADD COLUMN digest TEXT; -- SHA-256 of the record's bytes; NULL: no file was read, or not known
CREATE INDEX tests_by_digest ON tests (digest);

CREATE TABLE tags (
  test_id INTEGER NOT NULL REFERENCES tests (id) ON DELETE CASCADE,
  tag TEXT NOT NULL CHECK (tag <> ''),
  PRIMARY KEY (test_id, tag)
) STRICT, WITHOUT ROWID;
CREATE INDEX tags_by_tag ON tags (tag);

-- What statistics count: of the readings of one file the latest that is complete, or the latest where none is.
CREATE VIEW counted_tests AS
SELECT t.id AS test_id, t.name AS test, t.origin
FROM tests t
WHERE NOT EXISTS (
  SELECT 1 FROM tests other
  WHERE other.digest = t.digest
    AND (other.status = 'complete', other.id) > (t.status = 'complete', t.id)
);

DROP VIEW collapse_points;
CREATE VIEW collapse_points AS
SELECT
  c.programme AS type_of_test, c.test, k.p_eff_kPa AS p0_eff_kPa,
  coalesce(k.void_ratio, b.consolidated_void_ratio, b.void_ratio) AS void_ratio,
  c.phi_mob_deg, c.eta, c.kind, c.inside_limit_surface, c.origin, c.test_id
FROM counted_tests t
JOIN collapses c ON c.test_id = t.test_id
LEFT JOIN consolidations k ON k.test_id = c.test_id
LEFT JOIN specimens b ON b.test_id = c.test_id
WHERE c.kind <> 'none';
