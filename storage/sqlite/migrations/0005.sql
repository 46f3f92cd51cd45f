-- Schema 5: a page of the audit log is read along one of these, for each kind of entry that the filter admits
-- (storage/repositories/audit_log.cpp).
CREATE INDEX audit_by_action ON audit_log (action, at);
CREATE INDEX audit_by_actor ON audit_log (actor, action, at);
CREATE INDEX audit_by_subject ON audit_log (subject, action, at);
