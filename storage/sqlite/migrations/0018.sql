-- Schema 18: lists and figures of practice or of assessments alone. The kind stands in the indexes of the lists, and in each packed
-- attempt (storage/sqlite/packed_attempt.h).
DROP INDEX summaries_by_time;
CREATE INDEX summaries_by_time ON session_summaries
  (listed, started_at, sequence, session, device_class, passed, operator, kind);
DROP INDEX summaries_of_scenario;
CREATE INDEX summaries_of_scenario ON session_summaries
  (listed, scenario, started_at, sequence, session, device_class, passed, operator, version_number, kind);
DROP INDEX summaries_of_student;
CREATE INDEX summaries_of_student ON session_summaries
  (student, listed, started_at, sequence, session, scenario, device_class, passed, operator, kind);

DELETE FROM packed_attempts;
INSERT INTO packed_attempts
SELECT scenario, device_class, started_at >> 39,
       pack_attempts(started_at, student, score, pass_mark, elapsed_us, attempt, passed, operator <> 'person', released, version_number,
                     kind = 'assessment')
FROM session_summaries WHERE listed = 1 AND score IS NOT NULL GROUP BY 1, 2, 3;
