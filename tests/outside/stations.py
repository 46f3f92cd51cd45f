"""Three stations by files: an office and two others, each a database with a key of its own. Accounts go out, attempts come
back; twice, late, changed, from an unknown key and from a station that was put back, each is named.

  stations.py CUSP
"""
import argparse
import contextlib
import json
import os
import shutil
import sqlite3
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from desk import Desk, check, one_sentence  # noqa: E402
from records import PIN, STUDENT, make_school  # noqa: E402

SECRET = {"CUSP_PASSWORD": "correct horse"}


class Station:
    def __init__(self, desk, name, admin):
        self.desk, self.name, self.admin = desk, name, admin
        self.database = desk.path(name + ".db")

    def exchange(self, *arguments):
        """Exit status, the JSON, stderr."""
        status, out, err = self.desk.run("exchange", *arguments, "--db", self.database, "--as", self.admin, "--json", "-", **SECRET)
        return status, json.loads(out) if out else {}, err

    def done(self, *arguments):
        status, seen, err = self.exchange(*arguments)
        check(status == 0, f"{self.name}: exchange {arguments}: exit {status}: {err}")
        return seen

    def refused(self, *arguments):
        status, seen, err = self.exchange(*arguments)
        check(status == 1 and not seen, f"{self.name}: exchange {arguments}: exit {status}: {seen}")
        one_sentence(err, f"{self.name}: exchange {arguments}")
        return err

    def out(self, kind):
        file = self.desk.path(f"{self.name}-{len(os.listdir(self.desk.folder))}.cuspexchange")
        return file, self.done("out", kind, file)

    def findings(self):
        status, out, err = self.desk.run("history", self.database, "verify", "--as", self.admin, "--json", "-", **SECRET)
        check(out, f"{self.name}: verify: exit {status}: {err}")
        return status, json.loads(out)

    def sessions(self):
        with contextlib.closing(sqlite3.connect(self.database)) as db:
            return sorted(bytes(row[0]).hex() for row in db.execute("SELECT id FROM sessions"))


def make_station(desk, name, secret_of):
    """A new database with an administrator of its own, by SQL: its account is what verification then names, and no more."""
    station = Station(desk, name, "keeper-" + name)
    status, _, err = desk.run("play", desk.small_exercise(), "--script", desk.small_script(1), "--db", station.database,
                              "--out", desk.path("out-" + name))
    check(status == 0, f"play: {err}")
    with contextlib.closing(sqlite3.connect(secret_of)) as db:
        secret = db.execute("SELECT password FROM people WHERE number = 'admin'").fetchone()[0]
    with contextlib.closing(sqlite3.connect(station.database)) as db:
        db.execute("INSERT INTO people (id, number, name, role, password, created_at) VALUES (?, ?, 'Keeper', 'administrator', ?, 1)",
                   (os.urandom(16), station.admin, secret))
        db.commit()
    return station


def check_whole(station):
    status, seen = station.findings()
    tables = {f["table"] for f in seen.get("findings", [])}
    check(tables <= {"people"}, f"{station.name}: {seen}")


def trust_each_other(desk, stations):
    for station in stations:
        station.done("key", desk.path(station.name + ".key-text"))
    for here in stations:
        for there in stations:
            if here is not there:
                role = ["--office"] if there.name == "office" else []
                here.done("trust", desk.path(there.name + ".key-text"), *role)
        check(len(here.done("keys")["keys"]) == 2, f"{here.name}: keys")


def drill(desk, station):
    status, out, err = desk.run("play", desk.small_exercise(), "--script", desk.small_script(2), "--db", station.database,
                                "--as", STUDENT, "--out", desk.path("out"), CUSP_PASSWORD=PIN)
    check(status == 0, f"{station.name}: the office's student drills: {err}")
    return out.strip()


def copy_station(desk, name, to):
    for end in ("", ".key", ".key-counter"):
        shutil.copy(desk.path(name + ".db") + end, desk.path(to + ".db") + end)


def changed(desk, file):
    other = desk.path("changed.cuspexchange")
    shutil.copy(file, other)
    with contextlib.closing(sqlite3.connect(other)) as db:
        db.execute("UPDATE grades SET score = 100")
        db.commit()
    return other


def finish_what_was_killed(desk, station):
    """A file that a killed program had logged and not yet named gets its name, and whoever asks for the name reads that."""
    file, _ = station.out("--results")
    left = desk.path(".cusp-copy-019a9f3c-6a00-7c41-9b1e-000000000000")
    os.mkdir(left)
    os.rename(file, os.path.join(left, "copy.db"))
    with open(os.path.join(left, "copy.db.name"), "w", encoding="utf-8") as f:
        f.write("a process that has ended\n" + os.path.basename(file))
    check("was interrupted" in station.refused("out", "--results", file), "a file that was not named yet")
    check(os.path.exists(file) and not os.path.exists(left), "a file that was not named yet has no name still")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("cusp")
    with Desk(parser.parse_args().cusp) as desk:
        make_school(desk.path("office.db"))
        office = Station(desk, "office", "admin")
        office.done("keys")
        b, c = make_station(desk, "b", office.database), make_station(desk, "c", office.database)

        file, _ = office.out("--office")
        check("key" in b.refused("in", file), "an unknown key is not named")
        trust_each_other(desk, (office, b, c))
        new = desk.path("of-a-student")
        for arguments in (("in", file), ("key", new), ("keys",), ("trust", desk.path("b.key-text")), ("out", "--results", new)):
            status, _, err = desk.run("exchange", *arguments, "--db", office.database, "--as", STUDENT, CUSP_PASSWORD=PIN)
            one_sentence(err, f"a student: exchange {arguments}")
            check(status == 1 and not os.path.exists(new), f"a student: exchange {arguments}: exit {status}")
        check(b.done("in", file)["accounts"] >= 2 and c.done("in", file)["accounts"] >= 2, "accounts")

        for station, part in ((b, "Erase at the office instead"), (office, "read the newest ones first")):
            status, out, err = desk.run("retain", station.database, "--years", "100", "--dry-run", "--clock-is-right", "--as", station.admin, **SECRET)
            check(status == 0 and part in out, f"{station.name}: what others know of those who left: exit {status}: {out}{err}")

        session = drill(desk, b)
        early, _ = b.out("--results")
        later = drill(desk, b)
        results, made = b.out("--results")
        check(made["number"] == 2, f"{made}")
        check("signed" in office.refused("in", changed(desk, results)), "a changed file is not named")
        short = desk.path("short.cuspexchange")
        shutil.copy(results, short)
        os.truncate(short, os.path.getsize(results) - 1)
        check("cut short" in office.refused("in", short), "a file that lacks its last byte is not named")
        check(office.done("in", results)["outcome"] == "read", "results")
        check(office.done("in", results)["outcome"] == "again", "the same file again")
        check(office.done("in", early)["outcome"] == "late", "an older file")
        own, _ = office.out("--results")
        for there, files in ((b, (own,)), (c, (early, results, own, own))):
            for one in files:
                there.done("in", one)
        for sent in (session, later):
            check(sent.replace("-", "") in c.sessions(), f"{sent} is not at c")
        check(office.sessions() == sorted(set(office.sessions()) | {session.replace("-", ""), later.replace("-", "")}), "office")
        for station in (office, b, c):
            check_whole(station)

        copy_station(desk, "b", "old")
        office.done("in", b.out("--results")[0])
        copy_station(desk, "old", "b")
        drill(desk, b)
        refusal = office.refused("in", b.out("--results")[0])
        check("put back" in refusal and "ends in .key" in refusal, f"a station put back to an old copy, and how it gets a new key, are not named: {refusal}")
        office.done("trust", desk.path("b.key-text"), "--revoke")
        check("revoked" in office.refused("in", results), "a revoked key is not named")
        check("not known here" in office.refused("trust", desk.path("office.key-text"), "--revoke"), "a key that nobody made known is revoked")
        status, _, err = desk.run("exchange", "trust", desk.path("b.key-text"), "--office", "--revoke", "--db", office.database)
        check(status == 2, f"trusted and revoked at once: exit {status}: {err}")
        check("cannot be written: No such file" in office.refused("out", "--results", desk.path("none", "x")), "a folder that is not there")
        check("cannot be written: No such file" in office.refused("key", desk.path("none", "x")), "a key into a folder that is not there")
        finish_what_was_killed(desk, office)
        check_whole(office)
        print(f"three stations: {len(office.sessions())} attempts at the office, {os.path.getsize(results) / 1e6:.1f} MB in the last file")


if __name__ == "__main__":
    main()
