-- Schema 15: seals of sessions are most entries of the audit log. They have indexes of their own, without the action that all of
-- them have, and in place of a session's whole id the 48 bits of its start that begin it. A seal by the program is read by time.
DROP INDEX audit_by_action;
DROP INDEX audit_by_actor;
DROP INDEX audit_by_subject;
CREATE INDEX audit_by_action ON audit_log (action, at) WHERE action <> 'session_sealed';
CREATE INDEX audit_by_actor ON audit_log (actor, action, at) WHERE action <> 'session_sealed';
CREATE INDEX audit_by_subject ON audit_log (subject, action, at) WHERE action <> 'session_sealed';
CREATE INDEX seals_by_time ON audit_log (at) WHERE action = 'session_sealed';
CREATE INDEX seals_by_actor ON audit_log (actor, at)
  WHERE action = 'session_sealed' AND actor <> x'00000000000000000000000000000000';
CREATE INDEX seals_of_session ON audit_log (substr(subject, 1, 6)) WHERE action = 'session_sealed';

-- No statement reads these: lists of a version read summaries_of_scenario.
DROP INDEX sessions_of_version;
