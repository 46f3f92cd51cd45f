-- Schema 1. Times are UTC in µs; ids are UUIDs of 16 bytes, hashes BLAKE2b-256 of 32. Tables keyed by (session, row)
-- count their rows 0, 1, 2 ... within a session and are covered by its chain (storage/session_tables.h); they have no
-- rowid, so that no index besides the rows themselves could disagree with them.
PRAGMA application_id = 1131770736;

CREATE TABLE station (
  one INTEGER PRIMARY KEY CHECK (one = 1),
  id BLOB NOT NULL CHECK (length(id) = 16),
  next_sequence INTEGER NOT NULL
) STRICT;

CREATE TABLE station_keys (
  id BLOB PRIMARY KEY CHECK (length(id) = 32),
  public_key BLOB NOT NULL CHECK (length(public_key) = 32),
  added_at INTEGER NOT NULL
) STRICT, WITHOUT ROWID;

CREATE TABLE people (
  id BLOB PRIMARY KEY CHECK (length(id) = 16),
  number TEXT NOT NULL COLLATE NOCASE UNIQUE,
  name TEXT NOT NULL,
  role TEXT NOT NULL CHECK (role IN ('student', 'instructor', 'administrator')),
  password TEXT NOT NULL DEFAULT '',
  pin TEXT NOT NULL DEFAULT '' CHECK (pin = '' OR role = 'student'),
  disabled INTEGER NOT NULL DEFAULT 0 CHECK (disabled IN (0, 1)),
  guest INTEGER NOT NULL DEFAULT 0 CHECK (guest IN (0, 1)),
  wrong_tries INTEGER NOT NULL DEFAULT 0,
  locked_until INTEGER NOT NULL DEFAULT 0,
  created_at INTEGER NOT NULL
) STRICT;

CREATE TABLE cohorts (
  id BLOB PRIMARY KEY CHECK (length(id) = 16),
  name TEXT NOT NULL COLLATE NOCASE UNIQUE,
  created_at INTEGER NOT NULL
) STRICT;

CREATE TABLE cohort_students (
  cohort BLOB NOT NULL REFERENCES cohorts (id),
  student BLOB NOT NULL REFERENCES people (id),
  PRIMARY KEY (cohort, student)
) STRICT, WITHOUT ROWID;
CREATE INDEX cohorts_of_student ON cohort_students (student);

CREATE TABLE blobs (
  hash BLOB PRIMARY KEY CHECK (length(hash) = 32),
  packed BLOB NOT NULL
) STRICT;

CREATE TABLE scenario_versions (
  id BLOB PRIMARY KEY CHECK (length(id) = 16),
  scenario BLOB NOT NULL CHECK (length(scenario) = 16),
  number INTEGER NOT NULL CHECK (number >= 1),
  key TEXT NOT NULL,
  title TEXT NOT NULL,
  json TEXT NOT NULL,
  content_hash BLOB NOT NULL CHECK (length(content_hash) = 32),
  author BLOB NOT NULL CHECK (length(author) = 16),
  published_at INTEGER NOT NULL,
  sequence INTEGER NOT NULL,
  UNIQUE (scenario, number)
) STRICT;

CREATE TABLE version_files (
  version BLOB NOT NULL REFERENCES scenario_versions (id),
  name TEXT NOT NULL,
  blob BLOB NOT NULL REFERENCES blobs (hash),
  PRIMARY KEY (version, name)
) STRICT, WITHOUT ROWID;

CREATE TABLE scenario_drafts (
  scenario BLOB NOT NULL CHECK (length(scenario) = 16),
  author BLOB NOT NULL REFERENCES people (id),
  json TEXT NOT NULL,
  saved_at INTEGER NOT NULL,
  PRIMARY KEY (scenario, author)
) STRICT, WITHOUT ROWID;

CREATE TABLE assignments (
  id BLOB PRIMARY KEY CHECK (length(id) = 16),
  version BLOB NOT NULL REFERENCES scenario_versions (id),
  cohort BLOB NOT NULL REFERENCES cohorts (id),
  kind TEXT NOT NULL CHECK (kind IN ('practice', 'assessment')),
  opens_at INTEGER,
  due_at INTEGER,
  goes_allowed INTEGER CHECK (goes_allowed >= 1),
  author BLOB NOT NULL REFERENCES people (id),
  created_at INTEGER NOT NULL,
  sequence INTEGER NOT NULL
) STRICT;
CREATE INDEX assignments_of_cohort ON assignments (cohort);

CREATE TABLE sessions (
  id BLOB PRIMARY KEY CHECK (length(id) = 16),
  station BLOB NOT NULL CHECK (length(station) = 16),
  student BLOB NOT NULL REFERENCES people (id),
  version BLOB NOT NULL REFERENCES scenario_versions (id),
  version_hash BLOB NOT NULL CHECK (length(version_hash) = 32),
  json_hash BLOB NOT NULL CHECK (length(json_hash) = 32),
  kind TEXT NOT NULL CHECK (kind IN ('practice', 'assessment', 'try_it', 'try_out')),
  assignment BLOB REFERENCES assignments (id),
  hand TEXT NOT NULL,
  device TEXT NOT NULL,
  device_class TEXT NOT NULL,
  engine_version INTEGER NOT NULL,
  specimen_blob BLOB NOT NULL CHECK (length(specimen_blob) = 32),
  header TEXT NOT NULL,
  started_at INTEGER NOT NULL,
  sequence INTEGER NOT NULL
) STRICT, WITHOUT ROWID;
CREATE INDEX sessions_of_student ON sessions (student, started_at);
CREATE INDEX sessions_of_version ON sessions (version);

CREATE TABLE session_events (
  session BLOB NOT NULL REFERENCES sessions (id),
  row INTEGER NOT NULL CHECK (row >= 0),
  kind TEXT NOT NULL CHECK (kind IN ('started', 'interrupted', 'resumed', 'finished', 'graded', 'closed')),
  at INTEGER NOT NULL,
  sequence INTEGER NOT NULL,
  tick INTEGER NOT NULL,
  reason TEXT NOT NULL,
  process TEXT NOT NULL,
  PRIMARY KEY (session, row)
) STRICT, WITHOUT ROWID;

CREATE TABLE trace_chunks (
  session BLOB NOT NULL REFERENCES sessions (id),
  row INTEGER NOT NULL CHECK (row >= 0),
  first_tick INTEGER NOT NULL CHECK (first_tick >= 1),
  inputs INTEGER NOT NULL CHECK (inputs >= 1),
  elapsed_us INTEGER NOT NULL,
  state_hash INTEGER,
  trace BLOB NOT NULL,
  PRIMARY KEY (session, row)
) STRICT, WITHOUT ROWID;

CREATE TABLE key_states (
  session BLOB NOT NULL REFERENCES sessions (id),
  row INTEGER NOT NULL CHECK (row >= 0),
  tick INTEGER NOT NULL,
  state BLOB NOT NULL,
  PRIMARY KEY (session, row)
) STRICT, WITHOUT ROWID;

CREATE TABLE metrics (
  session BLOB NOT NULL REFERENCES sessions (id),
  row INTEGER NOT NULL CHECK (row >= 0),
  elapsed_us INTEGER NOT NULL,
  force_peak_n REAL,
  force_mean_n REAL,
  contact_ticks INTEGER NOT NULL,
  cutting_ticks INTEGER NOT NULL,
  PRIMARY KEY (session, row)
) STRICT, WITHOUT ROWID;

CREATE TABLE removed_tissues (
  session BLOB NOT NULL REFERENCES sessions (id),
  row INTEGER NOT NULL CHECK (row >= 0),
  chunk INTEGER NOT NULL,
  tissue INTEGER NOT NULL CHECK (tissue BETWEEN 1 AND 31),
  voxels INTEGER NOT NULL,
  mm3 REAL,
  PRIMARY KEY (session, row)
) STRICT, WITHOUT ROWID;

CREATE TABLE final_volumes (
  session BLOB NOT NULL REFERENCES sessions (id),
  row INTEGER NOT NULL CHECK (row = 0),
  tick INTEGER NOT NULL,
  volume_hash INTEGER NOT NULL,
  cuts BLOB NOT NULL,
  PRIMARY KEY (session, row)
) STRICT, WITHOUT ROWID;

CREATE TABLE grades (
  session BLOB NOT NULL REFERENCES sessions (id),
  row INTEGER NOT NULL CHECK (row >= 0),
  at INTEGER NOT NULL,
  sequence INTEGER NOT NULL,
  grader BLOB NOT NULL CHECK (length(grader) = 16),
  score REAL,
  score_max REAL,
  pass_mark REAL,
  passed INTEGER NOT NULL CHECK (passed IN (0, 1)),
  critical TEXT NOT NULL,
  rubric_hash BLOB NOT NULL CHECK (length(rubric_hash) = 32),
  evaluator TEXT NOT NULL,
  engine_version INTEGER NOT NULL,
  device_class TEXT NOT NULL,
  calibration TEXT NOT NULL,
  PRIMARY KEY (session, row)
) STRICT, WITHOUT ROWID;

CREATE TABLE criteria (
  session BLOB NOT NULL REFERENCES sessions (id),
  row INTEGER NOT NULL CHECK (row >= 0),
  grade INTEGER NOT NULL,
  id TEXT NOT NULL,
  metric TEXT NOT NULL,
  measured INTEGER NOT NULL CHECK (measured IN (0, 1)),
  value REAL,
  uncertainty REAL,
  unit TEXT NOT NULL,
  where_x_mm REAL,
  where_y_mm REAL,
  where_z_mm REAL,
  band TEXT NOT NULL,
  points REAL,
  points_max REAL,
  reason_code TEXT NOT NULL,
  reason_args TEXT NOT NULL,
  PRIMARY KEY (session, row),
  FOREIGN KEY (session, grade) REFERENCES grades (session, row)
) STRICT, WITHOUT ROWID;

CREATE TABLE session_chain (
  session BLOB NOT NULL REFERENCES sessions (id),
  position INTEGER NOT NULL CHECK (position >= 0),
  table_number INTEGER NOT NULL,
  row INTEGER NOT NULL,
  second INTEGER NOT NULL,
  content BLOB NOT NULL CHECK (length(content) = 32),
  link BLOB NOT NULL CHECK (length(link) = 32),
  PRIMARY KEY (session, position)
) STRICT, WITHOUT ROWID;

CREATE TABLE session_heads (
  session BLOB PRIMARY KEY REFERENCES sessions (id),
  links INTEGER NOT NULL,
  link BLOB NOT NULL CHECK (length(link) = 32),
  key BLOB NOT NULL REFERENCES station_keys (id),
  signature BLOB NOT NULL CHECK (length(signature) = 64)
) STRICT, WITHOUT ROWID;

CREATE TABLE comments (
  id BLOB PRIMARY KEY CHECK (length(id) = 16),
  session BLOB NOT NULL REFERENCES sessions (id),
  author BLOB NOT NULL REFERENCES people (id),
  at INTEGER NOT NULL,
  sequence INTEGER NOT NULL,
  tick INTEGER,
  text TEXT NOT NULL
) STRICT;
CREATE INDEX comments_of_session ON comments (session);

CREATE TABLE audit_log (
  number INTEGER PRIMARY KEY,
  at INTEGER NOT NULL,
  sequence INTEGER NOT NULL,
  actor BLOB NOT NULL CHECK (length(actor) = 16),
  action TEXT NOT NULL,
  subject BLOB NOT NULL CHECK (length(subject) = 16),
  detail TEXT NOT NULL,
  link BLOB NOT NULL CHECK (length(link) = 32)
) STRICT;

CREATE TABLE audit_head (
  one INTEGER PRIMARY KEY CHECK (one = 1),
  entries INTEGER NOT NULL,
  link BLOB NOT NULL CHECK (length(link) = 32),
  key BLOB NOT NULL REFERENCES station_keys (id),
  signature BLOB NOT NULL CHECK (length(signature) = 64)
) STRICT;
