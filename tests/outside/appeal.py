"""An appeal pack: a student's attempt leaves its station as one file, and another station opens and verifies it.

  appeal.py CUSP
"""
import argparse
import contextlib
import io
import json
import os
import sqlite3
import sys
import tarfile
import uuid

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from desk import Desk, check, one_sentence  # noqa: E402
from records import PIN, STUDENT, make_school  # noqa: E402

ADMIN = {"CUSP_PASSWORD": "correct horse"}
FILES = ["pack.json", "pack.sig", "records.db", "log.csv", "report.pdf", "report.json", "tooth.png", "tooth.nrrd"]


def verified(desk, *arguments):
    status, out, err = desk.run("verify", *arguments, "--json", "-")
    return status, json.loads(out) if out else {}, err


def packed(database):
    """What the audit log holds of packs."""
    with contextlib.closing(sqlite3.connect(database)) as db:
        return db.execute("SELECT count(*) FROM audit_log WHERE action = 'packed'").fetchone()[0]


def pack(desk, database, session):
    file = desk.path("case.cusppack")
    status, _, err = desk.run("appeal", database, session, file, "--as", STUDENT, CUSP_PASSWORD=PIN)
    one_sentence(err, "a student's appeal pack")
    check(status == 1 and not os.path.exists(file), "a student packs an attempt")
    status, out, err = desk.run("appeal", database, session, desk.path("none") + "/case.cusppack", "--as", "admin", **ADMIN)
    one_sentence(err, "a pack to a folder that is not there")
    check(status == 1, out)
    status, out, err = desk.run("appeal", database, session, database, "--as", "admin", **ADMIN)
    check(status == 1, f"a pack over the records: {out}{err}")
    check(packed(database) == 0, "the audit log names a pack that was not written")
    status, out, err = desk.run("appeal", database, session, file, "--as", "admin", **ADMIN)
    check(status == 0, f"appeal: {out}{err}")
    check(packed(database) == 1, "the audit log names the pack")
    with open(file, "rb") as f:
        whole = f.read()
    status, out, err = desk.run("appeal", database, session, file, "--as", "admin", **ADMIN)
    one_sentence(err, "a pack over another")
    check(status == 1 and "there already" in err, f"a pack over another: {out}{err}")
    with open(file, "rb") as f:
        check(f.read() == whole, "a pack that was there is written over")
    return file


def finishes_a_killed_one(desk, database, session, file):
    """As a program leaves it that is killed between the entry and the name: the pack and a note of its name, in a folder of their own."""
    with open(file, "rb") as f:
        whole = f.read()
    before = packed(database)
    left = desk.path(f".cusp-copy-{uuid.uuid4()}")
    os.mkdir(left)
    os.rename(file, os.path.join(left, "copy.db"))
    with open(os.path.join(left, "copy.db.name"), "w", encoding="utf-8") as f:
        f.write("another boot:1:1\n" + os.path.basename(file))
    status, out, err = desk.run("appeal", database, session, file, "--as", "admin", **ADMIN)
    one_sentence(err, "a pack whose program was killed")
    check(status == 1 and "now finished" in err, f"a pack whose program was killed: {out}{err}")
    with open(file, "rb") as f:
        check(f.read() == whole, "the killed pack is not the file")
    check(not os.path.exists(left) and packed(database) == before, "a copy or an entry more is left")


def opens_elsewhere(desk, database, session, file):
    elsewhere = desk.path("elsewhere.db")
    make_school(elsewhere)
    status, seen, err = verified(desk, file, "--replay")
    check(status == 0 and seen["whole"] and not seen["known_key"], f"verify: {seen}{err}")
    check(seen["replayed"] and seen["replay_holds"], f"the replay of the pack: {seen}")
    check(seen["session"] == session and seen["score"] is not None, f"{seen}")
    status, seen, err = verified(desk, file, "--db", database)
    check(status == 0 and seen["known_key"], f"the station does not know its own pack: {seen}{err}")
    for records, says in ((database, "station of this database signed"), (elsewhere, "does not know the key")):
        status, out, err = desk.run("verify", file, "--db", records)
        check(status == 0 and says in out, f"whose pack it is: {out}{err}")
    with open(file, "rb") as f:
        whole = f.read()
    status, out, err = desk.run("verify", file, "--json", file)
    one_sentence(err, "the JSON over the pack")
    with open(file, "rb") as f:
        check(status == 1 and f.read() == whole, f"the JSON over the pack: {out}{err}")
    with tarfile.open(file) as tar:
        check(tar.getnames() == FILES, f"in the pack: {tar.getnames()}")
        report = json.load(tar.extractfile("report.json"))
        records = tar.extractfile("records.db").read()
        log = tar.extractfile("log.csv").read().decode()
    check(report["session"] == session, f"report.json is of another attempt: {report}")
    for secret in (b"$argon2", b"okafor"):
        check(secret not in records, f"the records of a pack hold {secret}")
    check("session_sealed" in log, f"log.csv: {log}")


def changed(file, to, change):
    """A copy of the archive in which change(name, bytes) stands for each file; None leaves it out."""
    with tarfile.open(file) as tar:
        contents = [(m.name, tar.extractfile(m).read()) for m in tar.getmembers()]
    with tarfile.open(to, "w", format=tarfile.USTAR_FORMAT) as tar:
        for name, content in contents:
            content = change(name, content)
            if content is None:
                continue
            info = tarfile.TarInfo(name)
            info.size = len(content)
            tar.addfile(info, io.BytesIO(content))


def shows_every_change(desk, file):
    other = desk.path("changed.cusppack")
    for name in FILES[2:]:
        changed(file, other, lambda n, c, name=name: c + b"x" if n == name else c)
        status, seen, err = verified(desk, other)
        check(status == 1 and (not seen or seen["differing_files"] == [name]), f"{name} changed: {seen}{err}")
    changed(file, other, lambda n, c: bytes(len(c)) if n == "records.db" else c)
    status, seen, err = verified(desk, other)
    check(status == 1 and seen["differing_files"] == ["records.db"] and "records.db" in err, f"records of zeros: {seen}{err}")
    changed(file, other, lambda n, c: c.replace(b'"made_at": 1', b'"made_at": 2') if n == "pack.json" else c)
    status, seen, _ = verified(desk, other)
    check(status == 1 and not seen["signature_holds"], f"another time: {seen}")
    changed(file, other, lambda n, c: None if n == "log.csv" else c)
    status, seen, _ = verified(desk, other)
    check(status == 1 and seen["differing_files"] == ["log.csv"], f"without the log: {seen}")


def refuses_what_is_no_pack(desk, file):
    with open(file, "rb") as f:
        whole = f.read()
    other = desk.path("no.cusppack")
    for name, content in (("empty", b""), ("text", b"hello"), ("cut off", whole[:len(whole) // 2]), ("zeros", bytes(4096))):
        with open(other, "wb") as f:
            f.write(content)
        status, _, err = desk.run("verify", other)
        one_sentence(err, name)
        check(status == 1, f"{name}: exit {status}")
    for left_out in FILES[:3]:
        changed(file, other, lambda n, c, left_out=left_out: None if n == left_out else c)
        status, _, err = desk.run("verify", other)
        one_sentence(err, f"without {left_out}")
        check(status == 1, f"without {left_out}: exit {status}")
    status, _, err = desk.run("verify", desk.path("nothing-there"))
    one_sentence(err, "no file")
    check(status == 1, "no file")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("cusp")
    with Desk(parser.parse_args().cusp) as desk:
        database = desk.path("school.db")
        make_school(database)
        status, out, err = desk.run("play", desk.small_exercise(), "--script", desk.small_script(6),
                                    "--db", database, "--as", STUDENT, "--out", desk.path("out"), CUSP_PASSWORD=PIN)
        check(status == 0, f"play: {err}")
        session = out.strip()
        file = pack(desk, database, session)
        finishes_a_killed_one(desk, database, session, file)
        opens_elsewhere(desk, database, session, file)
        shows_every_change(desk, file)
        refuses_what_is_no_pack(desk, file)
        status, out, err = desk.run("history", database, "verify", "--as", "admin", **ADMIN)
        check(status == 0, f"after packing: {out}{err}")
        print(f"a pack of {os.path.getsize(file) / 1e6:.1f} MB, verified, replayed, and every change of it named")


if __name__ == "__main__":
    main()
