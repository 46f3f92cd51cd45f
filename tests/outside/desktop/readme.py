"""The pictures of the README of the project, from the real program: 1280 x 800 px, into FOLDER.

    /usr/bin/python3 tests/outside/desktop/readme.py build/release/cusp ui/pictures
"""
import os
import subprocess
import sys

import desk
import pictures
import quick_start
import school
from PIL import Image

VIEWS = ("drilling", "mirror")  # of few colours: without they are three times as large
PLAYED = ("class-1-36", "Class I, tooth 36")  # key and title
SHOWN_PLACE = "Over-cut within tolerance, floor"
ZOOM_OUT = 7  # notches of the wheel, so that the mirror and the neighbours are seen
ASIDE_PX = (115, 70)  # from the view's middle: the bur stands beside the target there


def play(own):
    """An attempt of the student by the competent operator."""
    number, pin = school.STUDENT[1:]
    subprocess.run([own.binary, "play", PLAYED[0], "--script", "competent", "--db", own.database, "--as", number, "--out", os.path.join(own.folder, "played")],
                   check=True, stdout=subprocess.DEVNULL, env=dict(os.environ, CUSP_PASSWORD=pin))


def of_drilling(album, program):
    school.page(program, "Exercises")
    album.take(program, "exercises", rests_s=15)  # their pictures are drawn one by one
    school.begin(program, pictures.CLASS_2)
    album.take(program, "drilling", rests_s=2)
    x, y = program.find(None, "Tooth").middle()
    program.screen.x("mousemove", x, y)
    for _ in range(ZOOM_OUT):
        program.screen.x("keydown", "ctrl", "click", 5, "keyup", "ctrl", "sleep", 0.1)
    program.screen.x("mousemove", x + ASIDE_PX[0], y + ASIDE_PX[1], "sleep", 2)
    program.keys("2")
    album.take(program, "mirror", rests_s=12)  # at rest it is drawn finer
    program.press("Leave")  # nothing was cut: it asks nothing
    school.home(program)


def of_report(album, program):
    school.page(program, "My results")
    school.row_of(program, "My results", PLAYED[1])[0].click()
    program.keys("Return")
    program.find(None, "Report")
    school.row_of(program, "Criteria", SHOWN_PLACE)[0].click()
    album.take(program, "report", rests_s=8)  # its tooth is drawn in the background
    program.press("As drilled", school.CHOICE)
    program.press("Section", school.CHOICE)
    album.take(program, "section", rests_s=8)
    school.home(program)


def of_editor(album, program):
    school.page(program, "Library")
    program.find("text", "Find an exercise").type(pictures.CLASS_2)
    program.keys("Return")
    program.find(None, "Editor")
    desk.until("the tooth to be grown", lambda: program.find("push button", "Try out").has("ENABLED"), 120)
    album.take(program, "editor", rests_s=2)


def main():
    desk.on_own_bus()
    folder = os.path.abspath(sys.argv[2])
    with pictures.desk_of(sys.argv[1], pictures.LOOKS["light"]) as own:
        whole = os.path.join(own.folder, "whole")
        os.makedirs(whole)
        program = own.start()
        pictures.fill_screen(program, pictures.LOOKS["light"])
        school.first_start(program)
        play(own)
        album = quick_start.Shown(own, whole)
        school.sign_in_student(program)
        of_drilling(album, program)
        of_report(album, program)
        school.sign_out(program)
        school.sign_in_staff(program, *school.INSTRUCTOR[1:])
        of_editor(album, program)
        program.close()
        for file in os.listdir(whole):
            name = file[3:-4]
            picture = Image.open(os.path.join(whole, file)).convert("RGB")
            shown = quick_start.of_few_colours(picture) if name in VIEWS else picture
            shown.save(os.path.join(folder, name + ".png"), optimize=True)


if __name__ == "__main__":
    main()
