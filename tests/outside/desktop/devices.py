"""A Falcon, a foot pedal and a SpaceMouse in the running program, and the plug of each pulled while somebody drills.

    /usr/bin/python3 tests/outside/desktop/devices.py build/release/cusp build/release/cusp_plugs
"""
import hashlib
import os
import re
import sys
import time

from PIL import ImageGrab

import desk
import plugs
import school

EXERCISE = "Class I, tooth 36, turbine and water"
DOWN = (0.0, -0.016, 0.125)  # of the grip: into the enamel
OVER = (0.0, 0.004, 0.125)   # clear of it


def station(own, theme="light", language="en"):
    """Drills with the Falcon, as somebody chose on the device page before."""
    folder = os.path.join(own.folder, "config", "Cusp")
    os.makedirs(folder, exist_ok=True)
    with open(os.path.join(folder, "Cusp.ini"), "w", encoding="utf-8") as f:
        f.write(f"[device]\nkind=falcon\nname=FT000001\n[look]\ntheme={theme}\nlanguage={language}\n")


def reached(program, what, look, press=lambda: None):
    """As desk.until(), for a machine with other work: a mock that answers too late stops the attempt, and it is resumed. What was
    down over the stop cuts only once it was released: `press` does so, and presses it anew."""
    def asked():
        if program.here("label", re.compile("^The device answered too late")):
            desk.until("the attempt to go on", lambda: (press_if(program, "Resume"), program.here("push button", "Resume"))[1] is None)
            press()
        return look()
    return desk.until(what, asked)


def anew(hand, up, down):
    """Releases what is down and presses it again. Both are seen by a tick."""
    hand(*up)
    time.sleep(0.1)
    hand(*down)


def press_if(program, name):
    button = program.here("push button", name)
    if button is not None and button.has("ENABLED"):
        button.press()


def speed(program):
    """Of the bur, as the handpiece's panel shows it."""
    for label in program.all("label", re.compile(r"rpm$")):
        return int(re.sub(r"\D", "", label.name))
    return None


def view(own, program):
    """What the view shows now of the tooth, between the card that stops an attempt and the coach."""
    x, y = program.find(None, "Tooth").middle()
    picture = ImageGrab.grab(bbox=(x - 150, y + 100, x + 150, y + 250), xdisplay=program.screen.display)
    return hashlib.sha256(picture.tobytes()).hexdigest()


def still(own, program):
    """The view once it has come to rest."""
    last = [None]

    def at_rest():
        before, last[0] = last[0], view(own, program)
        return before == last[0]
    desk.until("the view to stand still", at_rest)
    return last[0]


def start(program, hand):
    """From the sign-in to an attempt on the Falcon: the screen asks for homing, the hand homes."""
    school.sign_in_student(program)
    school.brief(program, EXERCISE)
    program.press("Start")
    program.find("label", "Finding its middle")
    hand("falcon", "home")
    desk.until("the attempt to begin", lambda: program.find("push button", "Finish").has("ENABLED"))


def with_the_pedal(program, hand):
    def press():
        anew(hand, ("pedal", "up"), ("pedal", "down"))

    hand("falcon", "sway", *DOWN)
    desk.check(speed(program) == 0, f"the bur turns before anybody asks for it: {speed(program)}")
    reached(program, "the pedal to be found and to start the handpiece", lambda: (hand("pedal", "down"), speed(program))[1], press)
    reached(program, "the pedal to cut", lambda: school.removed_mm3(program) > 0.05, press)
    turning = speed(program)
    hand("pedal", "unplug")
    reached(program, "the handpiece to stop", lambda: speed(program) == 0)
    gone = school.removed_mm3(program)
    hand("pedal", "plug")
    time.sleep(1.0)  # long enough for ten pictures of the panel: nothing may come of it
    desk.check(speed(program) == 0 and school.removed_mm3(program) == gone, "a pedal that was plugged in again drills by itself")
    reached(program, "the pedal to drill again", lambda: (hand("pedal", "down"), school.removed_mm3(program) > gone)[1], press)
    hand("pedal", "up")
    reached(program, "the handpiece to stop", lambda: speed(program) == 0)
    return f"{turning} rpm by foot, none once its plug was out, and again by foot"


def with_the_space_mouse(own, program, hand):
    hand("falcon", "hold", *OVER)
    before = still(own, program)
    hand("mouse", "turn", 0, 0, 300)
    desk.until("the view to turn", lambda: view(own, program) != before)
    hand("mouse", "unplug")
    turned = still(own, program)
    desk.check(turned != before, "the view sprang back")
    hand("mouse", "plug")
    mirror = program.find(re.compile("check box|push button|toggle button"), "Mirror")
    reached(program, "the right button to put the mirror in", lambda: (hand("mouse", "buttons", 0), hand("mouse", "buttons", 2),
                                                                 time.sleep(0.1), mirror.has("CHECKED"))[3])
    hand("mouse", "buttons", 0)
    mirrored = still(own, program)
    desk.check(mirrored != turned, "the mirror shows the same")
    hand("mouse", "buttons", 1)
    reached(program, "the left button to bring the view back", lambda: view(own, program) != mirrored)
    hand("mouse", "buttons", 0)
    return "the view turned, stood still once its plug was out, and went into the mirror and back"


def with_the_falcon(own, program, hand, picture=lambda name: None):
    def press():
        anew(hand, ("falcon", "buttons", 0), ("falcon", "buttons", 4))

    gone = school.removed_mm3(program)
    hand("falcon", "buttons", 4)
    hand("falcon", "sway", *DOWN)
    reached(program, "the Falcon's button to drill", lambda: school.removed_mm3(program) > gone + 0.02, press)
    hand("falcon", "unplug")
    program.find("label", "The device does not answer")
    gone = school.removed_mm3(program)
    picture("gone")
    hand("falcon", "buttons", 0)
    hand("falcon", "forget")
    hand("falcon", "plug")
    program.find("label", "Finding its middle")
    picture("homing")
    hand("falcon", "home")
    desk.until("it to answer again", lambda: program.here("label", "The device does not answer") is None)
    picture("back")
    desk.until("it to resume", lambda: (press_if(program, "Resume"), program.here("push button", "Pause"))[1])
    hand("falcon", "buttons", 4)
    hand("falcon", "sway", *DOWN)
    reached(program, "it to drill again", lambda: school.removed_mm3(program) > gone, press)
    hand("falcon", "buttons", 0)
    return "the attempt stood still while its plug was out, and went on where it was"


def main():
    desk.on_own_bus()
    begin = time.monotonic()

    def done(what):
        print(f"{time.monotonic() - begin:5.1f} s  {what}", flush=True)

    with plugs.Plugs(os.path.abspath(sys.argv[2])) as hand, desk.Desk(sys.argv[1]) as own:
        for device in ("falcon", "pedal", "mouse"):
            hand(device, "plug")
        station(own)
        program = own.start(**hand.environment)
        school.first_start(program)
        done("a school")
        start(program, hand)
        done("an attempt began on the Falcon once it was homed")
        done("pedal: " + with_the_pedal(program, hand))
        done("SpaceMouse: " + with_the_space_mouse(own, program, hand))
        done("Falcon: " + with_the_falcon(own, program, hand))
        school.finish(program)
        done("the attempt was finished and graded")
        program.close()


if __name__ == "__main__":
    main()
