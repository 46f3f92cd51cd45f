-- Schema 2: one row a session with what lists and charts need (storage/records/session_summary.h). It is derived from the
-- tables of schema 1, written with the row that it follows, and compared with them by verification. It names no user.
CREATE TABLE session_summaries (
  session BLOB PRIMARY KEY REFERENCES sessions (id),
  student BLOB NOT NULL,
  scenario BLOB NOT NULL,
  version BLOB NOT NULL,
  version_number INTEGER NOT NULL,
  kind TEXT NOT NULL,
  operator TEXT NOT NULL,
  device TEXT NOT NULL,
  device_class TEXT NOT NULL,
  engine_version INTEGER NOT NULL,
  started_at INTEGER NOT NULL,
  sequence INTEGER NOT NULL,
  listed INTEGER NOT NULL,
  attempt INTEGER NOT NULL,
  state TEXT NOT NULL,
  elapsed_us INTEGER NOT NULL,
  score REAL,
  score_max REAL,
  pass_mark REAL,
  passed INTEGER,
  critical TEXT NOT NULL
) STRICT, WITHOUT ROWID;

-- A damaged row of schema 1 must not stop the migration: verification names it afterwards.
INSERT INTO session_summaries
SELECT s.id, s.student, v.scenario, s.version, v.number, s.kind, s.hand, s.device, s.device_class, s.engine_version,
       s.started_at, s.sequence,
       s.kind IN ('practice', 'assessment') AND coalesce(p.guest, 0) = 0,
       row_number() OVER (PARTITION BY s.student, v.scenario,
                                       s.kind IN ('practice', 'assessment') AND coalesce(p.guest, 0) = 0
                          ORDER BY s.started_at, s.sequence),
       CASE WHEN e.kind IN ('started', 'resumed') THEN 'running'
            WHEN e.kind IN ('interrupted', 'finished', 'graded') THEN e.kind
            ELSE iif(g.session IS NULL, 'closed', 'graded') END,
       coalesce((SELECT elapsed_us FROM trace_chunks WHERE session = s.id ORDER BY row DESC LIMIT 1), 0),
       g.score, g.score_max, g.pass_mark, g.passed, coalesce(g.critical, '[]')
FROM sessions s
JOIN scenario_versions v ON v.id = s.version
LEFT JOIN people p ON p.id = s.student
LEFT JOIN session_events e ON e.session = s.id AND e.row = (SELECT max(row) FROM session_events WHERE session = s.id)
LEFT JOIN grades g ON g.session = s.id AND g.row = (SELECT max(row) FROM grades WHERE session = s.id);

-- Lists, newest first: of all, of an exercise, of a student. The columns after `session` are what filters compare.
CREATE INDEX summaries_by_time ON session_summaries
  (listed, started_at, sequence, session, device_class, passed, operator);
CREATE INDEX summaries_of_scenario ON session_summaries
  (listed, scenario, started_at, sequence, session, device_class, passed, operator);
CREATE INDEX summaries_of_student ON session_summaries
  (student, listed, started_at, sequence, session, scenario, device_class, passed, operator);

-- Figures and charts: graded attempts, with every column that they need.
CREATE INDEX graded_by_time ON session_summaries
  (listed, started_at, student, attempt, score, pass_mark, passed, elapsed_us, device_class, operator)
  WHERE score IS NOT NULL;
CREATE INDEX graded_of_scenario ON session_summaries
  (listed, scenario, started_at, student, attempt, score, pass_mark, passed, elapsed_us, device_class, operator)
  WHERE score IS NOT NULL;
CREATE INDEX graded_of_student ON session_summaries
  (student, listed, scenario, started_at, sequence, attempt, score, pass_mark, passed, elapsed_us, device_class, operator)
  WHERE score IS NOT NULL;

CREATE INDEX summaries_of_device_class ON session_summaries (listed, device_class);
CREATE INDEX interrupted_summaries ON session_summaries (student, started_at, sequence) WHERE state = 'interrupted';

-- Opening a file reads these alone, however many sessions and entries it holds.
CREATE INDEX running_summaries ON session_summaries (state) WHERE state = 'running';
CREATE INDEX sealing_of_audit_log ON audit_log (action) WHERE action = 'sealing_began';
