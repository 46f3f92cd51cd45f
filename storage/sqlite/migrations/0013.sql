-- Schema 13: the criteria of a grade are one row (storage/records/grade_rows.h) and one entry of the session's chain; grades of older
-- schemas keep theirs in `criteria`. The column sessions.header of a new session holds the hash of its JSON in `blobs`, in hex, for
-- many sessions have the same.
CREATE TABLE graded_criteria (
  session BLOB NOT NULL,
  row INTEGER NOT NULL CHECK (row >= 0),
  packed BLOB NOT NULL,
  PRIMARY KEY (session, row),
  FOREIGN KEY (session, row) REFERENCES grades (session, row)
) STRICT, WITHOUT ROWID;
