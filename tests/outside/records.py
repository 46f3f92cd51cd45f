"""The database of a small school, tampered with by SQL: `cusp history verify` names what and whom, and exits with 1.
Accounts act by password or PIN; a secret of the wrong kind is no wrong try and is called by its name.

  records.py CUSP
"""
import argparse
import contextlib
import json
import os
import shutil
import sqlite3
import subprocess
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from desk import HUNG_S, SOURCE, Desk, check, one_sentence  # noqa: E402

STUDENT, PIN, PASSWORD = "20267314", "314159", "battery staple"


def make_school(database):
    """A file of schema 1: an administrator, a student with password and PIN, an instructor, one graded session."""
    with contextlib.closing(sqlite3.connect(database)) as db:
        for name in ("storage/sqlite/migrations/0001.sql", "tests/storage/fixtures/schema-0001.sql"):
            with open(os.path.join(SOURCE, name), encoding="utf-8") as sql:
                db.executescript(sql.read())
        db.executescript("PRAGMA user_version = 1")


def tampered(desk, *statements):
    for end in ("", ".key", ".key-counter"):
        shutil.copy(desk.path("school.db") + end, desk.path("bad.db") + end)
    with contextlib.closing(sqlite3.connect(desk.path("bad.db"))) as db:
        db.execute("PRAGMA foreign_keys = OFF")
        db.executescript(";".join(statements))
    return desk.path("bad.db")


def verify_names(desk):
    session = session_of(desk.path("school.db"))
    whole = [f"DELETE FROM {t} WHERE 1" for t in (
        "sessions", "session_events", "trace_chunks", "key_states", "metrics", "removed_tissues", "final_volumes",
        "grades", "criteria", "graded_criteria", "session_chain", "session_heads", "comments")]
    cases = [
        (whole, ("sessions", session)),
        (["DELETE FROM audit_log", "DELETE FROM audit_head"], ("audit_log",)),
        (["UPDATE people SET role = 'administrator', pin = '' WHERE number = 'okafor'"], ("people", "role")),
        (["UPDATE people SET password = '' WHERE number = 'admin'"], ("people", "password")),
    ]
    for statements, parts in cases:
        database = tampered(desk, *statements)
        status, out, err = desk.run("history", database, "verify", "--as", STUDENT, CUSP_PASSWORD=PIN)
        check(status == 1 and all(part in out for part in parts), f"{statements[0]}: exit {status}, not all of {parts}: {out}{err}")
        status, out, _ = desk.run("history", database, "verify", "--as", STUDENT, "--json", "-", CUSP_PASSWORD=PIN)
        check(status == 1 and parts[0] in out and '"intact": false' in out, f"{statements[0]}: {out}")
        check("okafor" not in out and '"admin"' not in out, f"{statements[0]}: a student reads another's number: {out}")
    database = tampered(desk, "UPDATE people SET role = 'administrator' WHERE number = 'okafor'")
    status, out, err = desk.run("history", database, "verify", "--as", "admin", CUSP_PASSWORD="correct horse")
    check(status == 1 and "people" in out and "okafor" in out, f"an administrator does not read whose role was changed: {out}{err}")


def rebuild(desk):
    """What lists show differs from the records: it is named, and an administrator makes the lists anew."""
    database = tampered(desk, "UPDATE session_summaries SET score = 100, passed = 0")
    as_student, as_admin = ("--as", STUDENT), ("--as", "admin")
    status, out, _ = desk.run("history", database, "verify", *as_student, CUSP_PASSWORD=PIN)
    check(status == 1 and "session_summaries, score" in out and "session_summaries, passed" in out, f"a changed summary: {out}")
    status, _, err = desk.run("history", database, "rebuild", *as_student, CUSP_PASSWORD=PIN)
    check(status == 1, f"a student rebuilds: {err}")
    status, out, err = desk.run("history", database, "rebuild", "--json", "-", *as_admin, CUSP_PASSWORD="correct horse")
    check(status == 0 and json.loads(out)["differences"] == 2, f"rebuild: {out}{err}")
    status, out, err = desk.run("history", database, "verify", *as_student, CUSP_PASSWORD=PIN)
    check(status == 0, f"after the rebuild: {out}{err}")


def backups(desk, database):
    """An administrator makes a backup; restored to a new name it is whole, and nothing is overwritten."""
    into = desk.path("backups")
    status, _, err = desk.run("backup", database, into, "--as", STUDENT, CUSP_PASSWORD=PIN)
    check(status == 1 and not os.path.exists(into), f"a student makes a backup: {err}")
    status, out, err = desk.run("backup", database, into, "--as", "admin", "--json", "-", CUSP_PASSWORD="correct horse")
    check(status == 0 and json.loads(out)["sessions"] == 1, f"backup: {out}{err}")
    folder = json.loads(out)["folder"]
    status, _, err = desk.run("restore", folder, database)
    one_sentence(err, "restoring over a database")
    check(status == 1 and "there already" in err, err)
    status, out, err = desk.run("restore", folder, desk.path("restored.db"))
    check(status == 0, f"restore: {out}{err}")
    status, out, err = desk.run("history", desk.path("restored.db"), "verify", "--as", STUDENT, CUSP_PASSWORD=PIN)
    check(status == 0, f"the restored school is not whole: {out}{err}")
    with open(os.path.join(folder, "backup.json"), encoding="utf-8") as f:
        description = json.load(f)
    for part, content, names in (("station.db.key", "short", "damaged"), ("backup.json", json.dumps({**description, "sessions": 7}), "attempts")):
        damaged = desk.path("damaged " + part)
        shutil.copytree(folder, damaged)
        with open(os.path.join(damaged, part), "w", encoding="utf-8") as f:
            f.write(content)
        status, out, err = desk.run("restore", damaged, desk.path("again.db"))
        one_sentence(err, f"a backup with a damaged {part}")
        left = [name for name in os.listdir(desk.folder) if name.startswith(("again.db", ".cusp-restore"))]
        check(status == 1 and out == "" and left == [] and names in err, f"a backup with a damaged {part} left {left}: {err}")
    os.remove(os.path.join(folder, "backup.json"))
    status, _, err = desk.run("restore", folder, desk.path("again.db"))
    check(status == 1 and "no whole backup" in err and not os.path.exists(desk.path("again.db")), err)


def demo_account(desk):
    """Without --as a verb acts as the student demo, unless that is switched off or has a secret."""
    demo = desk.path("demo.db")
    for end in ("", ".key", ".key-counter"):
        shutil.copy(desk.path("restored.db") + end, demo + end)
    with contextlib.closing(sqlite3.connect(demo)) as db:
        db.execute("INSERT INTO people (id, number, name, role, created_at) VALUES (randomblob(16), 'demo', 'demo', 'student', 0)")
        db.commit()
    listed = ("history", demo, "list")
    check(desk.run(*listed)[0] == 0, "demo reads its own attempts")
    for change, says in (("disabled = 1", "switched off"), ("disabled = 0, password = 'x'", "password")):
        with contextlib.closing(sqlite3.connect(demo)) as db:
            db.execute(f"UPDATE people SET {change} WHERE number = 'demo'")
            db.commit()
        status, out, err = desk.run(*listed)
        one_sentence(err, f"demo with {change}")
        check(status == 1 and says in err and not out, f"demo with {change}: exit {status}: {out}{err}")


def erasure(desk, database):
    """An administrator erases the student: the records verify, and the file holds the name no more."""
    for end in ("", ".key", ".key-counter"):
        shutil.copy(desk.path("restored.db") + end, desk.path("erased.db") + end)
    erased = desk.path("erased.db")
    status, _, err = desk.run("erase", erased, STUDENT, "--as", STUDENT, CUSP_PASSWORD=PIN)
    check(status == 1, f"a student erases: {err}")
    status, _, err = desk.run("erase", erased, "nobody", "--as", "admin", CUSP_PASSWORD="correct horse")
    one_sentence(err, "erasing an unknown number")
    nowhere = os.path.join(desk.path("no folder"), "erased.json")
    status, out, err = desk.run("erase", erased, STUDENT, "--json", nowhere, "--as", "admin", CUSP_PASSWORD="correct horse")
    one_sentence(err, "a pseudonym that cannot be written to a file")
    check(status == 1 and "The person is erased." in out, f"erase: exit {status}: {out}{err}")
    status, out, err = desk.run("history", erased, "verify", "--as", "admin", CUSP_PASSWORD="correct horse")
    check(status == 0, f"after an erasure: {out}{err}")
    with open(erased, "rb") as f:
        content = f.read()
    check(b"Lena Brandt" not in content and STUDENT.encode() not in content, "the file still holds the name or number")


def rows(database, table):
    with contextlib.closing(sqlite3.connect(database)) as db:
        return db.execute(f"SELECT count(*) FROM {table}").fetchone()[0]


def thinning(desk, database):
    """The recording of the one attempt goes, once; the records verify. One that was changed is named and stays."""
    as_admin, secret = ("--as", "admin"), {"CUSP_PASSWORD": "correct horse"}
    for name in ("thinned.db", "changed.db"):
        for end in ("", ".key", ".key-counter"):
            shutil.copy(desk.path("restored.db") + end, desk.path(name) + end)
    thinned, changed = desk.path("thinned.db"), desk.path("changed.db")
    recent = ("thin", thinned, "--older-than", "1", "--clock-is-right", "--json", "-")  # the attempt is of 20 November 2026
    status, _, err = desk.run(*recent, "--as", STUDENT, CUSP_PASSWORD=PIN)
    one_sentence(err, "a student thins")
    check(status == 1 and rows(thinned, "trace_chunks") == 3, f"a student thins: {err}")
    check(desk.run("thin", thinned, "--older-than", "0", *as_admin, **secret)[0] == 2, "0 days are wrong usage")
    nowhere = ("--json", desk.path("no folder", "thinned.json"))  # what went is named all the same
    status, out, err = desk.run("thin", thinned, "--older-than", "36500", "--clock-is-right", *nowhere, *as_admin, **secret)
    check(status == 1 and "0 recording" in out and nowhere[1] in err, f"nothing is a hundred years old: {out}{err}")
    status, out, err = desk.run("thin", thinned, "--older-than", "0100", "--dry-run", "--clock-is-right", "--json", "-", *as_admin, **secret)
    check(status == 0 and json.loads(out)["older_than_days"] == 100, f"a hundred days with a zero in front: {out}{err}")
    status, out, err = desk.run(*recent, "--dry-run", *as_admin, **secret)
    would = json.loads(out)
    check(status == 0 and would["attempts"] == 1 and would["dry_run"], f"a dry run: {out}{err}")
    check(rows(thinned, "trace_chunks") == 3 and rows(thinned, "thinned_traces") == 0, "a dry run changed something")
    status, out, err = desk.run(*recent, *as_admin, **secret)
    did = json.loads(out)
    check(status == did["failed"] == did["left"] == 0 and did["attempts"] == 1 and did["bytes"] == would["bytes"] > 0, f"thin: {out}{err}")
    check(rows(thinned, "trace_chunks") == rows(thinned, "key_states") == 0 and rows(thinned, "grades") == 1, "what thinning took")
    status, out, err = desk.run("history", thinned, "verify", *as_admin, **secret)
    check(status == 0, f"after thinning: {out}{err}")
    check(json.loads(desk.run(*recent, *as_admin, **secret)[1])["attempts"] == 0, "a recording is thinned once")
    with contextlib.closing(sqlite3.connect(thinned)) as db:
        db.execute("DELETE FROM thinned_traces")
        db.commit()
    status, out, _ = desk.run("history", thinned, "verify", *as_admin, **secret)
    check(status == 1 and "trace_chunks" in out and "thinned_traces" in out, f"a thinning without its row: {out}")
    with contextlib.closing(sqlite3.connect(changed)) as db:
        db.execute("UPDATE grades SET score = 100")
        db.commit()
    status, out, err = desk.run("thin", changed, "--older-than", "1", "--clock-is-right", "--json", "-", *as_admin, **secret)
    one_sentence(err, "an attempt that was changed")
    seen = json.loads(out)
    check(status == 1 and seen["kept"]["broken"] == 1 and seen["broken"][0]["table"] == "grades", f"{out}{err}")
    check(rows(changed, "trace_chunks") == 3, "an attempt that was changed is thinned")


def retention(desk, database):
    as_admin, secret = ("--as", "admin"), {"CUSP_PASSWORD": "correct horse"}
    restored = desk.path("restored.db")
    check(desk.run("retain", restored, "--dry-run", *as_admin, **secret)[0] == 2, "the school says how many years")
    status, _, err = desk.run("retain", restored, "--years", "100", "--as", STUDENT, CUSP_PASSWORD=PIN)
    one_sentence(err, "a student erases by years")
    check(status == 1, f"a student erases by years: {err}")
    for dry in (("--dry-run",), ()):
        status, out, err = desk.run("retain", restored, "--years", "100", "--clock-is-right", "--json", "-", *dry, *as_admin, **secret)
        check(status == 0 and json.loads(out)["erased"] == [], f"nobody is gone for a hundred years: {out}{err}")
    for typed, years in (("010", 10), ("08", 8)):
        status, out, err = desk.run("retain", restored, "--years", typed, "--clock-is-right", "--json", "-", "--dry-run", *as_admin, **secret)
        check(status == 0 and json.loads(out)["years"] == years, f"{typed} years: {out}{err}")
    with contextlib.closing(sqlite3.connect(restored)) as db:
        half_a_year_and_more = 200 * 86_400_000_000
        db.execute("UPDATE people SET created_at = created_at - ?", (half_a_year_and_more,))
        db.execute("UPDATE sessions SET started_at = started_at - ?", (half_a_year_and_more,))
        db.commit()
    for verb in (("retain", restored, "--years", "100"), ("thin", restored, "--older-than", "36500")):
        for dry in (("--dry-run",), ()):
            status, out, err = desk.run(*verb, *dry, *as_admin, **secret)
            one_sentence(err, "a clock in doubt")
            check(status == 1 and "--clock-is-right" in err and not out, f"{verb[0]} with a clock in doubt: exit {status}: {out}{err}")
    with contextlib.closing(sqlite3.connect(restored)) as db:
        two_years = 731 * 86_400_000_000
        db.execute("UPDATE people SET created_at = created_at - ?", (two_years,))
        db.execute("UPDATE sessions SET started_at = started_at - ?", (two_years,))
        db.execute("UPDATE audit_log SET at = at - ?", (two_years,))
        db.commit()
    nowhere = os.path.join(desk.path("no folder"), "erased.json")
    status, out, err = desk.run("retain", restored, "--years", "2", "--clock-is-right", "--json", nowhere, *as_admin, **secret)
    one_sentence(err, "a list of the erased that cannot be written")
    check(status == 1 and f"{STUDENT}  20" in out, f"nobody reads who was erased: exit {status}: {out}{err}")


def secrets(desk, database):
    listed = ("history", database, "list", "--as")
    check(desk.run(*listed, STUDENT, CUSP_PASSWORD=PIN)[0] == 0, "a PIN signs a student in")
    check(desk.run(*listed, STUDENT, CUSP_PASSWORD=PASSWORD)[0] == 0, "so does the password")
    for _ in range(6):  # one more than would lock the account
        status, _, err = desk.run(*listed, "admin", CUSP_PASSWORD="123456")
        one_sentence(err, "a PIN for a member of staff")
        check(status == 1 and "admin" in err and "password" in err and "PIN" not in err and database not in err, err)
    status, _, err = desk.run(*listed, "admin", CUSP_PASSWORD="correct horse")
    check(status == 0, f"six PINs were no wrong tries: {err}")
    for secret, kind, other in (("000000", "PIN", "password"), ("a wrong one", "password", "PIN")):
        status, _, err = desk.run(*listed, STUDENT, CUSP_PASSWORD=secret)
        one_sentence(err, "a wrong secret")
        check(status == 1 and STUDENT in err and kind in err and other not in err and database not in err, err)


def session_of(database):
    with contextlib.closing(sqlite3.connect(database)) as db:
        (session,) = db.execute("SELECT lower(hex(id)) FROM sessions").fetchone()
    return "-".join((session[:8], session[8:12], session[12:16], session[16:20], session[20:]))


def points_are_scaled(desk, database):
    """A grade of evaluator 1: its weights, 20 and 10, are shown as parts of the 100 points that the score is of."""
    shown = ("history", database, "show", session_of(database), "--as", STUDENT)
    status, out, err = desk.run(*shown, "--json", "-", CUSP_PASSWORD=PIN)
    check(status == 0, f"show: {err}")
    maxima = [c["points_max"] for c in json.loads(out)["criteria"]]
    check(maxima == [66.7, 33.3], f"an old grade's maxima: {maxima}")
    lines = desk.run(*shown, CUSP_PASSWORD=PIN)[1]
    check("/66.7  " in lines and "/33.3  " in lines, f"an old grade's lines: {lines}")


def outputs(desk, database):
    """What a verb writes is never the records: neither the file that it reads itself, nor another's, nor what is beside it."""
    before = {}
    for end in ("", ".key", ".key-counter"):
        with open(database + end, "rb") as f:
            before[end] = f.read()
    os.symlink(database, desk.path("link.db"))
    os.link(database, desk.path("second-name.db"))
    out_dir = desk.path("named")
    os.mkdir(out_dir)
    shutil.copy(database, os.path.join(out_dir, "report.json"))
    session = session_of(database)
    reading = ("history", database, "list", "--as", STUDENT)
    cases = [reading + ("--json", database + end) for end in ("", "-wal", "-shm", ".key", ".key-counter", ".states")]
    state = os.path.join(database + ".states", session + "-000000005000.rebuilt")
    cases += [
        reading + ("--json", state),
        ("specimen", "block", "--voxel-mm", "0.4", "-o", state),
        ("validate", "channel-1", "--form-only", "--json", database + ".states"),
        reading + ("--json", desk.path("link.db")),
        reading + ("--json", desk.path("second-name.db")),
        reading + ("--json", os.path.join(desk.folder, "named", "..", "school.db")),
        ("replay", database, session, "--volume", database, "--as", STUDENT),
        ("grade", os.path.join(out_dir, "report.json"), session, "--out", out_dir, "--as", STUDENT),
        ("play", "channel-1", "--db", desk.path("new.db"), "--json", desk.path("new.db"), "--out", desk.path("new")),
        ("specimen", "block", "--voxel-mm", "0.4", "-o", database),
        ("validate", "channel-1", "--form-only", "--json", database + ".key"),
        ("audit", "channel-1", "--detail", "--apply", "-o", database),
    ]
    for case in cases:
        status, out, err = desk.run(*case, CUSP_PASSWORD=PIN)
        check(status == 1 and out == "" and "belongs to the database" in err, f"{case}: exit {status}: {out}{err}")
        one_sentence(err, str(case))
    for end, content in before.items():
        with open(database + end, "rb") as f:
            check(f.read() == content, f"{end or 'the database'} was written over")
    check(not os.path.exists(desk.path("new.db")), "what was refused left a database")
    check(not os.path.exists(database + ".states"), "what was refused left a file in the place of the key states")
    status, _, err = desk.run(*reading, "--json", desk.path("list.json"), CUSP_PASSWORD=PIN)
    check(status == 0, f"another name is written: {err}")
    for name in ("link.db", "second-name.db"):
        os.remove(desk.path(name))


def named_twice(desk, database):
    """The file that a verb writes is neither the one that it reads nor another that it writes: each stays, and the verb says why."""
    as_admin, secret = ("--as", "admin"), {"CUSP_PASSWORD": "correct horse"}
    status, out, err = desk.run("backup", database, desk.path("twice"), "--json", "-", *as_admin, **secret)
    folder = json.loads(out)["folder"]
    description, new = os.path.join(folder, "backup.json"), desk.path("twice.file")
    exercise = desk.small_exercise("twice.json")
    with open(exercise, "rb") as f:
        content = f.read()
    os.mkdir(desk.path("mine"))
    own = desk.path("mine", "tooth.nrrd")
    check(desk.run("specimen", "tooth", "--voxel-mm", "0.4", "-o", own)[0] == 0, "a tooth is grown")
    with open(own, "rb") as f:
        tooth = f.read().replace(b"\n", b"\n# mine\n", 1)
    with open(own, "wb") as f:
        f.write(tooth)
    fit = ("template", "fit", "class-1-adhesive", "--tooth", "36", "--volume", own, "--out")
    cases = [
        ("restore", folder, desk.path("twice.db"), "--json", description),
        (*fit, desk.path("mine")),
        (*fit, desk.path("elsewhere"), "--json", own),
        ("export", database, "-o", new, "--json", new, *as_admin),
        ("exchange", "out", "--results", new, "--db", database, "--json", os.path.join(desk.folder, ".", "twice.file"), *as_admin),
        ("exchange", "key", new, "--db", database, "--json", new, *as_admin),
        ("validate", exercise, "--form-only", "--json", exercise),
    ]
    for case in cases:
        status, out, err = desk.run(*case, **secret)
        check(status == 1 and out == "" and "named twice" in err, f"{case}: exit {status}: {out}{err}")
        one_sentence(err, str(case))
    check(not os.path.exists(new) and not os.path.exists(desk.path("twice.db")), "what was refused left a file")
    for file, whole in ((exercise, content), (own, tooth)):
        with open(file, "rb") as f:
            check(f.read() == whole, f"{file} was written over")
    status, _, err = desk.run("export", database, "-o", "/dev/null", "--json", "/dev/null", *as_admin, **secret)
    check(status == 0, f"a device takes both: {err}")
    status, _, err = desk.run("restore", folder, desk.path("twice.db"))
    check(status == 0, f"the backup was damaged: {err}")


def restored_beside_a_log(desk, database):
    """SQLite would lay the log of the records that were there before onto the restored ones."""
    as_admin, secret = ("--as", "admin"), {"CUSP_PASSWORD": "correct horse"}
    status, out, err = desk.run("backup", database, desk.path("beside"), "--json", "-", *as_admin, **secret)
    folder, gone = json.loads(out)["folder"], desk.path("gone.db")
    for end in ("", ".key", ".key-counter"):
        shutil.copy(database + end, gone + end)
    code = ("import os, sqlite3, sys; db = sqlite3.connect(sys.argv[1]); db.execute('PRAGMA wal_autocheckpoint = 0'); "
            "db.execute(\"UPDATE people SET name = 'Somebody'\"); db.execute(\"UPDATE audit_log SET detail = detail || 'x'\"); "
            "db.commit(); os._exit(0)")
    subprocess.run([sys.executable, "-c", code, gone], check=True)
    for end in ("", "-shm", ".key", ".key-counter"):
        os.remove(gone + end)
    status, out, err = desk.run("restore", folder, gone)
    one_sentence(err, "a restore beside a log")
    check(status == 1 and "gone.db-wal is there already" in err and not os.path.exists(gone), f"a restore beside a log: {out}{err}")
    status, _, err = desk.run("restore", os.path.join(folder, "station.db"), desk.path("of-a-file.db"))
    check(status == 1 and "no whole backup" in err, f"a file of a backup: {err}")


def names_in_other_letters(desk, database):
    """A folder's name that is no UTF-8: what was made is made, and the JSON can be read."""
    folder = os.fsencode(desk.folder) + b"/stra\xdfe"
    done = subprocess.run([desk.cusp, "backup", database, folder, "--as", "admin", "--json", "-"], capture_output=True, timeout=HUNG_S,
                          stdin=subprocess.DEVNULL, env=desk.environment(CUSP_PASSWORD="correct horse"))
    check(done.returncode == 0 and done.stderr == b"", f"a folder in Latin-1: exit {done.returncode}: {done.stderr}")
    check(json.loads(done.stdout.decode())["sessions"] == 1, f"a folder in Latin-1: {done.stdout}")


def main():
    arguments = argparse.ArgumentParser()
    arguments.add_argument("cusp")
    o = arguments.parse_args()
    with Desk(o.cusp) as desk:
        database = desk.path("school.db")
        make_school(database)
        status, out, err = desk.run("history", database, "verify", "--as", STUDENT, CUSP_PASSWORD=PIN)
        check(status == 0 and "Sealed since" in out, f"an old file is whole and sealed from now on: {out}{err}")
        secrets(desk, database)
        with contextlib.closing(sqlite3.connect(database)) as db:
            db.execute("PRAGMA wal_checkpoint(TRUNCATE)")
        points_are_scaled(desk, database)
        outputs(desk, database)
        named_twice(desk, database)
        restored_beside_a_log(desk, database)
        names_in_other_letters(desk, database)
        listed = ("history", database, "list", "--as", STUDENT, "--limit")
        for limit in ("-5", "0", "x"):
            check(desk.run(*listed, limit, CUSP_PASSWORD=PIN)[0] == 2, f"--limit {limit} is wrong usage")
        verify_names(desk)
        rebuild(desk)
        backups(desk, database)
        demo_account(desk)
        erasure(desk, database)
        thinning(desk, database)
        retention(desk, database)
        print("four tamperings were named, and PIN and password called by their names")


if __name__ == "__main__":
    main()
