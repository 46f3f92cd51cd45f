"""Pictures of the pages of a school that is full: two thousand students, fifty thousand sessions.

    build/release/cusp-grow-school FILE.db 50000
    /usr/bin/python3 tests/outside/desktop/full_school.py build/release/cusp FILE.db FOLDER [light|dark-german|large|double ...]
"""
import os
import shutil
import sys
import time

import desk
import pictures
import school

ADMINISTRATOR = ("admin", "correct horse")
INSTRUCTOR = ("okafor", "battery staple")
STUDENT = ("20260000", "314159")
RESTS_S = 3  # what a page draws in the background


def visit(album, program, role, names):
    for name in names:
        before = time.monotonic()
        school.page(program, name)
        seconds = time.monotonic() - before
        album.take(program, f"{role}-{name.lower().replace(' ', '-')}", rests_s=RESTS_S)
        print(f"  {name}: {seconds:.2f} s until the page answers")


def walk(binary, records, folder, look):
    os.makedirs(folder, exist_ok=True)
    with pictures.desk_of(binary, look) as own:
        for beside in ("", ".key", ".key-counter"):
            shutil.copy(records + beside, own.database + beside)
        album = pictures.Album(own, folder)
        program = own.start()
        pictures.fill_screen(program, look)
        school.sign_in_student(program, *STUDENT)
        program.find(None, "Pages")
        album.take(program, "student-start", rests_s=RESTS_S)
        visit(album, program, "student", ["My results"])
        school.sign_out(program)
        school.sign_in_staff(program, *INSTRUCTOR)
        visit(album, program, "instructor", ["Library", "Cohorts", "Performance"])
        school.sign_out(program)
        school.sign_in_staff(program, *ADMINISTRATOR)
        visit(album, program, "administrator", ["People", "Cohorts", "Performance", "Station", "Audit log"])
        program.close()
        album.sheet()


def main():
    desk.on_own_bus()
    for name in sys.argv[4:] or pictures.LOOKS:
        walk(sys.argv[1], os.path.abspath(sys.argv[2]), os.path.join(os.path.abspath(sys.argv[3]), name), pictures.LOOKS[name])


if __name__ == "__main__":
    main()
