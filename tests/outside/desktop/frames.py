"""Figures of the drilling screen while a tooth is cut with the mouse: frames a second, and how long from the tick that
changed the tooth to the end of the frame that shows it. Prints them with the machine's load; fails only where no frame of
a changing tooth was drawn, for a busy machine proves nothing about the program.

    /usr/bin/python3 tests/outside/desktop/frames.py build/release/cusp [seconds of drilling [exercise ...]]

An exercise is a folder of scenarios/library: class-1-36 is a molar alone, class-2-36-do has neighbours and gums.
"""
import json
import math
import os
import sys

import desk
import school

STEP_S = 0.016  # between two places of the mouse
EXERCISES = ("class-1-36", "class-2-36-do")


def title_of(exercise):
    with open(os.path.join(desk.SOURCE, "scenarios", "library", exercise, "scenario.json"), encoding="utf-8") as f:
        return json.load(f)["title"]["en"]


def cut(program, seconds):
    """Over the crown, each pass beside the last one, so that the bur finds tissue all the time."""
    x, y = program.find(None, "Tooth").middle()
    path = []
    for i in range(round(seconds / STEP_S)):
        t = i * STEP_S
        path += ["mousemove", round(x + 150 * math.sin(2.1 * t)), round(y + 90 * math.sin(0.37 * t)), "sleep", STEP_S]
    program.screen.x("mousemove", x, y, "mousedown", 1)
    program.screen.x(*path)
    program.screen.x("mouseup", 1)


def figures_of(program, figures, exercise, seconds):
    """What FrameStats counted in one attempt at the exercise."""
    school.begin(program, title_of(exercise))
    before = os.getloadavg()[0]
    cut(program, seconds)
    school.finish(program)
    desk.until("the figures", lambda: os.path.exists(figures) and os.path.getsize(figures) > 0)
    with open(figures, encoding="utf-8") as f:
        found = json.load(f)
    os.remove(figures)
    found["load_before"], found["load_after"] = before, os.getloadavg()[0]
    school.home(program)
    return found


def main():
    desk.on_own_bus()
    seconds = float(sys.argv[2]) if len(sys.argv) > 2 else 20
    with desk.Desk(sys.argv[1]) as own:
        figures = os.path.join(own.folder, "frames.json")
        program = own.start(CUSP_FRAME_STATS=figures)
        school.first_start(program)
        school.sign_in_student(program)
        for exercise in sys.argv[3:] or EXERCISES:
            found = figures_of(program, figures, exercise, seconds)
            print(json.dumps({"exercise": exercise} | found), flush=True)
            print(f"{exercise}: {found['fps_while_cutting']:.1f} frames a second, tick to picture p50 {found['latency_p50_ms']:.0f} ms, "
                  f"p95 {found['latency_p95_ms']:.0f} ms", flush=True)
            desk.check(found["changed_frames"] > 0, f"no frame showed the tooth of {exercise} change")
        program.close()


if __name__ == "__main__":
    main()
