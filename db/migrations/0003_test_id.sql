-- The table of tests under the column names that every view uses for them.

ALTER TABLE tests ADD COLUMN test_id INTEGER GENERATED ALWAYS AS (id) VIRTUAL;
ALTER TABLE tests ADD COLUMN test TEXT GENERATED ALWAYS AS (name) VIRTUAL;
