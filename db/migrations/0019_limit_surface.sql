-- The largest stress ratio of a test is no limit surface: without a friction angle the limit is unknown, unless the
-- specimen failed on it.

UPDATE verdicts SET limit_source = 'largest stress ratio of this test, at which the specimen failed'
WHERE limit_source LIKE 'largest stress ratio mobilised%' AND inside_limit_surface = 0;

UPDATE verdicts SET inside_limit_surface = NULL, limit_stress_ratio = NULL,
  limit_source = 'unknown: no friction angle is given; --set specimen.limit_friction_angle_deg=...'
WHERE limit_source LIKE 'largest stress ratio mobilised%';
