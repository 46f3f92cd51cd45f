-- Schema 14: lists and figures of one version of an exercise. The number stands in the index of the list, and in each packed attempt
-- (storage/sqlite/packed_attempt.h).
DROP INDEX summaries_of_scenario;
CREATE INDEX summaries_of_scenario ON session_summaries
  (listed, scenario, started_at, sequence, session, device_class, passed, operator, version_number);

DELETE FROM packed_attempts;
INSERT INTO packed_attempts
SELECT scenario, device_class, started_at >> 39,
       pack_attempts(started_at, student, score, pass_mark, elapsed_us, attempt, passed, operator <> 'person', released, version_number)
FROM session_summaries WHERE listed = 1 AND score IS NOT NULL GROUP BY 1, 2, 3;
