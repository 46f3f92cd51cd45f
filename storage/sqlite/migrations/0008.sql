-- Schema 8: the device classes that an assignment admits, in order, with a space between two; NULL admits every one. The seal of a
-- row leaves a NULL here out (storage/records/seals.cpp): the seals of older rows hold.
ALTER TABLE assignments ADD COLUMN device_classes TEXT CHECK (device_classes <> '');
