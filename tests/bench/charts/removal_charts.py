"""Charts of removal: depth over time through three tissues (the paper's figure 15), and the error of the drilling speed."""
import math

import style
from style import COLOURS, MARKS, QUIET, TEXT
from tables import Missing

SHOWN = ("surface", "occupancy")
LAYER_MM, BUR_MM, CLEAR_MM = 10 / 3, 0.5, 0.1  # thickness of a layer, radius of the bur, distance of a slope from a seam
TISSUES = ("dentine", "bone", "enamel")
LEAST_PERCENT = 1e-3  # smaller values stand at the frame's foot
GOALS = {"surface": 1.0, "occupancy": 5.0}  # percent; the occupancy method's along an axis


def axes_along(direction):
    """Number of axes in a direction such as "+x-y"."""
    return sum(direction.count(a) for a in "xyz")


def slope(rows, layer):
    """mm/s by least squares where the bur's front is in one tissue: NaN below two points."""
    top = layer * LAYER_MM
    points = [(r.number("time_s"), r.number("depth_mm")) for r in rows
              if top + BUR_MM + CLEAR_MM <= r.number("depth_mm") <= top + LAYER_MM - CLEAR_MM]
    if len(points) < 2:
        return math.nan
    t, d = (sum(p[i] for p in points) / len(points) for i in (0, 1))
    return sum((a - t) * (b - d) for a, b in points) / sum((a - t) ** 2 for a, _ in points)


def depth_over_time(removal):
    rows = {m: removal.where(method=m, measure="depth") for m in SHOWN}
    for method in SHOWN:
        for layer, tissue in enumerate(TISSUES):
            if math.isnan(slope(rows[method], layer)):
                raise Missing(f"removal: depth of {method} in {tissue}")
    end = max(r.number("time_s") for m in SHOWN for r in rows[m])
    fig = style.figure(
        860, 560, "Depth over time through three tissues",
        "Full push, 1 kHz, a point every 25 ms; ball bur of 0.5 mm radius, 128³ voxels in 10 mm, three layers of 3.33 mm.",
        f"{removal.source}. Solid, circles: surface proxy. Dashed, squares: occupancy proxy, the paper's method. Dotted: wanted "
        "slopes.")
    axes = style.panel(fig, 76, 96, 836, 480)
    axes.set_xlim(0, 2 * math.ceil(end / 2) + 2)
    axes.set_ylim(10, 0)
    axes.set_xlabel("seconds")
    axes.set_ylabel("depth of the bur's tip, mm")
    for layer in (1, 2):
        axes.axhline(layer * LAYER_MM, color=QUIET, lw=1, ls=(0, (3, 3)))
    for method, dash, wide, first in (("occupancy", (0, (5, 3)), 1.4, 40), ("surface", "-", 2.0, 20)):
        line = [(r.number("time_s"), r.number("depth_mm")) for r in rows[method]]
        axes.plot(*zip(*line), color=COLOURS[method], ls=dash, lw=wide)
        axes.plot(*zip(*line[first::40]), MARKS[method], ms=5, color=COLOURS[method])
    for layer, tissue in enumerate(TISSUES):
        inside = [r for r in rows["surface"] if r.text("tissue") == tissue]
        wanted = next((r.number("target_mm_s") for r in inside if r.holds("target_mm_s")), math.nan)
        if math.isnan(wanted):
            raise Missing(f"removal: wanted speed in {tissue}")
        top = layer * LAYER_MM
        begin = max(r.number("time_s") for r in rows["surface"] if r.number("depth_mm") <= top + 0.6) + 0.6
        axes.plot([begin, begin + (LAYER_MM - 0.8) / wanted], [top + 0.6, top + LAYER_MM - 0.2], color=TEXT, lw=1.3, ls=(0, (1, 2)))
        text = (f"{tissue}: wanted {wanted:g} mm/s, surface {slope(rows['surface'], layer):.4g}, "
                f"occupancy {slope(rows['occupancy'], layer):.4g}")
        # Right of its dotted line; the last one ends with the frame.
        at = (begin + 0.5 * LAYER_MM / wanted, top + 0.55 * LAYER_MM) if layer < 2 else (axes.get_xlim()[1], top + 0.14 * LAYER_MM)
        axes.annotate(text, at, (8, 5) if layer < 2 else (0, 0), textcoords="offset points", fontweight="bold", fontsize=9,
                      ha="left" if layer < 2 else "right")
    return fig


def speed_error(removal):
    rows = {m: [r for r in removal.where(method=m, measure="speed") if r.holds("error_percent")] for m in SHOWN}
    for method in SHOWN:
        if not rows[method]:
            raise Missing(f"removal: speed of {method}")
    fig = style.figure(
        860, 520, "Error of the drilling speed against voxel size, tick and direction",
        "Every pair of voxel, tick, direction, tissue, push and bur; one mark per run, read from the remaining surface.",
        f"{removal.source}.\nCircles: surface proxy, goal 1 %. Squares: occupancy proxy, goal 5 % along an axis. Hollow: radius under "
        "3 voxels.")
    panels = (("voxel, mm", lambda r: f"{r.number('voxel_mm'):.2g}"), ("tick, ms", lambda r: f"{r.number('tick_ms'):g}"),
              ("direction: number of axes", lambda r: str(axes_along(r.text("direction")))))
    for i, (title, group_of) in enumerate(panels):
        axes = style.panel(fig, 76 + 264 * i, 96, 308 + 264 * i, 440)
        groups = sorted({group_of(r) for m in SHOWN for r in rows[m]}, key=float)
        style.decades(axes.yaxis, [LEAST_PERCENT, 100])
        axes.set_xlim(0, len(groups))
        axes.set_xticks([g + 0.5 for g in range(len(groups))], groups)
        axes.set_xlabel(title)
        if i:
            axes.set_yticklabels([])
        else:
            axes.set_ylabel("error, %")
        for method in SHOWN:
            axes.axhline(GOALS[method], color=COLOURS[method], lw=1.1, ls=(0, (5, 3)))
        for method, start in (("occupancy", 0.54), ("surface", 0.08)):
            placed = dict.fromkeys(groups, 0)
            for r in rows[method]:
                g = group_of(r)
                x = groups.index(g) + start + 0.04 * (placed[g] % 10)  # side by side in ten places
                placed[g] += 1
                hollow = r.text("unresolved") == "true"
                axes.plot(x, min(100, max(LEAST_PERCENT, abs(r.number("error_percent")))), MARKS[method], ms=3.6,
                          mfc="white" if hollow else COLOURS[method], mec=COLOURS[method] if hollow else "white",
                          mew=0.9 if hollow else 0.3, clip_on=False)
    return fig
