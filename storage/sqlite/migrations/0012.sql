-- Schema 12: a student's own assessment is a further kind of statement. The table is made anew with the same rows, for SQLite
-- changes no CHECK; their content, and so their signatures and seals, stay.
CREATE TABLE statements_12 (
  id BLOB PRIMARY KEY CHECK (length(id) = 16),
  session BLOB NOT NULL REFERENCES sessions (id),
  station BLOB NOT NULL CHECK (length(station) = 16),
  author BLOB NOT NULL REFERENCES people (id),
  at INTEGER NOT NULL,
  sequence INTEGER NOT NULL,
  kind TEXT NOT NULL CHECK (kind IN ('comment', 'override_points', 'override_critical', 'confirmation', 'release',
                                     'withdrawal', 'self_assessment')),
  links INTEGER NOT NULL,
  link BLOB NOT NULL CHECK (length(link) = 32),
  grade INTEGER,
  criterion TEXT NOT NULL DEFAULT '',
  points REAL,
  tick INTEGER,
  where_x_mm REAL,
  where_y_mm REAL,
  where_z_mm REAL,
  withdraws BLOB REFERENCES statements_12 (id),
  text_hash BLOB CHECK (length(text_hash) = 32),
  key BLOB NOT NULL REFERENCES station_keys (id),
  signature BLOB NOT NULL CHECK (length(signature) = 64)
) STRICT, WITHOUT ROWID;
INSERT INTO statements_12 SELECT * FROM statements;
DROP TABLE statements;
ALTER TABLE statements_12 RENAME TO statements;
CREATE INDEX statements_of_session ON statements (session, sequence);
