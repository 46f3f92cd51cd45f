-- Schema 4: extra time of a student in an assignment. Every row is final: the newest one of a student counts. The audit log seals
-- each row (storage/records/seals.h); the header of a session keeps what applied to it.
CREATE TABLE adjustments (
  id BLOB PRIMARY KEY CHECK (length(id) = 16),
  assignment BLOB NOT NULL REFERENCES assignments (id),
  student BLOB NOT NULL REFERENCES people (id),
  extra_time_percent INTEGER NOT NULL CHECK (extra_time_percent BETWEEN 0 AND 400),
  author BLOB NOT NULL REFERENCES people (id),
  at INTEGER NOT NULL,
  sequence INTEGER NOT NULL
) STRICT, WITHOUT ROWID;
CREATE INDEX adjustments_of_assignment ON adjustments (assignment, student, sequence);
