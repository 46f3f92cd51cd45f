"""The installed program on a display: sign-in page, an exercise file from the desktop for a student and for an instructor.

    /usr/bin/python3 tests/package/installed.py     (run.sh runs it in a bare Debian)
"""
import os
import re
import shutil
import subprocess
import sys

sys.path.insert(0, os.path.abspath(__file__ + "/../../outside/desktop"))
import desk  # noqa: E402
import exchange  # noqa: E402
import school  # noqa: E402

TYPE = "application/x-cusp-exercise"
EXERCISE = "Straight channel, level 1"


def exercise_file(own):
    """A station saves a copy of an exercise, which no other station has."""
    program = own.start()
    school.first_start(program)
    school.sign_in_staff(program, *school.INSTRUCTOR[1:])
    school.page(program, "Library")
    exchange.choose(program, EXERCISE)
    program.menu_to_dialog(exchange.MORE, *["Down"] * exchange.COPY, "Return")
    program.find(None, "Editor")
    program.keys("alt+Left")
    school.row_of(program, "Exercises", f"{EXERCISE} (copy)")[0].click()
    program.menu_to_dialog(exchange.MORE, *["Down"] * exchange.SAVE, "Return")
    path = os.path.join(own.folder, "exercise.cusp")
    exchange.cohort.pick(program, "Save the exercise as a file", path)
    program.find("label", re.compile("is saved as a file"))
    program.close()
    return path


def check_desktop(path):
    """What a file manager would start for the file."""
    from gi.repository import Gio
    kind, _ = Gio.content_type_guess(path, None)
    desk.check(kind == TYPE, f"{path} is {kind}")
    entry = Gio.AppInfo.get_default_for_type(TYPE, False)
    desk.check(entry is not None and entry.get_id() == "cusp.desktop", f"{TYPE} is opened by {entry and entry.get_id()}")
    desk.check(entry.get_commandline() == "cusp %f", f"its command is {entry.get_commandline()}")
    desk.check(entry.get_icon().to_string() == "cusp", f"its icon is {entry.get_icon().to_string()}")


def main():
    desk.on_own_bus()
    cusp = shutil.which("cusp")
    with desk.Desk(cusp) as sender:
        path = exercise_file(sender)
        valid = subprocess.run([cusp, "validate", path], capture_output=True, text=True)
        desk.check(valid.returncode == 0, f"cusp validate: {valid.stdout}{valid.stderr}")
        check_desktop(path)
        with desk.Desk(cusp) as station:
            program = station.start()
            school.first_start(program)
            program.close()
            program = station.start(path)
            program.find("label", "Sign in")
            school.sign_in_student(program)
            program.find("label", "exercise.cusp is not open.")
            program.press("Back")
            school.sign_out(program)
            school.sign_in_staff(program, *school.INSTRUCTOR[1:])
            program.find(None, "Editor")
            found = subprocess.run(["xdotool", "search", "--class", "^cusp$"], capture_output=True, text=True).stdout
            desk.check(found.strip(), "no window has the class that cusp.desktop names")
            program.close()
    print("sign-in page, exercise file refused to a student and opened for an instructor")


if __name__ == "__main__":
    main()
