"""kill -9 at random moments of `cusp play`: the file opens and is sound, at most the last second is lost, the session
shows as interrupted, its record holds, and it can be graded as it stands.

  crash.py CUSP [--kills N] [--seed N]
"""
import argparse
import os
import random
import signal
import subprocess
import sys
import time

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from desk import Desk, check, integrity  # noqa: E402


def play(desk, database, after_s):
    """Starts a play and kills it after so many seconds. The last second of the session that it printed."""
    errors = desk.path("progress")
    with open(errors, "w", encoding="utf-8") as err:
        process = subprocess.Popen(
            [desk.cusp, "play", desk.path("small.json"), "--script", desk.path("script.csv"), "--db", database, "--out",
             desk.path("out"), "--progress"],
            stdout=subprocess.DEVNULL, stderr=err, stdin=subprocess.DEVNULL, env=desk.environment())
        if after_s is not None:
            time.sleep(after_s)
            process.send_signal(signal.SIGKILL)
        process.wait(timeout=600)
    with open(errors, encoding="utf-8") as err:
        lines = [line for line in err.read().splitlines() if line.replace(".", "", 1).isdigit()]
    return process.returncode, float(lines[-1]) if lines else 0.0


def main():
    arguments = argparse.ArgumentParser()
    arguments.add_argument("cusp")
    arguments.add_argument("--kills", type=int, default=4)
    arguments.add_argument("--seed", type=int, default=int(time.time()))
    o = arguments.parse_args()
    print(f"seed {o.seed}")
    dice = random.Random(o.seed)
    with Desk(o.cusp) as desk:
        desk.small_exercise()
        desk.small_script(12)
        start = time.monotonic()
        status, _ = play(desk, desk.path("whole.db"), None)
        whole_s = time.monotonic() - start
        check(status == 0, f"an undisturbed play ends with {status}")

        cut_short = before_first = finished = 0
        most_lost = 0.0
        database = desk.path("0.db")
        known = set()
        # More of them where none of those met a running session: a loaded machine may sleep through it.
        for kill in range(o.kills + 40):
            if kill >= o.kills and cut_short > 0:
                break
            if kill % 5 == 0:  # a new file now and then: its making is a moment like any other
                database = desk.path(f"{kill}.db")
                known = set()
            status, printed_s = play(desk, database, dice.uniform(0.02, whole_s))
            where = f"kill {kill} (seed {o.seed}, {printed_s} s played)"
            if not os.path.exists(database):
                before_first += 1
                continue
            check(integrity(database) == "ok", f"{where}: {integrity(database)}")
            listed, out, err = desk.run("history", database, "list", "--json", "-")
            if listed != 0:
                # Killed before the first account was there.
                check(printed_s == 0.0 and "--as" in err, f"{where}: the history does not open: {err}")
                before_first += 1
                continue
            check(integrity(database) == "ok", f"{where}: not sound after opening")
            rows = desk.json("history", database, "list")
            new = [row for row in rows if row["session"] not in known]
            known.update(row["session"] for row in rows)
            if not new:
                check(printed_s == 0.0, f"{where}: no session, although it had begun")
                before_first += 1
                continue
            check(len(new) == 1, f"{where}: {len(new)} new sessions")
            row = new[0]
            if status == 0 or row["state"] == "graded":
                finished += 1
                continue
            if row["state"] == "finished":  # between the finish and its grade
                finished += 1
            else:
                check(row["state"] == "interrupted", f"{where}: the session shows as {row['state']}")
                cut_short += 1
            lost = printed_s - row["duration_s"]
            most_lost = max(most_lost, lost)
            check(lost <= 1.0, f"{where}: {lost:.3f} s lost")
            proof = desk.json("replay", "--verify", database, row["session"])
            check(proof["holds"] and proof["chain_intact"], f"{where}: {proof}")
            report = desk.json("grade", database, row["session"])
            check(report["state"] == ("interrupted" if row["state"] == "interrupted" else "finished"), f"{where}: {report['state']}")
            check(report["score_max"] == 100, f"{where}: no grade")
            again = desk.json("replay", "--verify", database, row["session"])
            check(again["holds"] and again["grade_equal"] and again["volume_equal"], f"{where}: {again}")
        print(f"{cut_short + finished + before_first} kills in plays of {whole_s:.1f} s: {cut_short} cut short, {finished} finished before, "
              f"{before_first} before the session began; at most {most_lost:.3f} s lost")
        check(cut_short > 0, "no kill met a running session: nothing was shown")


main()
