-- Schema 7: attempts whose recording was thinned (storage/retention/README.md). The session's chain keeps the hash of every
-- row that went; this row, signed by the session's station, stands for them. The audit log seals it (storage/records/seals.h).
CREATE TABLE thinned_traces (
  session BLOB PRIMARY KEY REFERENCES sessions (id),
  station BLOB NOT NULL CHECK (length(station) = 16),
  author BLOB NOT NULL CHECK (length(author) = 16),
  at INTEGER NOT NULL,
  links INTEGER NOT NULL CHECK (links >= 1),
  link BLOB NOT NULL CHECK (length(link) = 32),
  key BLOB NOT NULL REFERENCES station_keys (id),
  signature BLOB NOT NULL CHECK (length(signature) = 64)
) STRICT, WITHOUT ROWID;
