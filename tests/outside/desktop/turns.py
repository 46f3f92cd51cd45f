"""The longest turns of the main thread's event loop on the three roles' paths, in its own processor time, each with its page and
where it stood after 50 ms. Fails above MOST_MS: a wide bound, since a figure depends on the machine and on what runs beside it.

    /usr/bin/python3 tests/outside/desktop/turns.py build/release/cusp build/release/tests/outside/desktop/libcusp-turns.so
"""
import os
import re
import subprocess
import sys
import time

import cohort
import desk
import pictures
import school
import student

MOST_MS = 400
SHOWN = 15  # turns printed, the longest first
VOLUME_MM = 20  # side of the imported cube


class Path:
    """Where the walk is, and since when."""

    def __init__(self):
        self.stations = []

    def at(self, name):
        self.stations.append((time.monotonic(), name))

    def of(self, moment):
        return next((name for since, name in reversed(self.stations) if since <= moment), "program start")


def rest(seconds=1.5):
    """What a page draws in the background comes meanwhile."""
    time.sleep(seconds)


def pages(path, program, role, names):
    for name in names:
        path.at(f"{role}: {name}")
        school.page(program, name)
        rest()


def of_student(path, program):
    path.at("student: sign-in")
    school.sign_in_student(program)
    program.find(None, "Pages")
    rest()
    pages(path, program, "student", ["Exercises"])
    path.at("student: briefing")
    school.brief(program, student.EXERCISE)
    rest()
    path.at("student: opening the tooth")
    program.press("Start")
    desk.until("the tooth to be ready", lambda: program.find("push button", "Finish").has("ENABLED"))
    rest()
    path.at("student: drilling")
    school.drill(program, 0.3)
    for key in ("3", "2", "2", "p", "p"):
        program.keys(key)
        rest(1)
    path.at("student: grading and report")
    school.finish(program)
    rest(5)
    path.at("student: back from the report")
    school.home(program)
    pages(path, program, "student", ["My results", "Device", "Help"])
    school.sign_out(program)


def of_instructor(path, program):
    path.at("instructor: sign-in")
    school.sign_in_staff(program, *school.INSTRUCTOR[1:])
    program.find(None, "Pages")
    pages(path, program, "instructor", ["Performance", "Cohorts", "Exercises", "Library"])
    path.at("instructor: editor")
    program.find("text", "Find an exercise").type(student.EXERCISE)
    program.keys("Return")
    program.find(None, "Editor")
    desk.until("the tooth to be grown", lambda: program.find("push button", "Try out").has("ENABLED"), 120)
    for tab in ("Shape", "Points", "Burs", "Tissues", "Texts", "Audit"):
        path.at(f"instructor: editor, {tab}")
        program.press(tab, "page tab")
        rest()
    program.keys("alt+Left")
    pages(path, program, "instructor", ["Performance"])
    path.at("instructor: report")
    school.row_of(program, "Attempts", school.STUDENT[0], student.EXERCISE)[0].click()
    program.keys("Return")
    school.points_on_report(program)
    rest(5)
    path.at("instructor: back from the report")
    school.home(program)
    of_volume(path, program)
    school.sign_out(program)


def enabled(program, name, within=None):
    desk.until(f"{name!r} to be enabled", lambda: program.find("push button", name, within).has("ENABLED"))
    return program.find("push button", name, within)


def of_volume(path, program):
    """An exercise on an imported volume, published untried."""
    school.page(program, "Library")
    path.at("instructor: import of a mesh")
    program.press("Import a specimen")
    file = os.path.join(program.folder, "cube.stl")
    pictures.cube(file, VOLUME_MM)
    program.press("Choose a file…")
    cohort.pick(program, "Choose a file", file)
    enabled(program, "Make a specimen").press()
    enabled(program, "Keep it and make an exercise").press()
    editor = program.find(None, "Editor")
    enabled(program, "Publish version 1", editor).press()
    sheet = program.find("dialog", "Publish")
    path.at("instructor: publishing a volume")
    program.press("Publish version 1", within=sheet)
    program.press("Publish untried", within=program.find("alert"))
    program.find("label", re.compile(r"^Version 1 is published\."))
    path.at("instructor: after publishing")
    program.press("Library", within=editor)
    program.find(None, "Pages")


def of_administrator(path, program):
    path.at("administrator: sign-in")
    school.sign_in_staff(program, *school.ADMINISTRATOR[1:])
    program.find(None, "Pages")
    pages(path, program, "administrator", ["People", "Performance", "Station", "Other stations", "Audit log", "Device"])
    school.sign_out(program)


def named(place):
    """A place in the program by its function, where it has symbols."""
    file, _, offset = place.rpartition("+")
    if not os.path.isfile(file):
        return place
    line = subprocess.run(["addr2line", "-Cfpe", file, "0x" + offset], capture_output=True, text=True).stdout
    return re.sub(r"\(.*", "", line.split(" at ")[0].strip()) or place


def where(stack):
    """The program's own functions, the innermost first; without symbols the libraries."""
    own = [name for name in map(named, stack) if "cusp::" in name][:5]
    return " < ".join(own) or " ".join(os.path.basename(place) for place in stack[2:8])


def main():
    desk.on_own_bus()
    path = Path()
    with desk.Desk(sys.argv[1]) as own:
        turns = os.path.join(own.folder, "turns")
        program = own.start(LD_PRELOAD=os.path.abspath(sys.argv[2]), CUSP_TURNS=turns)
        path.at("first start and people")
        school.first_start(program)
        of_student(path, program)
        of_instructor(path, program)
        of_administrator(path, program)
        path.at("administrator: import of people")
        cohort.import_list(program)
        program.close()
        with open(turns, encoding="utf-8") as f:
            found = [(float(ms), float(moment), stack) for moment, ms, *stack in map(str.split, f)]
    found.sort(reverse=True)
    print(f"{sum(ms > 100 for ms, _, _ in found)} turns over 100 ms, {len(found)} over 50 ms; load {os.getloadavg()[0]:.1f}")
    for ms, moment, stack in found[:SHOWN]:
        print(f"{ms:5.0f} ms  {path.of(moment - ms / 1e3)}: {where(stack)}")
    desk.check(not found or found[0][0] <= MOST_MS, f"a turn took more than {MOST_MS} ms")


if __name__ == "__main__":
    main()
