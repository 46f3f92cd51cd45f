"""Pipes, links to themselves, folders, devices and empty names where records and files are expected: a sentence at once, and nothing left.

  wrong_places.py CUSP
"""
import os
import shutil
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from desk import Desk, check, one_sentence  # noqa: E402
from records import make_school  # noqa: E402

AS_ADMIN, SECRET = ("--as", "admin"), {"CUSP_PASSWORD": "correct horse"}
SESSION = "019a9f3c-6a00-7c41-9b1e-000000000000"


def refused(desk, *arguments, status=1, names=()):
    there = sorted(os.listdir(desk.folder))
    seen, out, err = desk.run(*arguments, **SECRET)
    check(seen == status and out == "", f"{arguments}: exit {seen}: {out}{err}")
    one_sentence(err, str(arguments))
    for name in names:
        check(name in err, f"{arguments}: {name} is not in {err!r}")
    check(sorted(os.listdir(desk.folder)) == there, f"{arguments} left {sorted(set(os.listdir(desk.folder)) - set(there))}")


def make_places(desk):
    """What is there and is neither a regular file with records nor a folder with a backup; two are not there."""
    pipe, loop, folder, empty, text = (desk.path(name) for name in ("pipe", "loop", "folder", "empty", "text"))
    os.mkfifo(pipe)
    os.symlink("loop", loop)
    os.mkdir(folder)
    for name, content in ((empty, ""), (text, "hello\n" * 100)):
        with open(name, "w", encoding="utf-8") as f:
            f.write(content)
    return pipe, loop, folder, empty, text, "/dev/zero", desk.path("none"), desk.path("of two\nlines")


def reads(desk, database, places):
    for place in places:
        refused(desk, "restore", place, desk.path("new.db"), names=("no whole backup",))
        refused(desk, "backup", place, desk.path("into"), *AS_ADMIN)
        refused(desk, "export", place, *AS_ADMIN)
        refused(desk, "exchange", "in", place, "--db", database, *AS_ADMIN)
        refused(desk, "exchange", "trust", place, "--db", database, *AS_ADMIN)


def writes(desk, database, backup, places):
    pipe, loop, _, empty, text, device, *_ = places
    for place in (pipe, loop, empty, text, device):
        refused(desk, "backup", database, place, *AS_ADMIN, names=(place, "cannot be written"))
        refused(desk, "restore", backup, place, names=("there already",))
        refused(desk, "exchange", "out", "--results", place, "--db", database, *AS_ADMIN)


def records_of_another(desk, database, backup):
    """SQLite takes what lies beside a database for its log or journal, and writes over it."""
    refused(desk, "restore", backup, database, names=("there already",))
    for ending in ("-wal", "-journal", "-shm", ".running", ".states"):
        refused(desk, "restore", backup, database + ending, names=(database, "belongs to"))
        refused(desk, "backup", database, database + ending, *AS_ADMIN, names=(database, "belongs to"))


def parts_of_a_backup(desk, backup):
    for part in ("backup.json", "station.db", "station.db.key", "station.db.key-counter"):
        copy = desk.path("copy of " + part)
        shutil.copytree(backup, copy)
        os.remove(os.path.join(copy, part))
        os.mkfifo(os.path.join(copy, part))
        refused(desk, "restore", copy, desk.path("new.db"))


def empty_names(desk):
    for name, *arguments in (("BACKUP", "restore", "", "x.db"), ("DB", "restore", "x", ""), ("DB", "backup", "", "x"), ("FOLDER", "backup", "x.db", ""),
                             ("DB", "export", ""), ("FILE", "verify", ""), ("FILE", "import", "", "-o", "x.nrrd"), ("DB", "history", "", "list"),
                             ("DB", "appeal", "", SESSION, "x"), ("FILE", "appeal", "x.db", SESSION, ""), ("DB", "replay", "", SESSION), ("DB", "thin", ""),
                             ("DB", "retain", "", "--years", "2"), ("DB", "erase", "", "17"), ("NUMBER", "erase", "x.db", ""), ("DB", "grade", "", SESSION),
                             ("PATH", "validate", ""), ("SCENARIO", "audit", ""), ("SCENARIO", "play", "", "--out", "x"),
                             ("FILE", "exchange", "in", "", "--db", "x.db"), ("FILE", "exchange", "out", "", "--results", "--db", "x.db"),
                             ("FILE", "exchange", "trust", "", "--db", "x.db"), ("--db", "exchange", "keys", "--db", "")):
        refused(desk, *arguments, status=2, names=(name, "empty"))
    for name, *arguments in (("DB", "restore", "x", "-"), ("FILE", "appeal", "x.db", SESSION, "-"), ("FILE", "exchange", "key", "-", "--db", "x.db"),
                             ("FILE", "exchange", "out", "-", "--results", "--db", "x.db")):
        refused(desk, *arguments, status=2, names=(name, "file"))


def give_away(folder, user):
    for at, _, files in os.walk(folder):
        for path in (at, *(os.path.join(at, name) for name in files)):
            os.chown(path, user, -1, follow_symlinks=False)


def unreadable(desk, database, backup):
    """What may not be read is called so."""
    new, results = desk.path("new.db"), desk.path("results")
    parts = [(os.path.join(backup, part), ("restore", backup, new)) for part in ("backup.json", "station.db", "station.db.key", "station.db.key-counter")]
    for path, verb in (*parts, (database, ("export", database, *AS_ADMIN)), (results, ("exchange", "in", results, "--db", database, *AS_ADMIN)),
                       (results, ("exchange", "trust", results, "--db", database, *AS_ADMIN))):
        os.chmod(path, 0)
        refused(desk, *verb, names=(path, "cannot be read"))
        os.chmod(path, 0o600)
    locked = desk.path("locked")
    os.mkdir(locked, 0o500)
    refused(desk, "backup", database, locked, *AS_ADMIN, names=(locked, "cannot be written: Permission denied"))
    refused(desk, "backup", database, os.path.join(locked, "into"), *AS_ADMIN, names=(locked, "cannot be written: Permission denied"))
    key = database + ".key"
    os.chmod(key, 0)
    status, _, failure = desk.run("backup", database, desk.path("into"), *AS_ADMIN, **SECRET)
    check(status == 1 and key in failure and not os.path.exists(desk.path("into")), f"a backup without its key: exit {status}: {failure}")
    os.chmod(key, 0o600)


def as_another_user(desk, database, backup):
    """Nothing is unreadable to root: it becomes another user for so long."""
    nobody, root = 65534, os.geteuid() == 0
    status, _, failure = desk.run("exchange", "out", "--results", desk.path("results"), "--db", database, *AS_ADMIN, **SECRET)
    check(status == 0, f"exchange out: {failure}")
    if root:
        give_away(desk.folder, nobody)
        os.setresuid(nobody, nobody, 0)
    try:
        desk.run("--version")
    except PermissionError:
        print("another user may not run the program: unreadable files were not tried")
    else:
        unreadable(desk, database, backup)
    finally:
        if root:
            os.setresuid(0, 0, 0)


with Desk(sys.argv[1]) as the_desk:
    school = the_desk.path("school.db")
    make_school(school)
    begun, made, failure = the_desk.run("backup", school, the_desk.path("backups"), *AS_ADMIN, **SECRET)
    check(begun == 0, f"backup: {failure}")
    wrong = make_places(the_desk)
    reads(the_desk, school, wrong)
    writes(the_desk, school, made.strip(), wrong)
    records_of_another(the_desk, school, made.strip())
    parts_of_a_backup(the_desk, made.strip())
    empty_names(the_desk)
    as_another_user(the_desk, school, made.strip())
