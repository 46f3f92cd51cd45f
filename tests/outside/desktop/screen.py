"""A display for a program under test, and waiting for what it shows: `LIMIT_S` only sets when to give up."""
import os
import subprocess
import sys
import time

from PIL import ImageGrab

MARGIN = 8  # px beside the bar of pages, where a page has nothing
LIMIT_S = float(os.environ.get("CUSP_DESK_LIMIT_S", "180"))


class Missing(Exception):
    """The screen did not show what was waited for."""


def until(what, look, limit_s=None):
    """Asks `look` until it returns something true, and returns that."""
    end = time.monotonic() + (limit_s or LIMIT_S)
    pause = 0.02
    while True:
        try:
            found = look()
        except (Atspi_Error(), Missing):  # a widget went away while it was read
            found = None
        if found:
            return found
        if time.monotonic() > end:
            raise Missing(f"{what} did not come within {limit_s or LIMIT_S:.0f} s")
        time.sleep(pause)
        pause = min(pause * 1.5, 0.25)


def reveal(widget):
    """Scrolls the page by the wheel, over its empty margin, until the widget stands in the window."""
    program = widget.program
    pages = program.here(None, "Pages")
    _, y, _, height = program.find("frame", "Cusp").box()
    if pages is None or y <= widget.middle()[1] < y + height:
        return
    left, _, bar, _ = pages.box()
    program.screen.x("mousemove", left + bar + MARGIN * program.pixels, y + height // 2)

    def shown():
        at = widget.middle()[1]
        if y + height // 8 <= at < y + height * 7 // 8:
            return True
        program.screen.x("click", 5 if at > y + height // 2 else 4)
        return False
    until(f"{widget.name!r} to be scrolled into the window", shown)


def Atspi_Error():
    from gi.repository import GLib
    return GLib.Error


class Screen:
    """An X server with a window manager; large enough for a window of 1280x800 and its frame. Keys do not repeat (-r): on a busy
    machine a letter would stand there several times."""

    def __init__(self, folder, width=1300, height=840):
        self.folder = folder
        read, write = os.pipe()
        self.server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(write), "-screen", "0", f"{width}x{height}x24", "-nolisten", "tcp", "+extension", "GLX", "-r"],
            pass_fds=[write], stdout=subprocess.DEVNULL, stderr=open(os.path.join(folder, "xvfb.log"), "w"))
        os.close(write)
        with os.fdopen(read) as pipe:
            number = pipe.readline().strip()
        if not number:
            raise Missing("no display: Xvfb did not start")
        self.display = ":" + number
        os.environ["DISPLAY"] = self.display
        self.manager = None

        def managed():
            if self.manager is None or self.manager.poll() is not None:
                self.manager = subprocess.Popen(["openbox"], stdout=subprocess.DEVNULL,
                                                stderr=open(os.path.join(folder, "openbox.log"), "a"))
            # Only a window manager knows how many desktops there are.
            return subprocess.run(["xdotool", "get_num_desktops"], capture_output=True).returncode == 0
        try:
            until("the window manager", managed)
        except Missing as missing:
            self.close()
            with open(os.path.join(folder, "openbox.log"), encoding="utf-8") as f:
                raise Missing(f"{missing}: {f.read()}") from None

    def picture(self, path):
        """Of the whole screen; none if the server is gone."""
        try:
            ImageGrab.grab(xdisplay=self.display).save(path)
        except OSError as error:
            print(f"no picture: {error}", file=sys.stderr)
        return path

    def x(self, *arguments):
        subprocess.run(["xdotool", *[str(a) for a in arguments]], check=True, stdout=subprocess.DEVNULL)

    def close(self):
        for child in (self.manager, self.server):
            child.terminate()
            child.wait()
