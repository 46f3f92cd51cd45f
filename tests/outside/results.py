"""What verbs print of a stored result: one that an examiner changed, one that is withheld from its student, and both in German.

  results.py CUSP
"""
import argparse
import contextlib
import json
import os
import re
import sqlite3
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from desk import Desk, check  # noqa: E402
from records import PIN, STUDENT, make_school  # noqa: E402

ADMIN = ("--as", "admin"), {"CUSP_PASSWORD": "correct horse"}
PUPIL = ("--as", STUDENT), {"CUSP_PASSWORD": PIN}
GERMAN = {"LC_ALL": "de_DE.UTF-8", "LC_MESSAGES": "de_DE.UTF-8", "LANG": "de_DE.UTF-8"}
REASON = "the block slipped"


def coarse(scenario):
    scenario["specimen"]["voxel_mm"] = 0.5


def out_of(desk, who, *arguments, **more):
    account, secret = who
    status, out, err = desk.run(*arguments, *account, **secret, **more)
    check(status == 0 and err == "", f"{arguments}: exit {status}: {err}")
    return out


def json_of(desk, who, *arguments):
    return json.loads(out_of(desk, who, *arguments, "--json", "-"))


def run_sql(database, sql, *values):
    with contextlib.closing(sqlite3.connect(database)) as db:
        count = db.execute(sql, values).rowcount
        db.commit()
        return count


def change_points(database, session, criterion, points):
    """The administrator's override, unsigned: only `history verify` reads signatures."""
    blob = bytes.fromhex(session.replace("-", ""))
    statement = os.urandom(16)
    made = run_sql(database,
                   "INSERT INTO statements (id, session, station, author, at, sequence, kind, links, link, grade, criterion, points, text_hash, "
                   "key, signature) SELECT ?, h.session, s.station, p.id, 1795856400000000, 1000000, 'override_points', h.links, h.link, "
                   "(SELECT max(row) FROM grades WHERE session = h.session), ?, ?, zeroblob(32), (SELECT min(id) FROM station_keys), "
                   "zeroblob(64) FROM session_heads h JOIN sessions s ON s.id = h.session JOIN people p ON p.number = 'admin' "
                   "WHERE h.session = ?", statement, criterion, points, blob)
    check(made == 1, "the override is in the records")
    run_sql(database, "INSERT INTO statement_texts (statement, salt, text) VALUES (?, zeroblob(32), ?)", statement, REASON)


def changed_result(desk, database, session):
    """The result that counts stands first; the measured one below it keeps its name, and every field of the file."""
    grade = ("grade", database, session)
    measured = json_of(desk, ADMIN, *grade)
    check("effective" not in measured, f"nobody has changed the result: {measured}")
    lost = max(measured["criteria"], key=lambda c: c["points_max"] - c["points"])
    change_points(database, session, lost["id"], lost["points_max"] - 0.5)
    seen = json_of(desk, ADMIN, *grade)
    counts = seen.pop("effective")
    check(seen == measured, f"the measured fields stay: {seen}")
    (change,) = counts["changes"]
    check(change["kind"] == "override_points" and change["id"] == lost["id"] and change["reason"] == REASON, f"the change: {change}")
    check(change["by"] and change["at"] == "2026-11-28T09:00:00Z", f"who and when: {change}")
    gain = change["points"] - change["points_measured"]
    check(gain > 1 and abs(counts["score"] - measured["score"] - gain) < 1e-6, f"the score that counts: {counts}")
    (shown,) = [row for row in json_of(desk, ADMIN, "history", database, "show", session)["criteria"] if row["id"] == lost["id"]]
    check(abs(shown["points"] - change["points"]) < 0.11, f"history shows the changed points, in tenths: {shown}")

    lines = out_of(desk, ADMIN, *grade, "--out", desk.path("changed")).splitlines()
    word = {True: "passed", False: "not passed"}
    check(lines[0] == f"{counts['score']:.1f} of 100 points: {word[counts['passed']]}", f"what counts stands first: {lines}")
    check(REASON in lines[1] and change["by"] in lines[1], f"then the change: {lines}")
    check(lines[2] == f"Measured: {measured['score']:.1f} of 100 points, {word[measured['passed']]}", f"then what was measured: {lines}")
    with open(desk.path("changed", "report.json"), encoding="utf-8") as f:
        check(json.load(f) == {**measured, "effective": counts}, "report.json is what --json prints")

    with open(desk.path("small.json"), encoding="utf-8") as f:
        rubric = json.load(f)["rubric"]
    with open(desk.path("rubric.json"), "w", encoding="utf-8") as f:
        json.dump(rubric, f)
    other = json_of(desk, ADMIN, *grade, "--rubric", desk.path("rubric.json"))
    check("effective" not in other and other["score"] == measured["score"], f"another rubric's result has no changes: {other}")


def numbers_in_german(desk, database, session):
    for verb in (("grade", database, session), ("history", database, "show", session), ("history", database, "list")):
        english, german = (out_of(desk, ADMIN, *verb, **more) for more in ({}, GERMAN))
        check(re.search(r"\d\.\d", english) and english != german, f"{verb} in English: {english}")
        check(re.search(r"\d,\d", german) and not re.search(r"\d\.\d", german), f"{verb} mixes decimal signs: {german}")
        check(json_of(desk, ADMIN, *verb) == json.loads(out_of(desk, ADMIN, *verb, "--json", "-", LC_NUMERIC="de_DE.UTF-8")),
              f"{verb}: JSON follows no locale")


def grading_of_another(desk, database):
    """Who may not grade sees what an attempt without a grade would get, and leaves it as it is; its student's grade stays."""
    session = out_of(desk, PUPIL, "play", desk.path("small.json"), "--script", desk.small_script(1), "--db", database, "--out", desk.path("again")).strip()
    blob = bytes.fromhex(session.replace("-", ""))
    for table in ("grades", "graded_criteria"):
        check(run_sql(database, f"DELETE FROM {table} WHERE session = ?", blob) == 1, f"{table} of a program that was killed before the grade")
    check(run_sql(database, "DELETE FROM session_events WHERE session = ? AND kind = 'graded'", blob) == 1, "and its event")
    scores = []
    for who, kept in ((ADMIN, 0), (PUPIL, 1)):
        scores.append(json_of(desk, who, "grade", database, session)["score"])
        with contextlib.closing(sqlite3.connect(database)) as db:
            (grades,) = db.execute("SELECT count(*) FROM grades WHERE session = ?", (blob,)).fetchone()
        check(grades == kept, f"grades that are kept after {who[0]}: {grades}")
    check(scores[0] == scores[1], f"both see the same: {scores}")


def withheld_result(desk, database, session):
    """The student reads that it is not released, and nothing that tells of it; staff reads it."""
    blob = bytes.fromhex(session.replace("-", ""))
    check(run_sql(database, "UPDATE session_summaries SET released = 0, kind = 'assessment' WHERE session = ?", blob) == 1, "it is withheld")
    show = ("history", database, "show", session)
    for verb in (("history", database, "list"), show):
        line = next(each for each in out_of(desk, PUPIL, *verb).splitlines() if each.startswith(session))
        check(line.endswith("  –  not released"), f"{verb}: {line}")
    check("mm³" not in out_of(desk, PUPIL, *show), "the removed tissue tells of a withheld result")
    seen = json_of(desk, PUPIL, *show)
    check(seen["removed"] == [] and seen["criteria"] == [] and seen["state"] == "finished", f"JSON: {seen}")
    check("mm³" in out_of(desk, ADMIN, *show) and json_of(desk, ADMIN, *show)["removed"], "staff reads what was removed")
    line = out_of(desk, ADMIN, *show).splitlines()[0]
    check(line.endswith("passed"), f"staff reads the result: {line}")


def main():
    arguments = argparse.ArgumentParser()
    arguments.add_argument("cusp")
    with Desk(arguments.parse_args().cusp) as desk:
        database = desk.path("school.db")
        make_school(database)
        session = out_of(desk, PUPIL, "play", desk.small_exercise(change=coarse), "--script", desk.small_script(4), "--db", database,
                         "--out", desk.path("out")).strip()
        changed_result(desk, database, session)
        numbers_in_german(desk, database, session)
        grading_of_another(desk, database)
        withheld_result(desk, database, session)
        print("changed results stand before measured ones, withheld ones stay withheld, and German numbers have a comma")


if __name__ == "__main__":
    main()
