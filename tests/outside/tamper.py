"""One byte changed in the record of a session: `cusp replay --verify` finds it, names what and where, and exits with 1.

  tamper.py CUSP [--changes N] [--seed N]
"""
import argparse
import contextlib
import os
import random
import shutil
import sqlite3
import sys
import time

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from desk import Desk, check, one_sentence  # noqa: E402


def flip(database, table, column, row, dice):
    with contextlib.closing(sqlite3.connect(database)) as db:
        db.execute("PRAGMA foreign_keys = OFF")
        (old,) = db.execute(f"SELECT {column} FROM {table} WHERE row = ?", (row,)).fetchone()
        at = dice.randrange(len(old))
        new = bytearray(old)
        new[at] ^= 1 << dice.randrange(8)
        db.execute(f"UPDATE {table} SET {column} = ? WHERE row = ?", (bytes(new), row))
        db.commit()
        return at


def main():
    arguments = argparse.ArgumentParser()
    arguments.add_argument("cusp")
    arguments.add_argument("--changes", type=int, default=6)
    arguments.add_argument("--seed", type=int, default=int(time.time()))
    o = arguments.parse_args()
    print(f"seed {o.seed}")
    dice = random.Random(o.seed)
    with Desk(o.cusp) as desk:
        scenario, script = desk.small_exercise(), desk.small_script(6)
        status, out, err = desk.run("play", scenario, "--script", script, "--db", desk.path("good.db"), "--out", desk.path("out"))
        check(status == 0, f"play: {err}")
        session = out.strip()
        check(desk.run("replay", "--verify", desk.path("good.db"), session)[0] == 0, "the untouched record holds")
        with contextlib.closing(sqlite3.connect(desk.path("good.db"))) as db:
            db.execute("PRAGMA wal_checkpoint(TRUNCATE)")
            rows = [row for (row,) in db.execute("SELECT row FROM trace_chunks ORDER BY row")]
            (keys,) = db.execute("SELECT count(*) FROM key_states").fetchone()
        check(len(rows) == 6 and keys == 0, f"six seconds are six chunks, and key states are no part of the record: {rows} {keys}")

        for change in range(o.changes):
            bad = desk.path("bad.db")
            for end in ("", "-wal", "-shm"):
                if os.path.exists(bad + end):
                    os.remove(bad + end)
            shutil.copy(desk.path("good.db"), bad)
            for part in (".key", ".key-counter"):
                shutil.copy(desk.path("good.db" + part), bad + part)
            table, column, row = ("trace_chunks", "trace", dice.choice(rows))
            if change == o.changes - 1:
                table, column, row = ("final_volumes", "cuts", 0)
            at = flip(bad, table, column, row, dice)
            what = f"byte {at} of {table} row {row} (seed {o.seed})"
            status, out, err = desk.run("replay", "--verify", bad, session)
            check(status == 1, f"{what}: exit {status}, {out}")
            one_sentence(err, what)
            check(f"{table}, row {row}" in err, f"{what} is not what it names: {err}")
        print(f"{o.changes} changes of one byte each were found and named")


main()
