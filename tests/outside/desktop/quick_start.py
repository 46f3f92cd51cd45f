"""The five pictures of the quick start, from the real program in each theme and language: 640 x 400 px, few colours, into
FOLDER/THEME-LANGUAGE of the folder that the window's resources are made of.

    /usr/bin/python3 tests/outside/desktop/quick_start.py build/release/cusp ui/app/quick_start
"""
import os
import socket
import sys

import cohort
import desk
import pictures
import school
from PIL import Image, ImageDraw

LOOKS = [pictures.Look(theme, language, 1280, 800) for theme in ("light", "dark") for language in ("en", "de")]
SIZE = (640, 400)
COLOURS = 256
EXERCISE = "Class I, tooth 36"
HELD_MM = 1.5  # depth of the cut, within the target
STEP_S = 0.3  # that the bur sinks before the depth is held again
SWAY_PX = (*range(0, 24, 4), *range(24, -24, -4), *range(-24, 1, 4))  # from the middle to both sides, at that depth


def hide(program, path, *texts):
    """Labels that name this machine say nothing to others: the ground takes their place."""
    picture = Image.open(path).convert("RGB")
    draw = ImageDraw.Draw(picture)
    left, top = 0, pictures.TITLE_BAR
    for label in program.all("label"):
        if any(text in label.name for text in texts):
            x, y, width, height = label.box()
            draw.rectangle((x - left, y - top, x - left + width - 1, y - top + height - 1), picture.getpixel((x - left, y - top)))
    picture.save(path)


class Shown(pictures.Album):
    def take(self, program, name, at_most_s=6.0, rests_s=0.0):
        super().take(program, name, at_most_s, rests_s)
        hide(program, os.path.join(self.folder, f"{self.number:02}-{name}.png"), self.own.folder, socket.gethostname())


def of_few_colours(picture):
    # The median cut loses the few pixels of the target's line; the dither keeps the view's ground smooth.
    palette = picture.quantize(COLOURS, method=Image.Quantize.MAXCOVERAGE)
    return picture.quantize(palette=palette, dither=Image.Dither.FLOYDSTEINBERG)


def small(folder, name, path):
    picture = Image.open(path).convert("RGB").resize(SIZE, Image.Resampling.LANCZOS)
    of_few_colours(picture).save(os.path.join(folder, name + ".png"), optimize=True)


def drill(program):
    """Sinks step by step to HELD_MM and moves about at that depth: a slow machine holds the button longer, and cuts no deeper. The button
    stays down, so that depth and push stand in the picture."""
    depth, hold = program.find("dial", "Depth"), program.find(school.CHOICE, "Hold depth")
    x, y = program.find(None, "Tooth").middle()

    def deep_enough():
        school.resume_if_held(program)
        if not hold.has("CHECKED"):  # at first, and where the attempt stood when the key came
            hold.press()
        elif depth.value >= HELD_MM:
            return True
        else:
            program.screen.x("key", "h", "sleep", STEP_S, "key", "h")
        return False
    program.screen.x("mousemove", x, y, "mousedown", 1)
    desk.until(f"the bur to be {HELD_MM} mm deep", deep_enough)
    for aside in SWAY_PX:
        program.screen.x("mousemove", x + aside, y, "sleep", 0.05)
        school.resume_if_held(program)


def visit(album, program):
    """The screens in the order of the page."""
    cohort.import_list(program)
    school.sign_in_staff(program, *school.ADMINISTRATOR[1:])
    school.page(program, "People")
    album.take(program, "people")
    school.sign_out(program)
    cohort.assign(program)
    school.sign_in_staff(program, *school.INSTRUCTOR[1:])
    school.page(program, "Cohorts")
    album.take(program, "assign")
    school.sign_out(program)
    school.sign_in_student(program, *cohort.LENA)
    school.begin(program, EXERCISE)
    drill(program)
    album.take(program, "drill", 3)
    program.screen.x("mouseup", 1)
    school.finish(program)
    album.take(program, "report", rests_s=8)  # its tooth is drawn in the background
    school.home(program)
    school.sign_out(program)
    school.sign_in_staff(program, *school.ADMINISTRATOR[1:])
    school.page(program, "Station")
    program.press("Back up now")
    program.find("label", desk.re.compile("The backup is made"))
    album.take(program, "backup")


def draw(binary, look, target):
    with pictures.desk_of(binary, look) as own:
        large = os.path.join(own.folder, "large")
        os.makedirs(large)
        program = own.start()
        pictures.fill_screen(program, look)
        school.first_start(program)
        visit(Shown(own, large), program)
        program.close()
        os.makedirs(target, exist_ok=True)
        for name in os.listdir(large):
            small(target, name[3:-4], os.path.join(large, name))


def main():
    desk.on_own_bus()
    for look in LOOKS:
        draw(sys.argv[1], look, os.path.join(os.path.abspath(sys.argv[2]), f"{look.theme}-{look.language}"))


if __name__ == "__main__":
    main()
