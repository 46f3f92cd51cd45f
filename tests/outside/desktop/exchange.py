"""An instructor saves an exercise as NAME.cusp, opens the file as an exercise beside it, publishes that and withdraws it.

    /usr/bin/python3 tests/outside/desktop/exchange.py build/release/cusp
"""
import os
import re
import subprocess
import sys
import tarfile

import cohort
import desk
import instructor
import school

MORE = "More for the chosen exercise"
COPY, SAVE, WITHDRAW = 1, 2, 3  # entries of that menu


def choose(program, *parts):
    row = school.in_library(program, *parts)
    row[0].click()
    return row


def answer(program, question, act):
    alert = program.find("alert")
    program.find("label", re.compile(question), within=alert)
    program.press(act, within=alert)


def save(program):
    """Saves the exercise and looks into the file as any other program would."""
    choose(program, instructor.EXERCISE)
    program.menu_to_dialog(MORE, *["Down"] * SAVE, "Return")
    path = os.path.join(program.folder, "exercise.cusp")
    cohort.pick(program, "Save the exercise as a file", path)
    program.find("label", re.compile("is saved as a file"))
    with tarfile.open(path) as archive:
        desk.check(archive.getnames() == ["cusp-exercise", "scenario.json"], f"the file holds {archive.getnames()}")
    valid = subprocess.run([program.binary, "validate", "--form-only", path], capture_output=True, text=True)
    desk.check(valid.returncode == 0, f"cusp validate refuses it: {valid.stderr}")
    return path


def open_beside(program, path):
    """The library has the version before again, so that the file is another content of the same exercise."""
    program.menu_to_dialog("New exercise", "Up", "Return")
    cohort.pick(program, "Open an exercise", path)
    answer(program, "^Open .* as a new exercise", "Open as a new exercise")
    editor = program.find(None, "Editor")
    depth = program.find("spin button", "Depth", within=editor)
    desk.check(depth.value == float(instructor.DEPTH_MM), f"the file was saved {instructor.DEPTH_MM} mm deep, the editor shows {depth.value}")
    return editor


def withdraw(program, number, follows):
    program.menu_to_dialog(MORE, *["Down"] * WITHDRAW, "Return")
    answer(program, follows, f"Withdraw version {number}")
    program.find("label", re.compile(f"Version {number} of .* is withdrawn"))


def visit(program):
    """Pre: the instructor's visit has published version 4."""
    school.sign_in_staff(program, *school.INSTRUCTOR[1:])
    school.page(program, "Library")
    path = save(program)
    choose(program, instructor.EXERCISE)
    withdraw(program, 4, "Students find version 3 again")
    school.in_library(program, instructor.EXERCISE, "Version 4 withdrawn")

    editor = open_beside(program, path)
    desk.until("the checks to pass", lambda: program.find("push button", "Publish version 1", editor).has("ENABLED"))
    program.press("Publish version 1", within=editor)
    sheet = program.find("dialog", "Publish")
    program.find("label", re.compile("^It was not tried out"), within=sheet)
    program.press("Publish version 1", within=sheet)
    answer(program, "without trying it out", "Publish untried")
    program.find("label", re.compile(r"^Version 1 is published\."))
    program.press("Library", within=editor)
    choose(program, instructor.EXERCISE, "Published")
    withdraw(program, 1, "Students no longer find this exercise")
    row = [cell.name for cell in school.in_library(program, instructor.EXERCISE, "Withdrawn")]
    school.sign_out(program)
    return row


def main():
    desk.on_own_bus()
    with desk.Desk(sys.argv[1]) as own:
        program = own.start()
        school.first_start(program)
        instructor.visit(program)
        print(f"saved, opened, published and withdrawn: {visit(program)}")
        program.close()


if __name__ == "__main__":
    main()
