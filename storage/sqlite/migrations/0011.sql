-- Schema 11: how many days old the newest passed self-test of an assessment's device may be; NULL: not asked. The seal of a row
-- leaves a NULL here out (storage/records/seals.cpp): the seals of older rows hold.
ALTER TABLE assignments ADD COLUMN self_test_days INTEGER CHECK (self_test_days >= 1);
