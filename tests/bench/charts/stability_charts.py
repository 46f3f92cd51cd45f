"""Charts of stability: the failures of each method, and the largest stable stiffness by damping and by cell."""
import math

import style
from matplotlib.lines import Line2D
from matplotlib.patches import Rectangle
from style import BLUE, COLOURS, GREEN, LABELS, MARKS, METHODS, QUIET, TEXT, VERMILION
from tables import Missing

# The cases of tests/bench/stability_cases.h, in its order, with their labels.
PRESSED = (("face", "face"), ("edge", "edge"), ("corner", "corner"), ("groove", "60° groove"), ("pit", "fitting pit"),
           ("channel", "own channel"))
MOTIONS = (("thin-wall", "thin wall, 1 m/s"), ("tissues", "enamel to dentine"), ("vanishing", "tissue removed"),
        ("islands", "islets on necks"), ("fragment", "fragment detached"), ("narrow-slot", "slot too narrow"),
        ("start-inside", "starts inside"), ("volume-edge", "edge of the volume"), ("voxel-size", "voxels 0.2 to 0.04"),
        ("late-ticks", "ticks up to 50 ms late"), ("grip-weight", "weight of the grip"))
FAULTS = (("frozen", "frozen"), ("jump", "jump of 20 mm"), ("nan", "not a number"), ("infinite", "infinite"),
          ("out-of-range", "out of range"), ("device-gone", "device unplugged"), ("specimen-exchange", "specimen exchanged"),
          ("bur-exchange", "bur exchanged"))
# The failures of tests/bench/verdict.h, most harmful first.
FAILURES = {"through": "falls through", "overlap": "overlaps tissue by more than a voxel", "stuck": "stuck for 50 ms",
            "kicks": "force step over 50 mN", "rings": "limit cycle", "feeds": "feeds energy to the hand", "stays-on": "force stays on"}
# The device of the laboratory, in the hand that holds it (tests/bench/stability.cpp, usual_setting).
USUAL = {"device": "m0.1-b2", "grip": "soft", "friction_n": "0", "delay_ms": "1"}
# k_max over the exact proxy's. Lightness falls to both sides, so that the chart reads in grey.
STEPS = ((0.5, "#D55E00", "white", "under 0.5"), (0.85, "#F3B27A", TEXT, "0.5 to 0.85"), (1.15, "#EEF1F4", TEXT, "as the exact proxy"),
         (1.75, "#8FC1E3", TEXT, "1.15 to 1.75"), (math.inf, "#0072B2", "white", "over 1.75"))
FAILED, FINE, SIGN, NOTHING = "#FBE3D2", "#F7F8FA", "#8A3B00", "#AEB6BE"
SEARCH_END_N_PER_MM = 10.29  # end of the grid of stability_kmax.h


def sign(axes, kind, x, y, h, colour):
    """Draws a failure's sign within a square of 2 h about a place. y points down."""
    def stroke(points, wide=1.3, dash="-"):
        axes.add_line(Line2D(*zip(*points), color=colour, lw=wide, ls=dash, solid_capstyle="round"))

    turn = [2 * math.pi * i / 16 for i in range(17)]
    if kind == "through":  # an arrow down through a wall
        stroke([(x - h, y), (x + h, y)], 1.0, (0, (1.6, 1.2)))
        stroke([(x, y - h), (x, y + h)])
        stroke([(x - 0.55 * h, y + 0.4 * h), (x, y + h), (x + 0.55 * h, y + 0.4 * h)])
    elif kind == "overlap":  # a ball sunk into a wall
        stroke([(x + 0.75 * h * math.cos(a), y + 0.75 * h * math.sin(a)) for a in turn])
        stroke([(x - h, y), (x + h, y)], 1.0)
    elif kind == "stuck":  # a cross
        stroke([(x - 0.75 * h, y - 0.75 * h), (x + 0.75 * h, y + 0.75 * h)])
        stroke([(x - 0.75 * h, y + 0.75 * h), (x + 0.75 * h, y - 0.75 * h)])
    elif kind == "kicks":  # lightning
        stroke([(x + 0.35 * h, y - h), (x - 0.45 * h, y + 0.15 * h), (x + 0.4 * h, y - 0.1 * h), (x - 0.35 * h, y + h)])
    elif kind == "rings":  # a wave
        stroke([(x - h + 2 * h * i / 16, y - 0.7 * h * math.sin(2 * turn[i])) for i in range(17)], 1.2)
    elif kind == "feeds":  # an arrow back at the hand
        stroke([(x, y + h), (x, y - h)])
        stroke([(x - 0.55 * h, y - 0.4 * h), (x, y - h), (x + 0.55 * h, y - 0.4 * h)])
        stroke([(x - 0.8 * h, y + h), (x + 0.8 * h, y + h)])
    elif kind == "stays-on":  # two bars
        for side in (-0.45, 0.45):
            stroke([(x + side * h, y - 0.8 * h), (x + side * h, y + 0.8 * h)], 1.8)
    else:
        axes.plot(x, y, "o", ms=3, color=NOTHING, mew=0)


def is_usual(row):
    return all(row.text(name) == value for name, value in USUAL.items())


def cell(stability, case, pressed, method, guard):
    """(least k_max over the exact proxy's or NaN, stable to the search's end, failures) of one cell of the map."""
    rows = [row for row in stability.where(method=method, case=case, guard=guard)
            if row.text("unresolved") != "true" and (not pressed or is_usual(row))]
    if not rows:
        raise Missing(f"stability: {method}, guard {guard}, in case {case}")
    failed = {b for row in rows for b in row.text("failures").split()}
    unknown = failed - set(FAILURES)
    if unknown:
        raise Missing(f"stability: no such failure: {', '.join(sorted(unknown))}")
    ratio, beyond = math.nan, False
    if pressed:
        least = min(rows, key=lambda r: r.number("k_max_n_per_mm") / r.number("k_exact_n_per_mm"))
        ratio = least.number("k_max_n_per_mm") / least.number("k_exact_n_per_mm")
        beyond = least.number("k_max_n_per_mm") >= SEARCH_END_N_PER_MM
    return ratio, beyond, [b for b in FAILURES if b in failed]


def draw_cell(axes, what, pressed, left, top, wide, high):
    ratio, beyond, broke = what
    x, y = left + wide / 2, top + high / 2
    if pressed:
        # A method that leaves the exact proxy is stable elsewhere: its stiffness does not count.
        _, fill, ink, _ = next(s for s in STEPS if ratio < s[0])
        if broke and broke[0] == "through":
            fill, ink = FAILED, SIGN
        text = f"{ratio:.1g}" if ratio < 0.0995 else f"{ratio:.2g}" if ratio < 9.95 else f"{ratio:.0f}"
        axes.add_patch(Rectangle((left, top), wide, high, color=fill, lw=0))
        axes.text(x, top + (8.5 if broke else high / 2), text + ("+" if beyond else ""), color=ink, ha="center", va="center",
                  fontsize=7.6 if broke else 8.4)
        for i, b in enumerate(broke):
            sign(axes, b, x + 10 * (i - (len(broke) - 1) / 2), top + high - 7, 3.6 if len(broke) > 2 else 4.2, ink)
        return
    axes.add_patch(Rectangle((left, top), wide, high, color=FAILED if broke else FINE, lw=0))
    if not broke:
        sign(axes, "", x, y, 0, "")
    abreast = 1 if len(broke) <= 1 else 2 if len(broke) <= 4 else 3
    rows = math.ceil(len(broke) / abreast)
    half = {1: 6.0, 2: 5.0}.get(len(broke), 4.5 if len(broke) <= 4 else 3.5)
    step = 12.5 if abreast <= 2 else 9.0
    for i, b in enumerate(broke):
        row = i // abreast
        in_row = min(abreast, len(broke) - row * abreast)
        sign(axes, b, x + step * (i % abreast - (in_row - 1) / 2), y + 12.5 * (row - (rows - 1) / 2), half, SIGN)


def legend(axes, left, top, right):
    axes.text(left, top, "largest stable stiffness", fontweight="bold", va="center")
    x = left + 170
    for _, fill, _, text in STEPS:
        axes.add_patch(Rectangle((x, top - 8), 22, 16, fc=fill, ec=style.GRID))
        axes.text(x + 28, top, text, va="center")
        x += 50 + 6.3 * len(text)
    top += 32
    axes.text(left, top, "failure", fontweight="bold", va="center")
    x = left + 92
    for kind, text in (*FAILURES.items(), ("", "nothing")):
        wide = 40 + 6.3 * len(text)
        if x + wide > right:
            x, top = left + 92, top + 24
        sign(axes, kind, x + 8, top, 6, SIGN)
        axes.text(x + 20, top, text, va="center")
        x += wide


def stability_map(stability):
    known = {row.text("case") for row in stability.rows}
    groups = [(text, [c for c in cases if c[0] in known], pressed) for text, cases, pressed in
              (("pressed, k_max", PRESSED, True), ("in motion, at 1 N/mm", MOTIONS, False), ("faults and exchanges", FAULTS, False))]
    if not all(cases for _, cases, _ in groups):
        raise Missing("stability: cases")
    left, top, size, gap, between = 182, 212, 28, 12, 7
    right = left + size * sum(len(c) for _, c, _ in groups) + gap * 2
    bottom = top + 12 * size + 5 * between
    wide, high = right + 20, bottom + 128
    fig = style.figure(
        wide, high, "Failures of each method by case",
        "Colour and number: largest stable stiffness relative to the exact proxy with the same device and hand. Signs: failures.",
        f"{stability.source}.\n0.1 kg, 2 N s/m, loop delay 1 ms; grips none, soft, firm, and scripted motion. +: stable up to 10.3 N/mm, "
        "where the search ends.")
    axes = fig.add_axes([0, 0, 1, 1])
    axes.set_axis_off()
    axes.set_xlim(0, wide)
    axes.set_ylim(high, 0)
    axes.text(left - 6, top - 10, "guard", color=QUIET, ha="right", fontsize=8.4)
    x = left
    for text, cases, pressed in groups:
        axes.text(x, 76, text, fontweight="bold")
        axes.plot([x, x + size * len(cases) - 2], [82, 82], color=QUIET, lw=0.8)
        for key, label in cases:
            axes.text(x + size / 2, top - 6, label, rotation=90, ha="center", va="bottom", fontsize=8.8)
            y = top
            for method in METHODS:
                for guard in ("on", "off"):
                    draw_cell(axes, cell(stability, key, pressed, method, guard), pressed, x + 0.75, y + 0.75, size - 1.5, size - 1.5)
                    y += size
                y += between
            x += size
        x += gap
    y = top
    for method in METHODS:
        name, _, rest = LABELS[method].replace(", ", " (").partition(" (")
        axes.plot(22, y + size, MARKS[method], ms=8, color=COLOURS[method])
        axes.text(34, y + size - (7 if rest else 0), name, fontweight="bold", va="center")
        axes.text(34, y + size + 9, rest.rstrip(")"), color=QUIET, va="center", fontsize=8.8)
        for i, guard in enumerate(("on", "off")):
            axes.text(left - 6, y + size * (i + 0.5), guard, color=QUIET, ha="right", va="center", fontsize=8.4)
        y += 2 * size + between
    legend(axes, 22, bottom + 18, right)
    return fig


ENCODER_STEP_MM = 0.049  # the Falcon's, about (engine/lab, falcon_like)
TICK_S = 1e-3


def colgate_n_per_mm(damping_ns_per_m):
    """Colgate and Schenkel 1997: a sampled device renders a passive wall below K = 2 b / T."""
    return 2 * damping_ns_per_m / TICK_S / 1000


def abbott_okamura_n_per_mm(damping_ns_per_m, friction_n):
    """Abbott and Okamura 2005: with an encoder, below min(2 b / T, 2 f / encoder step)."""
    return min(colgate_n_per_mm(damping_ns_per_m), 2 * friction_n / ENCODER_STEP_MM)


def stiffness_against_damping(stability):
    apart = max(abs(row.number("k_max_n_per_mm") / row.number("k_exact_n_per_mm") - 1)
                for row in damping_rows(stability) if row.number("k_exact_n_per_mm") > 0)
    fig = style.figure(
        860, 500, "Largest stable stiffness against the device's damping",
        "Surface proxy on a face, guard off, no delay, 0.1 kg. Dashed and dotted: published passivity bounds; Colgate's has no encoder.",
        f"{stability.source}.\nEncoder step {ENCODER_STEP_MM:.3g} mm, 1 kHz. Squares: firm grip. Circles: soft. Triangles: no "
        f"grip. The exact proxy is within {100 * apart:.0f} %.")
    low, high, floor, roof = 0.3, 24.0, 0.5, 20.0
    damping = [low * (high / low) ** (i / 60) for i in range(61)]
    for friction, left, text in ((0.0, 76, "without friction"), (0.1, 492, "friction 0.1 N")):
        axes = style.panel(fig, left, 96, left + 344, 420)
        style.lettered(axes.xaxis, low, high, [0.5, 2, 5])
        style.lettered(axes.yaxis, floor, roof, [0.5, 1, 2, 5, 10, 20])
        axes.set_xlabel("device damping, N s/m")
        axes.set_ylabel("" if friction else "stiffness, N/mm")
        axes.set_title(text, loc="left", fontsize=9.8, fontweight="bold", color=TEXT)
        axes.plot(damping, [colgate_n_per_mm(b) for b in damping], color=TEXT, lw=1.4, ls=(0, (6, 3)))
        axes.annotate("Colgate", (0.85, colgate_n_per_mm(0.85)), (-12, 4), textcoords="offset points", ha="right")
        if friction:
            axes.plot(damping, [abbott_okamura_n_per_mm(b, friction) for b in damping], color=TEXT, lw=1.4, ls=(0, (1, 2)))
            axes.annotate("Abbott and Okamura", (high, abbott_okamura_n_per_mm(high, friction)), (-6, -16), textcoords="offset points",
                          ha="right")
        else:
            axes.annotate("Abbott and Okamura: bound is 0", (1, 0), (-10, 26), xycoords="axes fraction",
                          textcoords="offset points", ha="right", color=QUIET, fontsize=9)
        ends = []
        for grip, label, colour, mark in (("firm", "firm grip", BLUE, "s"), ("soft", "soft grip", GREEN, "o"), ("none", "no grip", VERMILION, "^")):
            found = sorted((r.number("damping_n_s_m"), r.number("k_max_n_per_mm")) for r in damping_rows(stability)
                           if r.text("grip") == grip and r.number("friction_n") == friction)
            if len(found) < 2:
                raise Missing(f"stability: surface on face, guard off, grip {grip}, friction {friction} N, without delay, at two "
                              "dampings at least")
            line = [p for p in found if p[1] >= floor]
            axes.plot(*zip(*line), marker=mark, ms=7.5, color=colour, lw=1.8)
            for b, k in found:
                if k < floor:  # no stiffness is stable
                    axes.annotate("none stable", (b, floor), (9, 6), textcoords="offset points", color=QUIET, fontsize=9)
                    axes.plot(b, floor * 1.06, "v", ms=7, color=colour)
            ends.append((*line[-1], label, "", TEXT))
        style.name_ends(axes, ends, gap=12)
    return fig


def damping_rows(stability):
    rows = [r for r in stability.where(method="surface", case="face", guard="off")
            if r.number("delay_ms") == 0 and r.is_near("mass_kg", 0.1)]
    if not rows:
        raise Missing("stability: surface on face, guard off, without delay")
    return rows


WITHIN = 0.15  # of the exact proxy's k_max


def stiffness_by_cell(full):
    panels, settled, beyond, beyond_first, count = [], 0, 0, 0, 0
    for key, label in PRESSED:
        rows = [r for r in full.where(method="surface", case=key, guard="off") if r.number("k_exact_n_per_mm") > 0]
        if not rows:
            raise Missing(f"stability --full: surface, guard off, {key}")
        cells = []
        for r in rows:
            share, more = r.number("k_max_n_per_mm") / r.number("k_exact_n_per_mm"), r.holds("k_sets") and r.number("k_sets") > 1
            first = r.number("k_first_n_per_mm") / r.number("k_exact_first_n_per_mm") if more and r.number("k_exact_first_n_per_mm") > 0 else share
            settled, beyond, beyond_first = settled + more, beyond + (abs(share - 1) > WITHIN), beyond_first + (abs(first - 1) > WITHIN)
            cells.append((r.number("k_exact_n_per_mm"), share, more))
        panels.append((label, cells))
        count += len(cells)
    fig = style.figure(
        860, 640, "Largest stable stiffness relative to the exact proxy, every cell",
        f"Guard off. {count} cells: devices of 0.1 and 0.25 kg and 0.5 to 5 N s/m, three grips, friction, delay. Beyond 15 %: {beyond}.",
        f"{full.source}. Hollow: {settled} cells by the median of five sets of five seeds; by the first set {beyond_first} are "
        "beyond 15 %.")
    for i, (label, cells) in enumerate(panels):
        left, top = 76 + 258 * (i % 3), 344 if i >= 3 else 104
        axes = style.panel(fig, left, top, left + 244, top + 200)
        style.lettered(axes.xaxis, 0.04, 13, [0.1, 1, 10])
        axes.set_ylim(0.8, 1.2)
        axes.set_yticks([0.85, 1, 1.15])
        if i % 3:
            axes.set_yticklabels([])
        else:
            axes.set_ylabel("surface proxy over exact")
        if i < 3:
            axes.set_xticklabels([])
        else:
            axes.set_xlabel("exact proxy, N/mm")
        shares = [s for _, s, _ in cells]
        axes.set_title(f"{label}: {len(cells)} cells, {min(shares):.2f} to {max(shares):.2f}", loc="left", fontsize=9.4, fontweight="bold",
                       color=TEXT)
        for goal in (1 - WITHIN, 1 + WITHIN):
            axes.axhline(goal, color=VERMILION, lw=1.1, ls=(0, (5, 3)))
        for k, share, more in cells:
            axes.plot(k, min(1.2, max(0.8, share)), "o", ms=4.2, mew=1 if more else 0.4, mfc="white" if more else BLUE,
                      mec=BLUE if more else "white")
    return fig
