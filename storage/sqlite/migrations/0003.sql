-- Schema 3: statements about sessions, the start code of an assessment, withdrawn scenario versions. Every row is final: a
-- statement is taken back by another one. The audit log seals each row (storage/records/seals.h).
CREATE TABLE statements (
  id BLOB PRIMARY KEY CHECK (length(id) = 16),
  session BLOB NOT NULL REFERENCES sessions (id),
  station BLOB NOT NULL CHECK (length(station) = 16),
  author BLOB NOT NULL REFERENCES people (id),
  at INTEGER NOT NULL,
  sequence INTEGER NOT NULL,
  kind TEXT NOT NULL CHECK (kind IN ('comment', 'override_points', 'override_critical', 'confirmation', 'release',
                                     'withdrawal')),
  links INTEGER NOT NULL,
  link BLOB NOT NULL CHECK (length(link) = 32),
  grade INTEGER,
  criterion TEXT NOT NULL DEFAULT '',
  points REAL,
  tick INTEGER,
  where_x_mm REAL,
  where_y_mm REAL,
  where_z_mm REAL,
  withdraws BLOB REFERENCES statements (id),
  text_hash BLOB CHECK (length(text_hash) = 32),
  key BLOB NOT NULL REFERENCES station_keys (id),
  signature BLOB NOT NULL CHECK (length(signature) = 64)
) STRICT, WITHOUT ROWID;
CREATE INDEX statements_of_session ON statements (session, sequence);

-- Free text may name a user: only its salted hash is signed, so that erasing the text leaves the statement whole.
CREATE TABLE statement_texts (
  statement BLOB PRIMARY KEY REFERENCES statements (id),
  salt BLOB NOT NULL CHECK (length(salt) = 32),
  text TEXT NOT NULL
) STRICT, WITHOUT ROWID;

CREATE TABLE assessments (
  assignment BLOB PRIMARY KEY REFERENCES assignments (id),
  start_code TEXT NOT NULL
) STRICT, WITHOUT ROWID;

CREATE TABLE version_withdrawals (
  version BLOB PRIMARY KEY REFERENCES scenario_versions (id),
  author BLOB NOT NULL CHECK (length(author) = 16),
  at INTEGER NOT NULL,
  sequence INTEGER NOT NULL
) STRICT, WITHOUT ROWID;

ALTER TABLE session_summaries ADD COLUMN assignment BLOB;
ALTER TABLE session_summaries ADD COLUMN released INTEGER NOT NULL DEFAULT 1;
UPDATE session_summaries SET
  assignment = (SELECT s.assignment FROM sessions s WHERE s.id = session_summaries.session),
  released = kind <> 'assessment'
  WHERE kind = 'assessment' OR session IN (SELECT id FROM sessions WHERE assignment IS NOT NULL);
CREATE INDEX summaries_of_assignment ON session_summaries (assignment, student, started_at, sequence)
  WHERE assignment IS NOT NULL;
