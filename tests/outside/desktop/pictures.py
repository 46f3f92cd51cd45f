"""Pictures of every page, the drilling screen and the dialogs of the real program, as a student, an instructor and an
administrator see them, and one contact sheet per look. In German it prints the texts that show untranslated.

    /usr/bin/python3 tests/outside/desktop/pictures.py build/release/cusp FOLDER [light|dark-german|large|double ...]

Without a look it takes all: FOLDER/LOOK/NN-name.png and FOLDER/LOOK.png. A look takes some ten minutes.
"""
import os
import re
import subprocess
import sys
import time
from dataclasses import dataclass

import assessment
import cohort
import desk
import instructor
import school
import student
from PIL import Image, ImageChops, ImageGrab

TITLE_BAR = 21  # px, of a window that fills the screen
CLASS_2 = "Class II MO, adhesive, tooth 46"
STILL_S = 0.6  # between two pictures that are the same: nothing is drawn in the background
TABS = ("Shape", "Points", "Burs", "Tissues", "Texts", "Audit")
ACROSS = 3  # pictures in a row of a contact sheet
CUBE_MM = 12


@dataclass
class Look:
    theme: str
    language: str
    width: int
    height: int
    scale: int = 1  # QT_SCALE_FACTOR


LOOKS = {
    "light": Look("light", "en", 1280, 800),
    "dark-german": Look("dark", "de", 1280, 800),
    "large": Look("dark", "en", 1920, 1080),
    "double": Look("light", "de", 1920, 1080, 2),
}


class Album:
    def __init__(self, own, folder):
        self.own, self.folder, self.number = own, folder, 0

    def take(self, program, name, at_most_s=6.0, rests_s=0.0):
        """The window with what stands before it, once nothing moves or after `at_most_s`. `rests_s`: for what draws seldom."""
        time.sleep(rests_s)
        end = time.monotonic() + at_most_s
        before, picture = None, self._grab()
        while time.monotonic() < end and (before is None or ImageChops.difference(before, picture).getbbox()):
            time.sleep(STILL_S)
            before, picture = picture, self._grab()
        self.number += 1
        path = os.path.join(self.folder, f"{self.number:02}-{name}.png")
        picture.save(path)
        print(path, flush=True)
        for text in untranslated(program):
            print(f"  untranslated on {name}: {text!r}", flush=True)

    def _grab(self):
        whole = ImageGrab.grab(xdisplay=self.own.screen.display).convert("RGB")
        return whole.crop((0, TITLE_BAR, *whole.size))

    def sheet(self):
        """All pictures, each at two thirds of 1280 px."""
        names = sorted(n for n in os.listdir(self.folder) if n.endswith(".png"))
        pictures = [Image.open(os.path.join(self.folder, n)).convert("RGB") for n in names]
        width = 853
        height = round(pictures[0].height * width / pictures[0].width)
        out = Image.new("RGB", (ACROSS * width, -(-len(pictures) // ACROSS) * height))
        for i, picture in enumerate(pictures):
            out.paste(picture.resize((width, height), Image.Resampling.LANCZOS), (i % ACROSS * width, i // ACROSS * height))
        out.save(self.folder + ".png")


def fill_screen(program, look):
    """A window that is smaller than the screen grows to it; a larger one fills it at its start."""
    size = (look.width // look.scale, look.height // look.scale)

    def filled():
        if program.find("frame", "Cusp").extents()[2:] == size:
            return True
        # None is found before the window manager shows it.
        found = subprocess.run(["xdotool", "search", "--onlyvisible", "--pid", str(program.process.pid), "--name", "^Cusp$"],
                               capture_output=True, text=True).stdout.split()
        if found:
            program.screen.x("windowmove", found[0], 0, 0, "windowsize", found[0], look.width, look.height)
        return False
    desk.until("the window to fill the screen", filled, 30)


def untranslated(program):
    """Texts of the source that the catalogue has and the screen shows all the same."""
    words = program.words
    sources = getattr(words, "sources", {})
    return sorted({w.shown for w in program.all() if w.shown in sources and w.shown not in words.exact})


def escape(program, dialog):
    """Leaves a dialog; a key that comes before it is gone would go to it."""
    program.keys("Escape")
    program.gone("dialog", dialog)


def opened(program):
    desk.until("the tooth to be ready", lambda: program.find("push button", "Finish").has("ENABLED"))


def of_drilling(album, program):
    """The coach, cutting, the cutaway, the mirror, paused, and the question at the end."""
    program.find("label", "Coach")
    album.take(program, "coach-begin")
    school.drill(program, 0.4)
    x, y = program.find(None, "Tooth").middle()
    program.screen.x("mousemove", x + 30 * program.pixels, y, "mousedown", 1)
    album.take(program, "cutting", 4)
    program.screen.x("mouseup", 1)
    program.keys("3")
    album.take(program, "cutaway", 3)
    program.keys("2")
    album.take(program, "mirror", 3, rests_s=3)
    program.keys("2", "p")
    album.take(program, "paused", 3)
    program.keys("p")
    program.press("Finish")
    question = program.find("alert")
    album.take(program, "question", 3)
    program.press("Finish", within=question)
    program.find(None, "Report")


def of_report(album, program):
    album.take(program, "report", rests_s=8)
    school.row_of(program, "Criteria", "Target removed")[0].click()
    album.take(program, "report-place")
    program.press("Section", school.CHOICE)
    album.take(program, "report-section", rests_s=4)
    program.press("Section", school.CHOICE)
    program.press("Before and after", school.CHOICE)
    album.take(program, "report-before-after", rests_s=4)
    program.press("Save as PDF")
    program.find(re.compile("dialog|file chooser"), "Save the report")
    album.take(program, "file-picker")
    program.keys("Escape")


def of_student(album, program):
    school.sign_in_student(program)
    album.take(program, "start", rests_s=6)
    school.page(program, "Exercises")
    album.take(program, "exercises", rests_s=15)  # their pictures are drawn one by one
    school.brief(program, CLASS_2)
    album.take(program, "briefing", rests_s=8)
    program.press("Start")
    opened(program)
    album.take(program, "class-2")
    program.press("Leave")  # nothing was cut: it asks nothing
    school.home(program)
    school.begin(program, student.EXERCISE)
    of_drilling(album, program)
    of_report(album, program)
    school.home(program)
    for page in ("Start", "My results", "Device", "Help"):
        school.page(program, page)
        album.take(program, page.lower().replace(" ", "-"))
    program.keys("ctrl+k")
    program.find("dialog", "Go to")
    album.take(program, "go-to")
    escape(program, "Go to")
    school.sign_out(program)


def of_editor(album, program):
    program.find("text", "Find an exercise").type(CLASS_2)
    program.keys("Return")
    program.find(None, "Editor")
    desk.until("the tooth to be grown", lambda: program.find("push button", "Try out").has("ENABLED"), 120)
    for tab in TABS:
        program.press(tab, "page tab")
        album.take(program, "editor-" + tab.lower())
    program.press("Section", school.CHOICE)
    album.take(program, "editor-section")
    program.keys("alt+Left")
    school.page(program, "Library")


def of_publishing(album, program):
    school.in_library(program, instructor.EXERCISE)[0].click()
    program.press("Open in the editor")
    editor = program.find(None, "Editor")
    program.find("spin button", "Depth", within=editor).focus()
    program.keys("Up", "Return")
    publish = program.find("push button", re.compile("^Publish version"), within=editor)
    desk.until("the checks to pass", lambda: publish.has("ENABLED"))
    album.take(program, "editor-changed")
    publish.press()
    program.find("dialog", "Publish")
    album.take(program, "publish-sheet")
    escape(program, "Publish")
    program.keys("alt+Left")
    school.page(program, "Library")


def cube(path, side_mm=CUBE_MM):
    """A closed mesh, as text STL."""
    corners = [[(i >> axis & 1) * side_mm for axis in range(3)] for i in range(8)]
    with open(path, "w", encoding="utf-8") as f:
        f.write("solid cube\n")
        for a, b, c, d in ((0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)):
            for three in ((a, b, c), (a, c, d)):
                f.write("facet normal 0 0 0\nouter loop\n")
                f.writelines("vertex {} {} {}\n".format(*corners[i]) for i in three)
                f.write("endloop\nendfacet\n")
        f.write("endsolid cube\n")


def of_import(album, program):
    program.press("Import a specimen")
    album.take(program, "import")
    path = os.path.join(program.folder, "cube.stl")
    cube(path)
    program.press("Choose a file…")
    cohort.pick(program, "Choose a file", path)
    program.find("label", re.compile("^The specimen will be|^With this unit"))
    album.take(program, "import-mesh")
    program.keys("alt+Left")
    program.press("Leave", within=program.find("alert"))


def of_instructor(album, program):
    school.sign_in_staff(program, *school.INSTRUCTOR[1:])
    for page in ("Performance", "Library"):
        school.page(program, page)
        album.take(program, page.lower() + "-instructor")
    program.menu_to_dialog("New exercise", "Down", "Down", "Return")
    program.find("dialog", "New exercise from a template")
    album.take(program, "template", 12)
    escape(program, "New exercise from a template")
    of_editor(album, program)
    of_publishing(album, program)
    of_import(album, program)
    school.sign_out(program)


def of_audit_log(album, program):
    school.page(program, "Audit log")
    program.press("Verify now")
    program.find("label", re.compile("The log is whole"))
    album.take(program, "audit-log")


def of_administrator(album, program):
    school.sign_in_staff(program, *school.ADMINISTRATOR[1:])
    for page in ("People", "Performance", "Station", "Other stations"):
        school.page(program, page)
        album.take(program, page.lower().replace(" ", "-"))
    of_audit_log(album, program)
    program.menu_to_dialog(school.ACCOUNT, "Down", "Down", "Return")
    album.take(program, "password")
    program.keys("Escape")
    school.sign_out(program)
    cohort.import_list(program, album.take)
    cohort.assign(program)
    school.sign_in_staff(program, *school.INSTRUCTOR[1:])
    school.page(program, "Cohorts")
    album.take(program, "cohorts")
    school.sign_out(program)


def desk_of(binary, look):
    """A desk whose programs have the look."""
    own = desk.Desk(binary, look.width, look.height + TITLE_BAR)
    folder = os.path.join(own.folder, "config", "Cusp")
    os.makedirs(folder, exist_ok=True)
    with open(os.path.join(folder, "Cusp.ini"), "w", encoding="utf-8") as f:
        f.write(f"[look]\ntheme={look.theme}\nlanguage={look.language}\nscale=100\n")
    own.language, own.pixels = look.language, look.scale
    own.environment = {"QT_SCALE_FACTOR": look.scale}
    return own


def walk(binary, folder, look):
    os.makedirs(folder, exist_ok=True)
    with desk_of(binary, look) as own:
        album = Album(own, folder)
        program = own.start()
        fill_screen(program, look)
        album.take(program, "first-start")
        school.first_start(program, album.take)
        album.take(program, "sign-in", rests_s=10)  # its tooth is drawn in the background
        of_student(album, program)
        of_instructor(album, program)
        of_administrator(album, program)
        program, _ = assessment.visit(own, program, album.take)
        program.close()
        album.sheet()


def main():
    desk.on_own_bus()
    for name in sys.argv[3:] or LOOKS:
        walk(sys.argv[1], os.path.join(os.path.abspath(sys.argv[2]), name), LOOKS[name])


if __name__ == "__main__":
    main()
