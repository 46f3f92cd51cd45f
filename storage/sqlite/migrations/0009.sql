-- Schema 9: larger text for a student in an assignment, beside the extra time; NULL in rows from before. The seal of a row leaves a
-- NULL here out (storage/records/seals.cpp): the seals of older rows hold.
ALTER TABLE adjustments ADD COLUMN large_text INTEGER CHECK (large_text IN (0, 1));
