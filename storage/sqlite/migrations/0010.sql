-- Schema 10: graded attempts as figures read them, many in a row (storage/records/packed_attempts.h): of one scenario and device
-- class, started within one period of 2^39 µs. They follow from session_summaries, and verification compares both.
-- pack_attempts is an aggregate of the program (storage/sqlite/packed_attempt.h).
CREATE TABLE packed_attempts (
  scenario BLOB NOT NULL,
  device_class TEXT NOT NULL,
  period INTEGER NOT NULL,
  attempts BLOB NOT NULL,
  PRIMARY KEY (scenario, device_class, period)
) STRICT, WITHOUT ROWID;

INSERT INTO packed_attempts
SELECT scenario, device_class, started_at >> 39,
       pack_attempts(started_at, student, score, pass_mark, elapsed_us, attempt, passed, operator <> 'person', released)
FROM session_summaries WHERE listed = 1 AND score IS NOT NULL GROUP BY 1, 2, 3;

-- Figures read packed_attempts in place of these.
DROP INDEX graded_by_time;
DROP INDEX graded_of_scenario;
