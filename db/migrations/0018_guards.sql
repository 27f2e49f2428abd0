-- What the guard of a programme did, and what the same test came to without it.

CREATE TABLE guards (
  test_id INTEGER PRIMARY KEY REFERENCES tests (id) ON DELETE CASCADE,
  level TEXT NOT NULL CHECK (level IN ('approaching', 'imminent', 'lost')), -- that it acted on
  done TEXT NOT NULL,              -- in words
  reading INTEGER NOT NULL,        -- at which it acted, as the next five
  time_s REAL,
  axial_strain REAL,
  q_kPa REAL,
  p_eff_kPa REAL,
  second_order_work_normalised REAL,
  last_axial_strain REAL,          -- at the end of the test
  without_kind TEXT CHECK (without_kind IN ('none', 'limited', 'partial', 'flow', 'cyclic_mobility')), -- empty: not run
  without_last_axial_strain REAL,
  without_lost_reading INTEGER,    -- after which the specimen ran away
  without_lost_time_s REAL
) STRICT;
