#!/usr/bin/env python3
"""Plants each fault of faults.py in a copy of the tree and requires that the default ./check catches it.

  plant.py [--folder FOLDER] [--only WORD]
  plant.py --texts                            only looks for the texts to be replaced, in the caller's tree

FOLDER (default build/planted) keeps the copy with its build folders for the next run; the caller's tree is never changed.
A fault counts as caught if its target builds, its test fails, and the failure is the expected one. Then the unplanted copy
must pass the same tests. --only: the faults whose name holds WORD. Exit status 1: a fault was missed; 2: a text to be
replaced is gone, so faults.py is out of date.
"""
import argparse
import filecmp
import os
import re
import shutil
import subprocess
import sys
import time

from faults import FAULTS

ROOT = os.path.abspath(os.path.join(os.path.dirname(__file__), "..", ".."))
TIMEOUT_S = 7200  # of a build with sanitizers on a busy machine


def files_of_tree():
    """Names from the root, in a clone or an unpacked archive, without what git and the builds keep."""
    for at, folders, files in os.walk(ROOT):
        skipped = (".git", "build", "__pycache__") if at == ROOT else ("__pycache__",)
        folders[:] = [name for name in folders if name not in skipped]
        yield from (os.path.relpath(os.path.join(at, name), ROOT) for name in files if name not in skipped)


class Copy:
    """The tree's files, brought up to date; unchanged files keep their times."""

    def __init__(self, folder):
        self.folder = os.path.abspath(folder)
        names = {name for name in files_of_tree() if os.path.isfile(os.path.join(ROOT, name))}
        for name in names:
            here, there = os.path.join(ROOT, name), self.path(name)
            if os.path.exists(there) and filecmp.cmp(here, there, shallow=False):
                continue
            os.makedirs(os.path.dirname(there), exist_ok=True)
            shutil.copy(here, there)  # with a time of now
        for at, folders, files in os.walk(self.folder):
            if at == self.folder and "build" in folders:
                folders.remove("build")
            for file in files:
                if os.path.relpath(os.path.join(at, file), self.folder) not in names:
                    os.remove(os.path.join(at, file))
        os.makedirs(self.path("build"), exist_ok=True)
        self.environment = dict(os.environ, CCACHE_BASEDIR=self.folder, CCACHE_NOHASHDIR="1",
                                CCACHE_SLOPPINESS="pch_defines,time_macros", CCACHE_PCH_EXTSUM="1",
                                UBSAN_OPTIONS="print_stacktrace=1:halt_on_error=1", TSAN_OPTIONS="halt_on_error=1")

    def path(self, name):
        return os.path.join(self.folder, name)

    def read(self, name):
        with open(self.path(name), encoding="utf-8") as file:
            return file.read()

    def write(self, name, text):
        with open(self.path(name), "w", encoding="utf-8") as file:
            file.write(text)

    def run(self, *command):
        """Exit status and output of a command in the copy."""
        done = subprocess.run(command, cwd=self.folder, env=self.environment, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, timeout=TIMEOUT_S)
        return done.returncode, done.stdout.decode(errors="replace")

    def build(self, preset, targets):
        if not os.path.exists(self.path(f"build/{preset}/build.ninja")):
            status, output = self.run("cmake", "--preset", preset)
            if status != 0:
                return status, output
        return self.run("cmake", "--build", self.path(f"build/{preset}"), "--target", *targets, "--", "--quiet")

    def test(self, preset, tests):
        # The preset's filter is ./check's: a test that it leaves out is not found here either.
        return self.run("ctest", "--preset", preset, "--no-tests=error", "-R", "^(" + "|".join(tests) + ")$")


class Planted:
    """A fault in the copy, for the length of a block."""

    def __init__(self, copy, fault):
        self.copy, self.fault = copy, fault
        self.before = {file: copy.read(file) for file, _, _ in fault.edits}

    def __enter__(self):
        texts = dict(self.before)
        for file, find, put in self.fault.edits:
            texts[file] = texts[file].replace(find, put)
        for file, text in texts.items():
            self.copy.write(file, text)

    def __exit__(self, *_):
        for file, text in self.before.items():
            self.copy.write(file, text)


def read_tree(name):
    with open(os.path.join(ROOT, name), encoding="utf-8") as file:
        return file.read()


def check_texts(faults):
    gone = [f"{f.name}: {file} holds {read_tree(file).count(find)} times: {find.strip()}"
            for f in faults for file, find, _ in f.edits if read_tree(file).count(find) != 1]
    for line in gone:
        print(line, file=sys.stderr)
    if gone:
        sys.exit(2)


def first_line(expected, output):
    return next((line.strip() for line in output.splitlines() if re.search(expected, line)), None)


def failed_test(fault, output):
    """The GoogleTest case that was running when the expected line came, or the CTest entry."""
    at = re.search(fault.expected, output)
    running = re.findall(r"\[ RUN      \] (\S+)", output[:at.start()] if at else output)
    return f"{fault.test}: {running[-1]}" if running else fault.test


def outcome(copy, fault):
    """(caught, by what, the first failing line)."""
    with Planted(copy, fault):
        status, output = copy.build(fault.preset, [fault.target])
        if fault.test is None:
            line = first_line(fault.expected, output)
            return status != 0 and line is not None, "the compiler", line or output[-2000:]
        if status != 0:
            return False, "nothing: it does not build", output[-2000:]
        status, output = copy.test(fault.preset, [fault.test])
    line = first_line(fault.expected, output)
    if status == 0:
        return False, f"nothing: {fault.test} passes", ""
    if line is None:
        return False, "nothing: it fails otherwise", output[-2000:]
    return True, failed_test(fault, output), line


def unplanted_passes(copy, faults):
    good = True
    for preset in sorted({f.preset for f in faults}):
        tests = sorted({f.test for f in faults if f.preset == preset and f.test})
        status, output = copy.build(preset, sorted({f.target for f in faults if f.preset == preset}))
        if status == 0 and tests:  # the compiler alone refuses some faults
            status, output = copy.test(preset, tests)
        print(f"unplanted, {preset}: {'passes' if status == 0 else 'FAILS'} {' '.join(tests)}", flush=True)
        if status != 0:
            print(output[-4000:])
            good = False
    return good


def main():
    arguments = argparse.ArgumentParser()
    arguments.add_argument("--folder", default=os.path.join(ROOT, "build", "planted"))
    arguments.add_argument("--only", default="")
    arguments.add_argument("--texts", action="store_true")
    o = arguments.parse_args()
    check_texts(FAULTS)
    if o.texts:
        return
    copy = Copy(o.folder)
    faults = [f for f in FAULTS if o.only in f.name]
    missed = []
    print("| fault | caught by | first failing line | s |\n|---|---|---|---|", flush=True)
    for fault in faults:
        start = time.monotonic()
        caught, by, line = outcome(copy, fault)
        if not caught:
            missed.append(fault.name)
        shown = line.replace(copy.folder + "/", "").replace("|", "/")
        print(f"| {fault.name} | {by} | {shown[:160] if caught else 'MISSED'} | {time.monotonic() - start:.0f} |", flush=True)
        if not caught:
            print(line)
    good = unplanted_passes(copy, faults)
    print(f"{len(faults) - len(missed)} of {len(faults)} faults caught" + (f"; missed: {', '.join(missed)}" if missed else ""))
    sys.exit(0 if good and faults and not missed else 1)


if __name__ == "__main__":
    main()
