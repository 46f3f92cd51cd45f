"""Pictures of every screen of the real program, as a student, an instructor and an administrator see it. English.

    /usr/bin/python3 tests/outside/desktop/pictures.py build/release/cusp FOLDER [light|dark] [percent of size]
"""
import os
import re
import sys
import time

import assessment
import cohort
import desk
import school
import student
from PIL import Image, ImageGrab

WIDTH, HEIGHT = 1280, 821  # of the screen: a window that fills it has 800 below its title bar
CLASS_2 = "Class II MO, adhesive, tooth 46"


class Album:
    def __init__(self, own, folder):
        self.own, self.folder, self.number = own, folder, 0

    def take(self, program, name, rests_s=1.0):
        """The window alone. `rests_s`: until what it draws in the background stands."""
        time.sleep(rests_s)
        x, y, width, height = program.find("frame", "Cusp").box()
        whole = ImageGrab.grab(xdisplay=self.own.screen.display)
        self.number += 1
        path = os.path.join(self.folder, f"{self.number:02}-{name}.png")
        whole.crop((x, y, x + width, y + height)).save(path)
        print(path, flush=True)

    def sheet(self):
        """All pictures, four in a row."""
        names = sorted(n for n in os.listdir(self.folder) if n.endswith(".png") and n[0].isdigit())
        pictures = [Image.open(os.path.join(self.folder, n)).convert("RGB").resize((480, 300)) for n in names]
        out = Image.new("RGB", (4 * 480, (len(pictures) + 3) // 4 * 300))
        for i, picture in enumerate(pictures):
            out.paste(picture, (i % 4 * 480, i // 4 * 300))
        out.save(os.path.join(self.folder, "sheet.png"))


def of_student(album, program):
    school.sign_in_student(program)
    album.take(program, "start", 4)
    school.page(program, "Exercises")
    album.take(program, "exercises", 40)  # their pictures are drawn one by one
    school.brief(program, CLASS_2)
    album.take(program, "briefing", 3)
    program.press("Start")
    desk.until("the tooth to be ready", lambda: program.find("push button", "Finish").has("ENABLED"))
    album.take(program, "class-2", 3)
    program.press("Leave")  # nothing was cut: it asks nothing
    school.home(program)
    school.begin(program, student.EXERCISE)
    school.drill(program, 0.4)
    album.take(program, "drilling", 0.2)
    program.keys("3")
    album.take(program, "cutaway", 2)
    program.keys("2")
    album.take(program, "mirror", 2)
    program.keys("2")
    program.keys("p")
    album.take(program, "paused")
    program.keys("p")
    school.finish(program)
    album.take(program, "report", 4)
    school.home(program)
    for page in ("My results", "Device", "Help"):
        school.page(program, page)
        album.take(program, page.lower().replace(" ", "-"))
    school.sign_out(program)


def of_instructor(album, program):
    school.sign_in_staff(program, *school.INSTRUCTOR[1:])
    school.page(program, "Library")
    album.take(program, "library")
    program.find("text", "Find an exercise").type(CLASS_2)
    program.keys("Return")
    program.find(None, "Editor")
    desk.until("the tooth to be grown", lambda: program.find("push button", "Try out").has("ENABLED"), 120)
    for tab in ("Shape", "Points", "Burs", "Tissues", "Texts", "Audit"):
        program.press(tab, "page tab")
        album.take(program, "editor-" + tab.lower(), 2)
    program.keys("alt+Left")
    school.page(program, "Library")
    program.press("Import a specimen")
    album.take(program, "import")
    program.keys("alt+Left")
    school.sign_out(program)


def of_audit_log(album, program):
    school.page(program, "Audit log")
    program.press("Verify now")
    program.find("label", re.compile("The log is whole"))
    album.take(program, "audit-log")
    # Nobody of this school assigns anything before this page.
    program.find("combo box", "All kinds").choose("Cohorts and assignments")
    program.find("label", "No entry fits")
    album.take(program, "audit-log-empty")


def of_administrator(album, program):
    school.sign_in_staff(program, *school.ADMINISTRATOR[1:])
    for page in ("People", "Performance", "Station", "Other stations"):
        school.page(program, page)
        album.take(program, page.lower().replace(" ", "-"))
    of_audit_log(album, program)
    school.page(program, "People")
    program.press("Import a list")
    album.take(program, "import-people")
    program.keys("alt+Left")
    school.sign_out(program)
    cohort.import_list(program)
    cohort.assign(program)
    school.sign_in_staff(program, *school.INSTRUCTOR[1:])
    school.page(program, "Cohorts")
    album.take(program, "cohorts")
    school.sign_out(program)


def use_look(own, theme, percent):
    look = os.path.join(own.folder, "config", "Cusp")
    os.makedirs(look, exist_ok=True)
    with open(os.path.join(look, "Cusp.ini"), "w", encoding="utf-8") as f:
        f.write(f"[look]\ntheme={theme}\nlanguage=en\nscale={percent}\n")


def main():
    desk.on_own_bus()
    folder = os.path.abspath(sys.argv[2])
    theme = sys.argv[3] if len(sys.argv) > 3 else "light"
    percent = sys.argv[4] if len(sys.argv) > 4 else "100"
    os.makedirs(folder, exist_ok=True)
    with desk.Desk(sys.argv[1], WIDTH, HEIGHT) as own:
        use_look(own, theme, percent)
        album = Album(own, folder)
        program = own.start()
        album.take(program, "first-start", 2)
        school.first_start(program)
        album.take(program, "sign-in", 3)
        of_student(album, program)
        of_instructor(album, program)
        of_administrator(album, program)
        program, _ = assessment.visit(own, program, album.take)
        program.close()
        album.sheet()


if __name__ == "__main__":
    main()
