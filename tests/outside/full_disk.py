"""A disk that is full, and one that is read-only: what was kept is listed, shown, verified and graded all the same; a play
is refused with the cause, and nothing is lost.

  full_disk.py CUSP          needs leave to mount a file system of three megabytes (root); without it, ctest reports it as skipped
"""
import contextlib
import os
import sqlite3
import subprocess
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from desk import Desk, check, integrity, one_sentence  # noqa: E402
from records import make_school  # noqa: E402

SKIPPED = 77  # SKIP_RETURN_CODE in CMakeLists.txt


@contextlib.contextmanager
def small_disk(folder):
    os.makedirs(folder)
    if subprocess.run(["mount", "-t", "tmpfs", "-o", "size=3m", "tmpfs", folder], capture_output=True).returncode != 0:
        yield False
        return
    try:
        yield True
    finally:
        subprocess.run(["umount", "-l", folder], check=True)


def fill(folder):
    with open(os.path.join(folder, "filler"), "wb", buffering=0) as f:
        for size in (65536, 4096, 1):
            with contextlib.suppress(OSError):
                while f.write(b"x" * size):
                    pass


def leave_a_log(database):
    """As a crash does: what was committed last stands in the log alone, and no index lies beside it."""
    code = ("import os, sqlite3, sys; db = sqlite3.connect(sys.argv[1]); db.execute('PRAGMA wal_autocheckpoint = 0'); "
            "db.execute(\"UPDATE people SET name = 'Only in the log' WHERE number = 'demo'\"); db.commit(); os._exit(0)")
    subprocess.run([sys.executable, "-c", code, database], check=True)
    os.remove(database + "-shm")
    check(os.path.getsize(database + "-wal") > 0, "a log is left")


def read_everything(desk, database, session, score, where):
    rows = desk.json("history", database, "list")
    check([row["session"] for row in rows] == [session] and rows[0]["score"] == score, f"{where}: {rows}")
    check(desk.json("history", database, "show", session)["state"] == "graded", f"{where}: show")
    status, out, err = desk.run("history", database, "verify")
    check(status == 0, f"{where}: verify: {err}")
    check(desk.json("grade", database, session)["score"] == score, f"{where}: the grade that is kept")


def refuse_a_backup(desk):
    """A disk with room for half a copy: a backup there is refused, and writes nothing that would fill the disk meanwhile."""
    database, disk, into = desk.path("school.db"), desk.path("disk"), desk.path("disk", "backups")
    make_school(database)
    status, _, err = desk.run("exchange", "keys", "--db", database, "--as", "admin", CUSP_PASSWORD="correct horse")
    check(status == 0, f"the file takes its present schema: {err}")
    os.mkdir(into)
    about = os.statvfs(disk)
    with open(os.path.join(disk, "half"), "wb") as f:
        f.write(b"x" * (about.f_bavail * about.f_frsize - os.path.getsize(database) // 2))
    before = os.stat(into).st_mtime_ns
    status, _, err = desk.run("backup", database, into, "--as", "admin", CUSP_PASSWORD="correct horse")
    check(status == 1 and "disk is full" in err, f"a backup without room: exit {status}: {err}")
    check(os.stat(into).st_mtime_ns == before, "a backup without room began to write")
    os.remove(os.path.join(disk, "half"))


def main():
    with Desk(os.path.abspath(sys.argv[1])) as desk, small_disk(desk.path("disk")) as mounted:
        if not mounted:
            print("no leave to mount a small disk: nothing was tried")
            sys.exit(SKIPPED)
        scenario, script = desk.small_exercise(), desk.small_script(2)
        database = desk.path("disk", "a.db")
        play = ["play", scenario, "--script", script, "--out", desk.path("out")]
        status, out, err = desk.run(*play, "--db", database)
        check(status == 0, f"play: {err}")
        session = out.strip()
        score = desk.json("history", database, "list")[0]["score"]
        refuse_a_backup(desk)
        leave_a_log(database)

        fill(desk.path("disk"))
        read_everything(desk, database, session, score, "full")
        status, _, err = desk.run(*play, "--db", database)
        check(status == 1, f"a play on a full disk: {status}")
        one_sentence(err, "a play on a full disk")
        check("disk is full" in err, f"the cause is not named: {err}")
        status, _, err = desk.run(*play, "--db", desk.path("disk", "new.db"))
        check(status == 1 and "disk is full" in err, f"a new database on a full disk: {status} {err}")

        subprocess.run(["mount", "-o", "remount,ro", desk.path("disk")], check=True)
        for part in ("-shm", "-wal"):
            print(f"left beside it: {part} {os.path.getsize(database + part) if os.path.exists(database + part) else None}")
        read_everything(desk, database, session, score, "read-only")
        status, _, err = desk.run(*play, "--db", database)
        check(status == 1 and "read-only" in err, f"a play on a read-only disk: {status} {err}")

        subprocess.run(["mount", "-o", "remount,rw", desk.path("disk")], check=True)
        os.remove(desk.path("disk", "filler"))
        read_everything(desk, database, session, score, "with free space again")
        check(integrity(database) == "ok", "the file is sound")
        with contextlib.closing(sqlite3.connect(database)) as db:
            name = db.execute("SELECT name FROM people WHERE number = 'demo'").fetchone()[0]
        check(name == "Only in the log", f"what stood in the log alone is {name!r}")
        print("read on a full and on a read-only disk; nothing was lost")


main()
