#!/usr/bin/env python3
"""Runs a build's tests, but for those that passed before on the same bits.

  passed.py BUILD [--again] [CTEST ARGUMENT ...]     --again: all of them

A test stands by what it was run on: its program and command, what the environment asks of tests and sanitizers, every file
of the tree but the tests' own sources (its program has those), the sample data beside the tree, every program of the build
that is no test, and the system's packages. It is run again when one bit of that differs or when it did not pass. What
passed is kept in BUILD/passed.json.
"""
import hashlib
import json
import os
import pathlib
import re
import subprocess
import sys
import xml.etree.ElementTree as ElementTree

TREE = pathlib.Path(__file__).resolve().parent.parent
NOT_OF_THE_TREE = {"build", ".git"}
SAMPLES = TREE.parent / "shared" / "data"
ASKS = re.compile(r"CUSP_|.*SAN_OPTIONS$|QT_|DISPLAY$|LANG$|LC_")
READS_ALL_SOURCES = "architecture"  # the label of tests that do


def digest(*parts):
    h = hashlib.sha256()
    for part in parts:
        data = part if isinstance(part, bytes) else str(part).encode()
        h.update(len(data).to_bytes(8, "little") + data)
    return h.hexdigest()


def of_file(path):
    return digest(pathlib.Path(path).read_bytes())


def of_tree():
    """With the tests' own sources, and without."""
    names = sorted(str(p.relative_to(TREE)) for top in TREE.iterdir() if top.name not in NOT_OF_THE_TREE
                   for p in (top.rglob("*") if top.is_dir() else [top]) if p.is_file() and "__pycache__" not in p.parts)
    names += sorted(str(p) for p in SAMPLES.rglob("*") if p.is_file())
    each = [(name, of_file(TREE / name)) for name in names]
    own = re.compile(r"^tests/.*\.(cpp|h)$")
    return digest(json.dumps(each)), digest(json.dumps([e for e in each if not own.match(e[0])]))


def keys_of(build, tests):
    whole, but_tests = of_tree()
    packages = pathlib.Path("/var/lib/dpkg/status")
    system = of_file(packages) if packages.exists() else ""
    programs = {str(p) for p in build.iterdir() if p.is_file() and os.access(p, os.X_OK)}
    others = sorted(programs - {test["command"][0] for test in tests})
    around = digest(system, json.dumps([(p, of_file(p)) for p in others]),
                    json.dumps(sorted((k, v) for k, v in os.environ.items() if ASKS.match(k))))
    keys = {}
    for test in tests:
        told = {p["name"]: p["value"] for p in test.get("properties", [])}
        tree = whole if READS_ALL_SOURCES in told.get("LABELS", []) else but_tests
        files = [of_file(a) for a in test["command"] if os.path.isfile(a)]
        keys[test["name"]] = digest(tree, around, json.dumps(test["command"]), json.dumps(told, sort_keys=True), *files)
    return keys


def read(kept):
    try:
        return json.loads(kept.read_text())
    except (OSError, ValueError):
        return {}


def main():
    arguments = sys.argv[1:]
    again = "--again" in arguments
    if again:
        arguments.remove("--again")
    if not arguments:
        sys.exit(__doc__)
    build, arguments = pathlib.Path(arguments[0]).resolve(), arguments[1:]
    kept, report = build / "passed.json", build / "passed.xml"

    listed = subprocess.run(["ctest", "--test-dir", build, "--show-only=json-v1", *arguments], check=True, capture_output=True)
    tests = [t for t in json.loads(listed.stdout)["tests"] if t.get("command")]
    if not tests:
        sys.exit("There is no test to run.")
    keys = keys_of(build, tests)
    passed = read(kept)
    known = [] if again else [name for name in keys if passed.get(name) == keys[name]]
    if known:
        print(f"{len(known)} of {len(keys)} tests passed before on the same bits (./check --again runs them all the same).", flush=True)
    if len(known) == len(keys):
        return 0

    report.unlink(missing_ok=True)
    leave = ["-E", "^(" + "|".join(re.escape(name) for name in known) + ")$"] if known else []
    done = subprocess.run(["ctest", "--test-dir", build, "--output-on-failure", "--no-tests=error", "--output-junit", report,
                           *arguments, *leave])
    for case in ElementTree.parse(report).getroot().iter("testcase") if report.exists() else []:
        if case.get("status") == "run" and case.get("name") in keys:
            passed[case.get("name")] = keys[case.get("name")]
        else:
            passed.pop(case.get("name"), None)
    kept.write_text(json.dumps(passed, indent=1))
    return done.returncode


if __name__ == "__main__":
    sys.exit(main())
