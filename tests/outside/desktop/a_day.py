"""A day at the school, on one screen and one file of records: the first start, a student, an instructor, the administrator.

    /usr/bin/python3 tests/outside/desktop/a_day.py build/release/cusp

CUSP_FULL=1 adds an exercise that goes out as a file and comes back, and a list of students that is imported.
"""
import os
import sys
import time

import administrator
import assessment
import cohort
import desk
import exchange
import instructor
import school
import student


def main():
    desk.on_own_bus()
    begin = time.monotonic()
    whole = "CUSP_FULL" in os.environ

    def done(what):
        print(f"{time.monotonic() - begin:5.1f} s  {what}", flush=True)

    with desk.Desk(sys.argv[1]) as own:
        program = own.start()
        school.first_start(program)
        done("the first start made an administrator, an instructor and a student")
        points = student.visit(program)
        done(f"the student drilled {student.EXERCISE}: {points} points, on the report and in the history")
        shown = instructor.visit(program)
        done(f"the instructor made a channel {instructor.DEPTH_MM} mm deep, tried it out ({', '.join(shown)}) and published it")
        if whole:
            row = exchange.visit(program)
            done(f"the exercise went out as a file, came back as another one, was published and withdrawn: {row}")
        program.close()

        program = own.start()
        row = administrator.visit(program, points)
        done(f"the administrator, after a new start, exported {row}")
        if whole:
            row = cohort.visit(program)
            done(f"a list of students was imported, and what their cohort was assigned stood on a student's start page until it was withdrawn: {row}")
        program, seen = assessment.visit(own, program)
        done(f"two students sat an assessment: {seen}")
        program.close()


if __name__ == "__main__":
    main()
