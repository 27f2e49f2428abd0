-- The stresses at an onset have an interval (95 %), and verdicts, criteria and events say at which reading they were
-- known: NULL where that was only when the record had ended, and in what was stored before.

ALTER TABLE verdicts ADD COLUMN eta_low REAL;
ALTER TABLE verdicts ADD COLUMN eta_high REAL;
ALTER TABLE verdicts ADD COLUMN q_low_kPa REAL;
ALTER TABLE verdicts ADD COLUMN q_high_kPa REAL;
ALTER TABLE verdicts ADD COLUMN p_eff_low_kPa REAL;
ALTER TABLE verdicts ADD COLUMN p_eff_high_kPa REAL;
ALTER TABLE verdicts ADD COLUMN noticed_reading INTEGER;
ALTER TABLE verdicts ADD COLUMN noticed_time_s REAL;
ALTER TABLE criteria ADD COLUMN noticed_reading INTEGER;
ALTER TABLE criteria ADD COLUMN noticed_time_s REAL;
ALTER TABLE events ADD COLUMN noticed_reading INTEGER;
ALTER TABLE events ADD COLUMN noticed_time_s REAL;

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
  v.noticed_reading, v.noticed_time_s,
  v.second_order_work_normalised, v.second_order_work_error, v.strength_lost, v.limit_stress_ratio, v.limit_source,
  v.judged_from_reading, v.judged_until_reading, v.judged_until_reason, v.nearest_reading, v.nearest_normalised,
  v.nearest_error
FROM tests t
JOIN verdicts v ON v.test_id = t.id
LEFT JOIN instants o ON o.test_id = t.id AND o.kind = 'onset';

DROP VIEW collapse_points;
CREATE VIEW collapse_points AS
SELECT
  c.programme AS type_of_test, c.test, k.p_eff_kPa AS p0_eff_kPa,
  coalesce(k.void_ratio, b.consolidated_void_ratio, b.void_ratio) AS void_ratio,
  c.phi_mob_deg, c.eta, c.eta_low, c.eta_high, c.kind, c.inside_limit_surface, c.origin, c.test_id
FROM counted_tests t
JOIN collapses c ON c.test_id = t.test_id
LEFT JOIN consolidations k ON k.test_id = c.test_id
LEFT JOIN specimens b ON b.test_id = c.test_id
WHERE c.kind NOT IN ('none', 'cyclic_mobility');
