#!/usr/bin/env python3
"""tests/passed.py on a build of three programs: what it runs again, and what not."""
import os
import pathlib
import subprocess
import sys
import tempfile

PASSED = pathlib.Path(__file__).resolve().parent / "passed.py"


def main():
    with tempfile.TemporaryDirectory(prefix="cusp-passed-") as folder:
        build = pathlib.Path(folder)
        runs = build / "runs"

        def program(name, ending, more=""):
            file = build / name
            file.write_text(f"#!/bin/sh\necho {name} >> {runs}\n{more}exit {ending}\n")
            file.chmod(0o755)

        def check(ending, *ran, arguments=(), asks=None):
            runs.write_text("")
            done = subprocess.run([sys.executable, PASSED, build, *arguments], env={**os.environ, **(asks or {})},
                                  capture_output=True, text=True)
            told = sorted(runs.read_text().split())
            if (done.returncode != 0) != (ending != 0) or told != sorted(ran):
                sys.exit(f"expected {sorted(ran)} and {ending}, had {told} and {done.returncode}\n{done.stdout}{done.stderr}")

        (build / "CTestTestfile.cmake").write_text("".join(f'add_test({n} "{build / n}")\n' for n in ("one", "two", "red")))
        program("one", 0)
        program("two", 0)
        program("red", 1)
        check(1, "one", "two", "red")
        check(1, "red")                         # only what passed is not run again
        program("red", 0)
        check(0, "red")
        check(0)
        program("two", 0, more=": changed\n")
        check(0, "two")
        program("helper", 0)                    # a program that tests may start
        check(0, "one", "two", "red")
        check(0)
        check(0, "one", "two", "red", arguments=["--again"])
        check(0, "one", "two", "red", asks={"CUSP_RANDOM_FULL": "1"})
        check(0, "one", "two", "red")           # asked otherwise again
        program("one", 1)
        check(1, "one")
        program("one", 0)                       # the bits that passed before it failed
        check(0, "one")
        (build / "passed.json").write_text("{ cut off")
        check(0, "one", "two", "red")
        check(0, "one", arguments=["--again", "-R", "one"])
        (build / "CTestTestfile.cmake").write_text("")
        check(1)                                # no tests at all are no success


if __name__ == "__main__":
    main()
