"""An instructor changes the depth of a target, tries the exercise out, and publishes it as a new version.

    /usr/bin/python3 tests/outside/desktop/instructor.py build/release/cusp
"""
import re
import sys

import desk
import school

EXERCISE = "Straight channel, level 1"
DEPTH_MM = "1.50"  # it ships with 2.00


def choose_devices(program):
    """As a screen reader chooses: by the action alone, never by the mouse."""
    for device in ("Emulated Falcon, driven by mouse", "Mouse and keys"):
        school.page(program, "Device")
        program.press(device, "radio button")
        side = program.find(None, "Pages")
        program.find("label", device, within=side)
        school.page(program, "Library")
        program.find("label", device, within=side)


def visit(program):
    school.sign_in_staff(program, *school.INSTRUCTOR[1:])
    choose_devices(program)
    school.page(program, "Library")
    school.in_library(program, EXERCISE)[0].click()
    program.press("Open in the editor")
    editor = program.find(None, "Editor")
    publish = program.find("push button", re.compile("^Publish version"), within=editor)
    desk.check(not publish.has("ENABLED"), "nothing was changed, and still it could be published")

    depth = program.find("spin button", "Depth", within=editor)
    desk.check(depth.value == 2.0, f"the channel ships 2.0 mm deep, the editor shows {depth.value}")
    depth.click()
    program.keys("ctrl+a")
    program.screen.x("type", "--delay", 8, DEPTH_MM)
    program.keys("Return")
    desk.until("the depth to be taken", lambda: depth.value == float(DEPTH_MM))
    # One step back and forth: what was typed is one edit.
    program.press("Undo", within=editor)
    desk.until("the depth to be as before", lambda: depth.value == 2.0)
    program.press("Redo", within=editor)
    desk.until("the depth to be changed again", lambda: depth.value == float(DEPTH_MM))

    desk.until("the try-out to be ready", lambda: program.find("push button", "Try out", editor).has("ENABLED"))
    program.press("Try out")
    program.find("label", "Try-out: nothing is kept")
    desk.until("the block to be ready", lambda: program.find("push button", "Finish").has("ENABLED"))
    school.drill(program, least_mm3=0.2)
    school.finish(program)
    depth_row = [cell.name for cell in school.row_of(program, "Criteria", "Floor depth, mean")]
    program.keys("alt+Left")

    editor = program.find(None, "Editor")
    depth = program.find("spin button", "Depth", within=editor)
    desk.check(depth.value == float(DEPTH_MM), f"after the try-out the depth is {depth.value}")
    program.press(re.compile("^Publish version 4"), within=editor)
    sheet = program.find("dialog", "Publish")
    program.find("label", "Depth: 1.50 mm, was 2.00 mm", within=sheet)
    program.find("label", "It was tried out as it is now.", within=sheet)
    program.press("Publish version 4", within=sheet)
    program.find("label", re.compile(r"^Version 4 is published\."))
    program.keys("alt+Left")
    row = [cell.name for cell in school.in_library(program, EXERCISE)]
    desk.check("4" in row and "Published" in row, f"the library shows {row}")
    school.sign_out(program)
    return depth_row


def main():
    desk.on_own_bus()
    with desk.Desk(sys.argv[1]) as own:
        program = own.start()
        school.first_start(program)
        print(f"tried out and published; the try-out showed {visit(program)}")
        program.close()


if __name__ == "__main__":
    main()
