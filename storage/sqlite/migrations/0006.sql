-- Schema 6: what files carry from station to station (storage/exchange/README.md). The audit log seals each row
-- (storage/records/seals.h).
-- Public keys of other stations; every other row of station_keys is this station's own.
CREATE TABLE other_keys (
  id BLOB PRIMARY KEY CHECK (length(id) = 16),
  station BLOB NOT NULL CHECK (length(station) = 16),
  key BLOB NOT NULL UNIQUE REFERENCES station_keys (id),
  role TEXT NOT NULL CHECK (role IN ('station', 'office', 'former', 'revoked')),
  changed_at INTEGER NOT NULL
) STRICT, WITHOUT ROWID;

-- Accounts, versions and assignments that records of another station refer to; `here`: they have arrived since for this
-- station's own use.
CREATE TABLE referred (
  id BLOB PRIMARY KEY CHECK (length(id) = 16),
  here INTEGER NOT NULL CHECK (here IN (0, 1))
) STRICT, WITHOUT ROWID;
