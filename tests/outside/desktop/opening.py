"""How long the program takes to its sign-in, and an exercise from Start to the tooth seen: the first time, again in the same
program, and in a new one. Prints a table; seconds by the clock, and of processor time of the whole program in brackets.

    /usr/bin/python3 tests/outside/desktop/opening.py build/release/cusp [exercise ...]
"""
import os
import sys
import time

import desk
import school

EXERCISES = ("Class I, tooth 36", "Class II DO, adhesive, tooth 36", "Class I, tooth 36, in the full lower jaw")
TICKS = os.sysconf("SC_CLK_TCK")


def cpu_s(process):
    """Of all threads of a running program."""
    with open(f"/proc/{process.pid}/stat", encoding="ascii") as f:
        fields = f.read().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / TICKS


def stopped_watch(program, look):
    """Seconds from now until `look` returns something, by clock and processor."""
    start, before = time.monotonic(), cpu_s(program.process)
    while not look():
        program.alive()
        time.sleep(0.02)
    return f"{time.monotonic() - start:6.2f} ({cpu_s(program.process) - before:5.2f})"


def open_once(program, exercise):
    """From Start to the tooth seen; then the attempt is left."""
    school.brief(program, exercise)
    start = program.find("push button", "Start")
    time.sleep(2)  # who reads a briefing
    start.press()
    finish = program.find("push button", "Finish")
    took = stopped_watch(program, lambda: finish.has("ENABLED"))
    program.press("Leave")
    program.press("Back")
    program.find(None, "Pages")
    return took


def start_timed(own):
    start = time.monotonic()
    program = own.start()
    program.find("label", "Sign in")
    return program, time.monotonic() - start


def main():
    desk.on_own_bus()
    exercises = sys.argv[2:] or EXERCISES
    with desk.Desk(sys.argv[1]) as own:
        program = own.start()
        school.first_start(program)
        program.close()
        rows = {exercise: [] for exercise in exercises}
        starts = []
        for visits in (2, 1):
            program, took = start_timed(own)
            starts.append(f"{took:.2f}")
            school.sign_in_student(program)
            for exercise in exercises:
                rows[exercise] += [open_once(program, exercise) for _ in range(visits)]
            school.sign_out(program)
            program.close()
        print("load", os.getloadavg()[0], "; start to sign-in, s:", ", ".join(starts))
        print(f"{'from Start to the tooth seen, s':40} {'first':>15} {'again':>15} {'new program':>15}")
        for exercise, took in rows.items():
            print(f"{exercise:40} {took[0]:>15} {took[1]:>15} {took[2]:>15}")


if __name__ == "__main__":
    main()
