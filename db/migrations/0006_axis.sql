-- What a record runs along is said, and nothing but time stands under time_s. A record without time
-- runs along its axial strain; before this schema its points of second-order work had the way along
-- the axial strain in time_s.

ALTER TABLE tests ADD COLUMN axis TEXT
  GENERATED ALWAYS AS (CASE WHEN has_time THEN 'time' ELSE 'axial_strain' END) VIRTUAL;

-- Length of the way along axial strain, both directions counted; NULL where there is a time.
ALTER TABLE work_points ADD COLUMN axial_strain_path REAL;
UPDATE work_points SET axial_strain_path = time_s, time_s = NULL
  WHERE id >> 32 IN (SELECT id FROM tests WHERE NOT has_time);
UPDATE events SET time_s = NULL WHERE test_id IN (SELECT id FROM tests WHERE NOT has_time);
UPDATE instants SET time_s = NULL WHERE test_id IN (SELECT id FROM tests WHERE NOT has_time);
UPDATE criteria SET time_s = NULL WHERE test_id IN (SELECT id FROM tests WHERE NOT has_time);

-- Work is in Pa per square of the unit of the axis: s, or unit of axial_strain_path.
DROP VIEW second_order_work;
CREATE VIEW second_order_work AS
SELECT
  t.id AS test_id, t.name AS test, t.origin, t.axis, w.id & 4294967295 AS reading,
  w.time_s, w.axial_strain_path,
  CASE WHEN t.has_time THEN w.small_strain END AS small_strain_Pa_per_s2,
  CASE WHEN t.has_time THEN w.eulerian END AS eulerian_Pa_per_s2,
  CASE WHEN t.has_time THEN w.semi_lagrangian END AS semi_lagrangian_Pa_per_s2,
  CASE WHEN NOT t.has_time THEN w.small_strain END AS small_strain_Pa_per_strain2,
  CASE WHEN NOT t.has_time THEN w.eulerian END AS eulerian_Pa_per_strain2,
  CASE WHEN NOT t.has_time THEN w.semi_lagrangian END AS semi_lagrangian_Pa_per_strain2,
  w.normalised, w.normalised_error, w.window_readings
FROM tests t
JOIN work_points w ON w.id BETWEEN t.id << 32 AND t.id << 32 | 4294967295;

-- From here on the program makes this view from its table of quantities (db/channel_columns.cpp),
-- anew whenever a channel has been added.
DROP VIEW readings;
