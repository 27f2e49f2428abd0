-- Two instants of every test: beside the onset of instability the loss of control, from which the programme could no
-- longer be maintained. The onset has a total uncertainty, and the true runaways the state in which they began.

CREATE TABLE losses_of_control (
  test_id INTEGER PRIMARY KEY REFERENCES tests (id) ON DELETE CASCADE,
  reading INTEGER NOT NULL,
  time_s REAL,
  axial_strain REAL,
  q_kPa REAL,
  p_eff_kPa REAL,
  pore_pressure_kPa REAL,
  eta_low REAL,               -- 95 %, as in verdicts
  eta_high REAL,
  q_low_kPa REAL,
  q_high_kPa REAL,
  p_eff_low_kPa REAL,
  p_eff_high_kPa REAL,
  detected_at_reading INTEGER, -- NULL: only when the record had ended
  detected_at_time_s REAL
) STRICT;

-- Repeatability and the errors that all readings share.
ALTER TABLE verdicts ADD COLUMN total_eta_low REAL;
ALTER TABLE verdicts ADD COLUMN total_eta_high REAL;
ALTER TABLE verdicts ADD COLUMN total_q_low_kPa REAL;
ALTER TABLE verdicts ADD COLUMN total_q_high_kPa REAL;
ALTER TABLE verdicts ADD COLUMN total_p_eff_low_kPa REAL;
ALTER TABLE verdicts ADD COLUMN total_p_eff_high_kPa REAL;
ALTER TABLE verdicts ADD COLUMN uncertainty_budget TEXT; -- JSON: [{"name": ..., "share": of the variance of eta}]

-- At the start.
ALTER TABLE run_aways ADD COLUMN axial_strain REAL;
ALTER TABLE run_aways ADD COLUMN q_kPa REAL;
ALTER TABLE run_aways ADD COLUMN p_eff_kPa REAL;
ALTER TABLE run_aways ADD COLUMN pore_pressure_kPa REAL;

DROP VIEW collapses;
CREATE VIEW collapses AS
SELECT
  t.id AS test_id, t.name AS test, t.origin, t.programme, t.status,
  v.kind, v.inside_limit_surface,
  o.reading, o.time_s, o.axial_strain, o.q_kPa, o.p_eff_kPa, o.pore_pressure_kPa,
  o.q_kPa / o.p_eff_kPa AS eta,
  degrees(asin(CASE WHEN o.q_kPa / o.p_eff_kPa >= 0 THEN 1 ELSE -1 END
               * 3 * (o.q_kPa / o.p_eff_kPa) / (6 + o.q_kPa / o.p_eff_kPa))) AS phi_mob_deg,
  v.eta_low, v.eta_high, v.q_low_kPa, v.q_high_kPa, v.p_eff_low_kPa, v.p_eff_high_kPa,
  v.total_eta_low, v.total_eta_high,
  v.noticed_reading, v.noticed_time_s,
  l.reading AS loss_of_control_reading, l.time_s AS loss_of_control_time_s,
  l.axial_strain AS loss_of_control_axial_strain, l.q_kPa AS loss_of_control_q_kPa,
  l.p_eff_kPa AS loss_of_control_p_eff_kPa, l.pore_pressure_kPa AS loss_of_control_pore_pressure_kPa,
  l.q_kPa / l.p_eff_kPa AS loss_of_control_eta,
  l.eta_low AS loss_of_control_eta_low, l.eta_high AS loss_of_control_eta_high,
  l.detected_at_reading AS loss_of_control_detected_at_reading,
  l.detected_at_time_s AS loss_of_control_detected_at_time_s,
  v.second_order_work_normalised, v.second_order_work_error, v.strength_lost, v.limit_stress_ratio, v.limit_source,
  v.judged_from_reading, v.judged_until_reading, v.judged_until_reason, v.nearest_reading, v.nearest_normalised,
  v.nearest_error
FROM tests t
JOIN verdicts v ON v.test_id = t.id
LEFT JOIN instants o ON o.test_id = t.id AND o.kind = 'onset'
LEFT JOIN losses_of_control l ON l.test_id = t.id;
