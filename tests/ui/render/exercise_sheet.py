#!/usr/bin/env python3
"""Draws the exercises of the library as one sheet, scenarios/library/exercises.png.

  exercise_sheet.py --program build/release/cusp-exercise-pictures [--keep FOLDER] [--out FILE] [KEY ...]

Each exercise (all without KEY): the target on the tooth, what the reference operator and the novice leave, from above and in a
mesiodistal section, with title and points. Half a minute of a processor for a tooth, two at once. --keep leaves the single pictures,
and a buccolingual section besides, in FOLDER; what lies there is not drawn again. Needs Pillow.
"""
import argparse
import json
import os
import pathlib
import subprocess
import tempfile
from concurrent.futures import ThreadPoolExecutor

from PIL import Image, ImageDraw, ImageFont

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[2]
SIDE, GAP, HEAD, COLUMNS, AIR = 230, 4, 22, 2, 0.15
STATES = ("target", "reference", "novice")
PAPER, TEXT, QUIET, GOOD, BAD = "#FFFFFF", "#1B1F24", "#5B646D", "#1A7F4B", "#B3261E"
FONTS = ("/usr/share/fonts/truetype/noto/NotoSans-Regular.ttf", "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf")


def font(size):
    for file in FONTS:
        if pathlib.Path(file).exists():
            return ImageFont.truetype(file, size)
    return ImageFont.load_default()


def drawn(program, key, folder):
    own = folder / key
    if not (own / "exercise.json").exists():
        subprocess.run([str(program), key, str(own)], check=True)
        print(key, flush=True)
    return own


def tile(file, from_top=0.0):
    """A picture as a square, moved up by this share of it: a section has air above the crown."""
    picture = Image.open(file).convert("RGBA")
    picture = picture.transform(picture.size, Image.Transform.AFFINE, (1, 0, 0, 0, 1, from_top * picture.height))
    under = Image.new("RGBA", picture.size, "#E9ECEF")
    under.alpha_composite(picture)
    return under.convert("RGB").resize((SIDE, SIDE), Image.LANCZOS)


def captions(facts):
    """[(text, colour)] above the six pictures."""
    level = facts.get("level", "")
    time = f"{facts['expected_time_s'] / 60:.0f} min" if facts["expected_time_s"] else ""
    out = [(f"{facts['title']} · {level}, {time}", TEXT)]
    for state in STATES[1:]:
        grade = facts[state]
        result = "passed" if grade["passed"] else "failed"
        out.append((f"{state}, bur {grade['bur']}: {grade['score']:.0f} points, {result}", GOOD if grade["passed"] else BAD))
    return out


def strip(own):
    """One exercise: three states, each from above and in section."""
    out = Image.new("RGB", (6 * (SIDE + GAP), SIDE + HEAD + GAP), PAPER)
    pen = ImageDraw.Draw(out)
    for i, (state, (text, colour)) in enumerate(zip(STATES, captions(json.loads((own / "exercise.json").read_text())))):
        left = 2 * i * (SIDE + GAP)
        pen.text((left, 3), text, fill=colour, font=font(13))
        out.paste(tile(own / f"{state}.png"), (left, HEAD))
        out.paste(tile(own / f"{state}-md.png", AIR), (left + SIDE + GAP, HEAD))
    return out


def sheet(folders):
    strips = [strip(own) for own in folders]
    wide, high = strips[0].size
    rows = (len(strips) + COLUMNS - 1) // COLUMNS
    out = Image.new("RGB", (COLUMNS * (wide + 4 * GAP) + 4 * GAP, rows * (high + 2 * GAP) + HEAD + 4 * GAP), PAPER)
    ImageDraw.Draw(out).text((4 * GAP, GAP), "Exercises: target, reference operator, novice; from above and in mesiodistal section. "
                             "Line: target; dashed: tolerance zone.", fill=QUIET, font=font(14))
    for i, one in enumerate(strips):
        column, row = divmod(i, rows)
        out.paste(one, (4 * GAP + column * (wide + 4 * GAP), HEAD + 2 * GAP + row * (high + 2 * GAP)))
    return out.quantize(128, dither=Image.Dither.NONE)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("keys", nargs="*", metavar="KEY")
    parser.add_argument("--program", type=pathlib.Path, required=True)
    parser.add_argument("--keep", type=pathlib.Path, metavar="FOLDER")
    parser.add_argument("--out", type=pathlib.Path, metavar="FILE", default=ROOT / "scenarios" / "library" / "exercises.png")
    o = parser.parse_args()
    program = o.program.resolve()
    keys = o.keys or subprocess.run([str(program.parent / "cusp-library-text")], check=True, capture_output=True, text=True).stdout.split()
    folder = o.keep or pathlib.Path(tempfile.mkdtemp(prefix="cusp-exercises-"))
    with ThreadPoolExecutor(max_workers=min(2, os.cpu_count() or 1)) as pool:
        folders = list(pool.map(lambda key: drawn(program, key, folder), keys))
    sheet(folders).save(o.out, optimize=True)
    print(f"{o.out}: {o.out.stat().st_size / 1e6:.2f} MB")


if __name__ == "__main__":
    main()
