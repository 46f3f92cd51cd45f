-- Schema 16: 1 if an assessment draws a tooth of its own for each candidate; NULL: all have the version's. The seal of a row leaves a
-- NULL here out (storage/records/seals.cpp): the seals of older rows hold.
ALTER TABLE assignments ADD COLUMN drawn_tooth INTEGER CHECK (drawn_tooth = 1);
