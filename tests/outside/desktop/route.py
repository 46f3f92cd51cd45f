"""An instructor makes a class II on 36 from the template, tries it out by the reference operator, publishes and withdraws it; a
student drills it in between. The way from the library to the graded try-out takes at most MOST_ACTIONS actions.

    /usr/bin/python3 tests/outside/desktop/route.py build/release/cusp
"""
import re
import sys

import desk
import exchange
import school

CLASS_2_ENTRY = 4  # of the menu of beginnings, counted from 1 ("Empty")
EXERCISE = "Class II MO, adhesive, tooth 36"
MOST_ACTIONS = 10  # clicks, drags and typed fields
WEIGHT = "Points for Target removed"
BANDS = "Floor depth, mean"
GROWS_S = 240  # a molar between its neighbours


class Author:
    """One instructor's hand: each click, drag and typed field counts one."""

    def __init__(self, program):
        self.program, self.done = program, []

    def click(self, name, role="push button", within=None):
        self.program.find(role, name, within).click()
        self.done.append(f"click {getattr(name, 'pattern', name)!r}")

    def entry(self, button, number):
        """Two clicks: the button, and the entry of its menu. The entry is chosen by keys, for an open menu is not searched."""
        self.program.menu_to_dialog(button, *["Down"] * number, "Return")
        self.done += [f"click {button!r}", f"click entry {number}"]

    def drag(self, widget, by_x, by_y):
        x, y = widget.middle()
        pointer = self.program.screen.x
        pointer("mousemove", x, y, "mousedown", 1)
        for step in range(1, 5):
            pointer("mousemove", x + by_x * step // 4, y + by_y * step // 4)
        pointer("mouseup", 1)
        self.done.append(f"drag {widget.name!r}")

    def type(self, widget, text):
        widget.click()
        self.program.keys("ctrl+a")
        self.program.screen.x("type", "--delay", 8, text)
        self.program.keys("Return")
        self.done.append(f"type {widget.name!r}")


def shape_the_target(author, editor):
    """Drags a point of the outline; its description says where it lies."""
    point = author.program.find("slider", "Point 1", within=editor)
    before = point.description
    author.drag(point, 10, 4)
    desk.until("the point to lie elsewhere", lambda: point.description != before)
    return before, point.description


def change_the_rubric(author, editor):
    """Another weight, taken back and made again."""
    program = author.program
    author.click("Points", "page tab")
    weight = program.find("spin button", WEIGHT, within=editor)
    before = weight.value
    wanted = before + 5
    author.type(weight, f"{wanted:.0f}")
    desk.until("the weight to be taken", lambda: weight.value == wanted)
    author.click("Undo", within=editor)
    desk.until("the weight to be as before", lambda: weight.value == before)
    author.click("Redo", within=editor)
    desk.until("the weight to be changed again", lambda: weight.value == wanted)
    return f"{before:.0f} to {wanted:.0f}"


def author_it(author, album):
    """From the library to the report of the reference operator."""
    program = author.program
    author.entry("New exercise", CLASS_2_ENTRY)
    dialog = program.find("dialog", "New exercise from a template")
    program.find("label", "These values make an exercise on tooth 36.", within=dialog)
    album(program, "template")
    author.click("Make the exercise", within=dialog)
    editor = program.find(None, "Editor")
    # A handle is dragged as soon as the tooth is there to drag it on.
    reference = program.find("push button", "Try out by the reference operator", within=editor)
    desk.until("the tooth to be grown", lambda: reference.has("ENABLED"), GROWS_S)
    album(program, "editor")
    moved = shape_the_target(author, editor)
    weight = change_the_rubric(author, editor)
    album(program, "points")
    author.click("Try out by the reference operator", within=editor)
    program.find(None, "Report", limit_s=GROWS_S)
    points, verdict = school.points_on_report(program)
    desk.check(verdict == "Passed", f"the reference operator should pass, the report shows {points} points, {verdict}")
    desk.check(any("Reference operator" in text for text in program.texts()), "the report does not say who cut")
    album(program, "reference")
    desk.check(len(author.done) <= MOST_ACTIONS, f"{len(author.done)} actions: {author.done}")
    return {"moved": moved, "weight": weight, "points": points}


def drag_a_band(author, album):
    """The operators' values mark the bands; an edge is dragged, its number follows, and one undo takes the drag back."""
    program = author.program
    program.keys("alt+Left")
    editor = program.find(None, "Editor")
    program.press(f"Bands of {BANDS}", "check box", within=editor)
    program.find("label", re.compile("^Reference operator: "), within=editor)
    desk.check(program.here("label", re.compile("^Novice operator: "), editor) is None, "a mark stands for what nobody measured")
    program.press("Measure the operators", within=editor)
    program.find("label", re.compile("^Novice operator: "), within=editor, limit_s=GROWS_S)
    album(program, "bands")
    number = program.find("spin button", f"{BANDS}: Full to", within=editor)
    before = number.value
    author.drag(program.find("slider", f"{BANDS}: Full to", within=editor), 10, 0)
    desk.until("the number to follow the edge", lambda: number.value > before)
    dragged = number.value
    program.press("Undo", within=editor)
    desk.until("the drag to be taken back", lambda: number.value == before)
    return before, dragged


def publish(program):
    editor = program.find(None, "Editor")
    desk.until("the checks to pass", lambda: program.find("push button", "Publish version 1", editor).has("ENABLED"))
    program.press("Publish version 1", within=editor)
    sheet = program.find("dialog", "Publish")
    program.find("label", "It was tried out as it is now.", within=sheet)
    program.press("Publish version 1", within=sheet)
    program.find("label", re.compile(r"^Version 1 is published\."))
    program.press("Library", within=editor)
    exchange.choose(program, EXERCISE, "Published")
    school.sign_out(program)


def drill(program, album):
    """The student's little cut; returns the points on the report."""
    school.sign_in_student(program)
    school.brief(program, EXERCISE)
    program.press("Start")
    desk.until("the tooth to be ready", lambda: program.find("push button", "Finish").has("ENABLED"), GROWS_S)
    school.drill(program, least_mm3=0.2)
    album(program, "drilled")
    school.finish(program)
    points, verdict = school.points_on_report(program)
    desk.check(verdict == "Not passed", f"0.2 mm3 of a cavity should not pass, the report shows {verdict}")
    album(program, "student")
    school.home(program)
    school.sign_out(program)
    return points


def visit(program, album=lambda program, name: None):
    school.sign_in_staff(program, *school.INSTRUCTOR[1:])
    school.page(program, "Library")
    album(program, "library")
    author = Author(program)
    made = author_it(author, album)
    actions = list(author.done)
    made["band"] = drag_a_band(author, album)
    publish(program)
    student = drill(program, album)
    school.sign_in_staff(program, *school.INSTRUCTOR[1:])
    school.page(program, "Library")
    exchange.choose(program, EXERCISE, "Published")
    exchange.withdraw(program, 1, "Students no longer find this exercise")
    school.in_library(program, EXERCISE, "Withdrawn")
    album(program, "withdrawn")
    school.sign_out(program)
    return actions, made, student


def main():
    desk.on_own_bus()
    with desk.Desk(sys.argv[1]) as own:
        program = own.start()
        school.first_start(program)
        actions, made, student = visit(program)
        print(f"{len(actions)} actions from the library to the graded try-out: {'; '.join(actions)}")
        print(f"the reference operator has {made['points']} points, the student {student}; a band's edge went {made['band']}")
        program.close()


if __name__ == "__main__":
    main()
