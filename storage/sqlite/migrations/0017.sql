-- Schema 17: an assignment that was withdrawn admits no further attempt; those that were begun stay. The audit log seals each row
-- (storage/records/seals.h).
CREATE TABLE assignment_withdrawals (
  assignment BLOB PRIMARY KEY REFERENCES assignments (id),
  author BLOB NOT NULL CHECK (length(author) = 16),
  at INTEGER NOT NULL,
  sequence INTEGER NOT NULL
) STRICT, WITHOUT ROWID;
