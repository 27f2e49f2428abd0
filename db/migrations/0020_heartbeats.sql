-- Counts the signs of life: two looks at it tell a writer that is alive, whatever the clocks of the two computers say.
ALTER TABLE leases ADD COLUMN heartbeats INTEGER NOT NULL DEFAULT 0;
