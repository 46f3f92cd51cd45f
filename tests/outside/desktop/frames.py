"""Figures of the drilling screen while the molar is cut with the mouse: frames a second, and how long from the tick that
changed the tooth to the end of the frame that shows it. Prints them with the machine's load; fails only where no frame of
a changing tooth was drawn, for a busy machine proves nothing about the program.

    /usr/bin/python3 tests/outside/desktop/frames.py build/release/cusp [seconds of drilling]
"""
import json
import math
import os
import sys

import desk
import school
import student

STEP_S = 0.016  # between two places of the mouse


def main():
    desk.on_own_bus()
    seconds = float(sys.argv[2]) if len(sys.argv) > 2 else 20
    with desk.Desk(sys.argv[1]) as own:
        figures = os.path.join(own.folder, "frames.json")
        program = own.start(CUSP_FRAME_STATS=figures)
        school.first_start(program)
        school.sign_in_student(program)
        school.begin(program, student.EXERCISE)
        x, y = program.find(None, "Tooth").middle()
        load = os.getloadavg()[0]
        program.screen.x("mousemove", x, y, "mousedown", 1)
        # Over the crown, each pass beside the last one, so that the bur finds tissue all the time.
        path = []
        for i in range(round(seconds / STEP_S)):
            t = i * STEP_S
            path += ["mousemove", round(x + 150 * math.sin(2.1 * t)), round(y + 90 * math.sin(0.37 * t)), "sleep", STEP_S]
        program.screen.x(*path)
        program.screen.x("mouseup", 1)
        school.finish(program)
        desk.until("the figures", lambda: os.path.exists(figures) and os.path.getsize(figures) > 0)
        with open(figures, encoding="utf-8") as f:
            found = json.load(f)
        found["load_before"], found["load_after"] = load, os.getloadavg()[0]
        print(json.dumps(found, indent=2))
        program.close()
        desk.check(found["changed_frames"] > 0, "no frame showed the tooth change")


if __name__ == "__main__":
    main()
