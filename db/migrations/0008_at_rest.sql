-- Grains are at rest, or not: the field's word for what was called settled.

ALTER TABLE grain_stages RENAME COLUMN settled TO at_rest;
ALTER TABLE grain_probes RENAME COLUMN settled TO at_rest;
UPDATE grain_stages SET ending = 'at rest' WHERE ending = 'settled';
