-- The reading and the time at which a finding became known are called detected_at everywhere.

ALTER TABLE verdicts RENAME COLUMN noticed_reading TO detected_at_reading;
ALTER TABLE verdicts RENAME COLUMN noticed_time_s TO detected_at_time_s;
ALTER TABLE criteria RENAME COLUMN noticed_reading TO detected_at_reading;
ALTER TABLE criteria RENAME COLUMN noticed_time_s TO detected_at_time_s;
ALTER TABLE events RENAME COLUMN noticed_reading TO detected_at_reading;
ALTER TABLE events RENAME COLUMN noticed_time_s TO detected_at_time_s;
