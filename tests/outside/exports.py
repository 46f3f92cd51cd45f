"""`cusp export`: attempts with cohort and dates as CSV and JSON, narrowed by filters; columns for a gradebook. What is wrong is refused
in one sentence.

  exports.py CUSP
"""
import argparse
import contextlib
import csv
import io
import json
import os
import shutil
import signal
import sqlite3
import subprocess
import sys
import time

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from desk import HUNG_S, Desk, check, one_sentence  # noqa: E402
from records import PIN, STUDENT, make_school  # noqa: E402

ADMIN = {"CUSP_PASSWORD": "correct horse"}
COHORT = "=Year 2, group A"  # a spreadsheet would take it for a formula
NEW_COLUMNS = ["finished_utc", "cohort", "opens_utc", "due_utc"]


def assign(database):
    """The one attempt, begun on 20 November 2026 at 09:14:03, belongs to the cohort's assignment, due a second later."""
    with contextlib.closing(sqlite3.connect(database)) as db:
        db.execute("UPDATE session_summaries SET assignment = (SELECT id FROM assignments)")
        db.execute("UPDATE cohorts SET name = ?", (COHORT,))
        db.commit()


def export(desk, database, *arguments, **more):
    return desk.run("export", database, "--as", "admin", *arguments, **{**ADMIN, **more})


def exported(desk, database, *filters):
    status, out, err = export(desk, database, *filters)
    check(status == 0 and err == "", f"{filters}: exit {status}: {err}")
    return list(csv.DictReader(io.StringIO(out)))


def columns(desk, database):
    (row,) = exported(desk, database)
    check(list(row)[-4:] == NEW_COLUMNS, f"the columns: {list(row)}")
    check(row["started_utc"] == "2026-11-20T09:14:03Z" and row["finished_utc"] == "2026-11-20T09:14:03Z", f"the attempt's dates: {row}")
    check(row["cohort"] == "'" + COHORT, f"the cohort is no formula: {row}")
    check(row["opens_utc"] == "" and row["due_utc"] == "2026-11-20T09:14:04Z", f"the assignment's dates: {row}")
    file, beside = desk.path("attempts.csv"), desk.path("attempts.json")
    status, out, err = export(desk, database, "-o", file, "--json", beside)
    check(status == 0 and out == "1 attempt exported.\n", f"both files: {out}{err}")
    with open(file, "rb") as f:
        content = f.read()
    check(content.count(b"\r\n") == content.count(b"\n") == 2, f"RFC 4180: {content}")
    with open(beside, encoding="utf-8") as f:
        (seen,) = json.load(f)
    check(seen["session"] == row["session"] and seen["student_name"] == "Lena Brandt", f"JSON: {seen}")
    check(seen["cohort"] == COHORT and seen["opens"] is None and seen["due"] == row["due_utc"], f"JSON: {seen}")
    check(seen["started"] == row["started_utc"] and seen["finished"] == row["finished_utc"], f"JSON: {seen}")
    status, out, err = export(desk, database, "--json", "-")
    check(status == 0 and json.loads(out) == [seen], f"JSON alone on stdout: {out}{err}")
    status, out, err = export(desk, database, "-o", "-", "--json", beside, LC_ALL="de_DE.UTF-8")
    check(status == 0 and "Gerader Kanal" in out, f"titles in German: {out}{err}")


def filters(desk, database):
    day, second = "2026-11-20", "2026-11-20T09:14:03Z"
    for rows, *arguments in ((1, "--cohort", COHORT), (1, "--cohort", COHORT.upper()),
                             (1, "--from", day), (1, "--to", day), (1, "--from", day, "--to", day), (1, "--from", second, "--to", second),
                             (0, "--from", "2026-11-21"), (0, "--to", "2026-11-19"), (0, "--from", "2026-11-20T09:14:04Z"),
                             (0, "--to", "2026-11-20T09:14:02Z"), (0, "--cohort", COHORT, "--to", "2026-11-19"),
                             (1, "--exercise", "channel-1", "--exercise-version", "1"), (0, "--exercise", "channel-1", "--exercise-version", "2"),
                             (1, "--student", "brandt"), (0, "--student", "nobody"), (1, "--device", "pointer"),
                             (1, "--drilled-by", "students"), (0, "--drilled-by", "staff"), (0, "--drilled-by", "scripted"),
                             (1, "--result", "passed"), (0, "--result", "not-passed")):
        seen = exported(desk, database, *arguments)
        check(len(seen) == rows, f"{arguments}: {len(seen)} rows")
    scenario = json.loads(export(desk, database, "--json", "-")[1])[0]["scenario"]
    check(len(exported(desk, database, "--exercise", scenario)) == 1, "an exercise by its id")


def assign_again(database, names, values):
    """A copy of the cohort's first assignment in which the values stand for the names."""
    with contextlib.closing(sqlite3.connect(database)) as db:
        others = [row[1] for row in db.execute("PRAGMA table_info(assignments)") if row[1] not in names.split(", ")]
        db.execute(f"INSERT INTO assignments ({names}, {', '.join(others)}) SELECT {values}, {', '.join(others)} FROM assignments "
                   "WHERE due_at NOT NULL LIMIT 1")
        db.commit()


def beside_practice(desk, database, of):
    """An assessment of the same exercise, cohort and due date as a practice: the kind says which."""
    assign_again(database, "id, kind", "randomblob(16), 'assessment'")
    due = ("--gradebook", "moodle", *of, "--due", "2026-11-20")
    status, out, err = export(desk, database, *due)
    one_sentence(err, "a practice and an assessment")
    check(status == 1 and out == "", f"a practice and an assessment: {out}")
    for kind, results in (("practice", 1), ("assessment", 0)):
        check(f"--kind {kind} --due 2026-11-20T09:14:04Z" in err, f"the message names the {kind}: {err}")
        check(len(exported(desk, database, *due, "--kind", kind)) == results, f"the {kind}")
        check(len(exported(desk, database, "--kind", kind)) == results, f"attempts of a {kind}")
    for wanted, arguments, name in ((1, ("--gradebook", "moodle", *of, "--kind", "assessment", "--due", "none"), "--kind assessment --due none"),
                                    (2, (*due, "--kind", "try_it"), "try_it")):
        status, out, err = export(desk, database, *arguments)
        one_sentence(err, str(arguments))
        check(status == wanted and out == "" and name in err, f"{arguments}: exit {status}: {out}{err}")
    with contextlib.closing(sqlite3.connect(database)) as db:
        db.execute("DELETE FROM assignments WHERE kind = 'assessment'")
        db.commit()


def gradebooks(desk, database):
    """Of the cohort's one assignment; once there are two, kind and due date say which."""
    of = ("--cohort", COHORT, "--exercise", "channel-1")
    score = json.loads(export(desk, database, "--json", "-")[1])[0]["score"]
    (line,) = exported(desk, database, "--gradebook", "moodle", *of)
    check(line == {"ID number": STUDENT, "Straight channel": f"{score:g}"}, f"Moodle: {line}")
    points, line = exported(desk, database, "--gradebook", "canvas", *of)
    check(points["Student"] == "Points Possible" and line["Student"] == "Lena Brandt" and line["SIS User ID"] == STUDENT, f"Canvas: {line}")
    file = desk.path("canvas.csv")
    status, out, err = export(desk, database, "--gradebook", "canvas", *of, "--due", "2026-11-20", "-o", file)
    check(status == 0 and out == "1 result exported.\n", f"to a file: {out}{err}")
    with open(file, encoding="utf-8") as f:
        check("Lena Brandt" in f.read(), "the file holds the result")
    for wanted, more, name in ((1, ("--due", "2026-11-21"), "2026-11-21"), (1, ("--due", "none"), "none"), (1, ("--exercise-version", "2"), "channel-1"),
                               (2, ("--due", "soon"), "soon"), (2, ("--student", "brandt"), "--student"), (2, ("--json", "-"), "--json")):
        status, out, err = export(desk, database, "--gradebook", "moodle", *of, *more)
        one_sentence(err, str(more))
        check(status == wanted and out == "" and name in err, f"{more}: exit {status}: {out}{err}")
    for arguments, name in ((("--gradebook", "moodle", "--cohort", COHORT), "--exercise"), (("--gradebook", "excel", *of), "excel"),
                            (("--due", "none"), "--gradebook")):
        status, out, err = export(desk, database, *arguments)
        one_sentence(err, str(arguments))
        check(status == 2 and out == "" and name in err, f"{arguments}: exit {status}: {out}{err}")
    assign_again(database, "id, kind, due_at", "randomblob(16), kind, NULL")  # without a date and without results
    status, out, err = export(desk, database, "--gradebook", "moodle", *of)
    both = "--kind practice --due 2026-11-20T09:14:04Z, --kind practice --due none"
    check(status == 1 and out == "" and both in err, f"two of them: {out}{err}")
    check(len(exported(desk, database, "--gradebook", "moodle", *of, "--due", "2026-11-20")) == 1, "the one with a date")
    check(exported(desk, database, "--gradebook", "moodle", *of, "--due", "none") == [], "the one without")
    beside_practice(desk, database, of)
    with contextlib.closing(sqlite3.connect(database)) as db:
        db.execute("DELETE FROM session_summaries")
        db.commit()
    for system, head in (("moodle", "ID number,Straight channel"), ("canvas", "Student,ID,SIS User ID,SIS Login ID,Section,Straight channel")):
        status, out, err = export(desk, database, "--gradebook", system, *of, "--due", "2026-11-20")
        check(status == 0 and out.splitlines()[0] == head, f"an exercise that nobody has attempted: {out}{err}")
        check(STUDENT not in out, f"{system}: who has no result: {out}")


def entries(database):
    """What the audit log holds of exports of attempts."""
    with contextlib.closing(sqlite3.connect(database)) as db:
        return db.execute("SELECT count(*) FROM audit_log WHERE action = 'history_exported'").fetchone()[0]


def unwritable_json(desk, database):
    """A file that cannot be written leaves neither its companion nor an entry in the audit log."""
    before, file = entries(database), desk.path("beside.csv")
    for arguments in (("--json", desk.path("none", "a.json")), ("-o", file, "--json", desk.path("none", "a.json")), ("--json", "/dev/full")):
        status, out, err = export(desk, database, *arguments)
        one_sentence(err, str(arguments))
        check(status == 1 and out == "" and arguments[-1] in err, f"{arguments}: exit {status}: {out}{err}")
        check(entries(database) == before, f"{arguments}: the audit log names an export that failed")
        check(not os.path.exists(file), f"{arguments}: the CSV stands without its JSON")
    status, _, err = export(desk, database, "-o", file, "--json", desk.path("beside.json"))
    check(status == 0 and entries(database) == before + 1, f"both files, one entry: {err}")


def refusals(desk, database):
    def refused(wanted, arguments, name):
        status, out, err = export(desk, database, *arguments)
        one_sentence(err, str(arguments))
        check(status == wanted and out == "" and name in err, f"{arguments}: exit {status}: {out}{err}")

    for arguments, name in ((("--from", "yesterday"), "yesterday"), (("--from", "2026-02-30"), "2026-02-30"), (("--to", ""), "“”"),
                            (("--to", "20.11.2026"), "20.11.2026"), (("--to", "2026-11-20T09:14:03"), "2026-11-20T09:14:03"),
                            (("--from", "2026-11-21", "--to", "2026-11-20"), "2026-11-21"),
                            (("--from", "2026-11-20T09:14:03Z", "--to", "2026-11-20T09:14:02Z"), "after"),
                            (("--exercise-version", "1"), "--exercise"), (("--exercise", "channel-1", "--exercise-version", "0"), "0"),
                            (("--result", "maybe"), "maybe"), (("--drilled-by", "nobody"), "nobody"), (("-o", "-", "--json", "-"), "stdout")):
        refused(2, arguments, name)
    for arguments, name in ((("--cohort", "Year 9"), "Year 9"), (("--cohort", ""), "“”"), (("--exercise", "channel-9"), "channel-9"),
                            (("--device", "spoon"), "spoon"), (("-o", desk.path("none", "a.csv")), "a.csv"),
                            (("-o", database), "belongs to the database"), (("-o", database + ".states"), "belongs to the database"),
                            (("-o", os.path.join(database + ".states", "a.csv")), "belongs to the database"), (("--json", database + ".key"), "belongs to the database")):
        refused(1, arguments, name)
    status, out, err = desk.run("export", database, "--as", STUDENT, "--cohort", "Year 9", CUSP_PASSWORD=PIN)
    one_sentence(err, "a student exports")
    check(status == 1 and out == "" and "Year 9" not in err, f"a student learns which cohorts there are: {out}{err}")
    status, _, err = desk.run("export", desk.path("none.db"), "--as", "admin", **ADMIN)
    one_sentence(err, "an export of no database")
    check(status == 1 and "none.db" in err, err)


def two_of_one_key(desk, database):
    """Two exercises with one key: neither stands for both, and each has its id."""
    twice = desk.path("twice.db")
    with contextlib.closing(sqlite3.connect(database)) as one, contextlib.closing(sqlite3.connect(twice)) as other:
        one.backup(other)
    for end in (".key", ".key-counter"):
        shutil.copy(database + end, twice + end)
    copy = desk.small_exercise("copy.json", lambda s: s.update(key="channel-1"))
    status, _, err = desk.run("play", copy, "--script", desk.small_script(1), "--db", twice, "--as", STUDENT, "--out", desk.path("o"), CUSP_PASSWORD=PIN)
    check(status == 0, f"an exercise with the key of another one: {err}")
    status, out, err = export(desk, twice, "--exercise", "channel-1")
    one_sentence(err, "a key of two exercises")
    check(status == 1 and out == "" and "channel-1" in err, f"a key of two exercises: exit {status}: {out}{err}")
    for scenario in {row["scenario"] for row in json.loads(export(desk, twice, "--json", "-")[1])}:
        check(len(exported(desk, twice, "--exercise", scenario)) == 1, f"an exercise by its id: {scenario}")


def catches(pid, number):
    with open(f"/proc/{pid}/status", encoding="ascii") as f:
        (caught,) = [line.split()[1] for line in f if line.startswith("SigCgt:")]
    return bool(int(caught, 16) & 1 << (number - 1))


def json_rows(desk, database):
    """One array, indented by two blanks, with or without rows."""
    status, out, err = export(desk, database, "--json", "-")
    check(status == 0 and out.startswith('[\n  {\n    "session": ') and out.endswith("\n  }\n]\n"), f"the JSON: {out}{err}")
    status, out, err = export(desk, database, "--to", "2000-01-01", "--json", "-")
    check(status == 0 and out == "[]\n", f"the JSON of no attempt: {out}{err}")


def stopped(desk, database, arguments, written):
    """Ctrl+C while whoever reads stdout is slow: some of it is written, and the sentence does not deny it."""
    reading, writing = os.pipe()
    os.set_blocking(writing, False)
    with contextlib.suppress(BlockingIOError):
        while True:
            os.write(writing, b" " * 4096)
    os.set_blocking(writing, True)
    with subprocess.Popen([desk.cusp, "export", database, "--as", "admin", *arguments], stdin=subprocess.DEVNULL, stdout=writing,
                          stderr=subprocess.PIPE, text=True, env=desk.environment(**ADMIN)) as run:
        os.close(writing)
        until = time.monotonic() + HUNG_S
        while not catches(run.pid, signal.SIGINT):
            check(run.poll() is None and time.monotonic() < until, "the export caught no Ctrl+C")
            time.sleep(0.01)
        run.send_signal(signal.SIGINT)
        with open(reading, "rb") as slow:
            content = slow.read()
        err = run.stderr.read()
    one_sentence(err, "a stopped export")
    check(run.returncode == 1 and written in content and "No file" not in err, f"a stopped export: exit {run.returncode}: {err}")


def unread(desk, database):
    """Whoever closes the pipe before its end has read what came before it: the audit log names that export too."""
    before = entries(database)
    reading, writing = os.pipe()
    os.close(reading)
    done = subprocess.run([desk.cusp, "export", database, "--as", "admin"], stdin=subprocess.DEVNULL, stdout=writing, stderr=subprocess.PIPE,
                          text=True, timeout=HUNG_S, env=desk.environment(**ADMIN))
    os.close(writing)
    check(done.returncode == 0 and done.stderr == "", f"an export without a reader: exit {done.returncode}: {done.stderr}")
    check(entries(database) == before + 1, "an export that was read in part has no entry")


def main():
    arguments = argparse.ArgumentParser()
    arguments.add_argument("cusp")
    o = arguments.parse_args()
    with Desk(o.cusp) as desk:
        database = desk.path("school.db")
        make_school(database)
        status, _, err = export(desk, database, "-o", desk.path("first.csv"))  # takes the file to the newest schema
        check(status == 0, f"an old file: {err}")
        assign(database)
        columns(desk, database)
        filters(desk, database)
        unwritable_json(desk, database)
        refusals(desk, database)
        json_rows(desk, database)
        stopped(desk, database, (), b"started_utc")
        stopped(desk, database, ("--json", "-"), b'"started"')
        unread(desk, database)
        two_of_one_key(desk, database)
        gradebooks(desk, database)
        print("exports name cohort and dates, write gradebooks, and refuse what is wrong")


if __name__ == "__main__":
    main()
