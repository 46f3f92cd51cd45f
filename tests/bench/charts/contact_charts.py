"""Charts of contact: speed against accuracy, error against voxel size, cost against size."""
import math

import style
from style import BLUE, COLOURS, LABELS, MARKS, METHODS, QUIET, TEXT, VERMILION
from tables import Missing, mean

USUAL_VOXEL_MM = 10 / 128
SPEED_MM_S = 50.0
LEAST_ANGLE_DEG = 1e-4  # smaller values stand at the frame's foot

# Other programs, built unmodified and measured elsewhere: 2-vCPU EPYC VM, g++ 12, -O3 -march=native, one pinned core,
# 128^3 voxels in 10 mm, device point 0.3 mm below the offset surface. Speed: a slide at 50 mm/s. Angle: mean over face
# and sphere (R 4 mm) of that slide or, where none was taken, of presses.
# name, bur radius in mm, updates a second, angle on the face, angle on the sphere, angle is of presses
PEERS = (("CHAI3D 3.3.0", 0.25, 75e3, 17.8, 25.5, False), ("Kobra, Chan's proxy", 0.25, 99e3, 16.6, 11.6, True),
         ("Kobra, Agus' penalty", 0.25, 447e3, 8.8, 7.4, True), ("iMSTK, exact distance", 0.25, 306e3, 18.0, 37.0, False),
         ("CHAI3D 3.3.0", 0.5, 22e3, 15.9, 19.5, False), ("Kobra, Chan's proxy", 0.5, 95e3, 19.0, 11.0, True),
         ("Kobra, Agus' penalty", 0.5, 90e3, 0.75, 1.2, True))
PAPER_EXPLORATION, PAPER_PERFORATION = 62e3, 50e3  # the paper's desktop of 2012, Core i5, 3.1 GHz; no accuracy given


def slide(table, task, method, shape, radius, voxel, field):
    for row in table.rows:
        if (row.text("method") == method and row.text("shape") == shape and row.text("motion") == "slide"
                and row.text("task") == task and row.text("unresolved") != "true" and row.is_near("speed_mm_s", SPEED_MM_S)
                and row.is_near("bur_radius_mm", radius) and row.is_near("voxel_mm", voxel) and row.holds(field)):
            return row.number(field)
    return math.nan


def places(accuracy, rate, radius):
    """(method, voxel, updates a second, angle) of every method and voxel size that both tables hold, coarse to fine."""
    voxels = sorted({row.number("voxel_mm") for row in accuracy.rows}, reverse=True)
    out = []
    for method in METHODS:
        for voxel in voxels:
            angle = [slide(accuracy, "", method, s, radius, voxel, "angle_deg_mean") for s in ("face", "sphere")]
            speed = [slide(rate, "exploration", method, s, radius, voxel, "updates_per_s") for s in ("face", "sphere")]
            if not any(math.isnan(v) for v in angle + speed):
                out.append((method, voxel, 2 / sum(1 / v for v in speed), max(LEAST_ANGLE_DEG, sum(angle) / 2)))
    return out


CAVITY_MINUTES, CAVITY_TREMOR_MM = 2.0, 0.05  # the cavity of the first chart and table


def in_cavity(cavity, radius, **texts):
    """The surface proxy's rows in the usual cavity: slides at 5 and 50 mm/s, presses, cutting, milling."""
    return [r for r in cavity.where(method="surface", **texts)
            if r.is_near("bur_radius_mm", radius) and r.is_near("minutes", CAVITY_MINUTES) and r.is_near("tremor_mm", CAVITY_TREMOR_MM)
            and r.text("encoder_mm") in ("", "0")]


def explored(cavity, radius, speed_mm_s=SPEED_MM_S):
    """The slide at a speed in the usual cavity. Raises Missing without it."""
    found = [r for r in in_cavity(cavity, radius, motion="slide") if r.is_near("speed_mm_s", speed_mm_s)]
    if not found:
        raise Missing(f"cavity: a slide at {speed_mm_s:.0f} mm/s after {CAVITY_MINUTES:.0f} minutes with a bur of {radius} mm")
    return found[0]


def speed_against_accuracy(accuracy, rate, radius, cavity=None):
    shown = places(accuracy, rate, radius)
    if not shown:
        raise Missing(f"accuracy and rate: no slides at 50 mm/s on face and sphere with a bur of {radius} mm")
    several = len({voxel for _, voxel, *_ in shown}) > 1
    milled = explored(cavity, radius) if cavity else None
    measured = {"angles": accuracy.version, "rates": rate.version} | ({"cavity": cavity.version} if cavity else {})
    version = accuracy.version if len(set(measured.values())) == 1 else "; ".join(f"{what} {of}" for what, of in measured.items())
    sizes = "voxel size in mm beside the marks" if several else "voxels of 10/128 mm"
    fig = style.figure(
        860, 620, f"Speed against accuracy, ball bur of {radius} mm radius",
        "Clean path: slides at 50 mm/s, 0.3 mm below the offset surface; mean of face and sphere. Right is faster, down is more exact.",
        f"Filled: {accuracy.machine}, {version}; {sizes}. "
        "Dashed: Pareto front.\nHollow: other programs, measured elsewhere on a 2-vCPU EPYC VM, 10/128 mm. "
        "(pressed): angle of presses, not of a slide.")
    axes = style.panel(fig, 76, 72, 836, 528)
    peers = [(name, speed, (face + sphere) / 2, pressed) for name, r, speed, face, sphere, pressed in PEERS if r == radius]
    cut = [(milled.number("updates_per_s"), milled.number("angle_deg_mean"))] if milled else []
    style.decades(axes.xaxis, [PAPER_EXPLORATION] + [p[2] for p in shown] + [p[1] for p in peers] + [p[0] for p in cut])
    style.decades(axes.yaxis, [p[3] for p in shown] + [p[2] for p in peers] + [p[1] for p in cut])
    axes.set_xlabel("updates a second, one core")
    axes.set_ylabel("mean angle between force and exact force, degrees")
    axes.axvline(PAPER_EXPLORATION, color=QUIET, lw=1.2, ls=(0, (2, 4)))
    room = style.Room(axes)

    front = []
    for _, _, speed, angle in sorted(shown, key=lambda p: -p[2]):
        if not front or angle < front[-1][1]:
            front += ([(speed, front[-1][1])] if front else []) + [(speed, angle)]
    axes.plot(*zip(*front), color=QUIET, lw=1.4, ls=(0, (5, 3)))
    room.take_line(front)
    room.take_line([(PAPER_EXPLORATION, y) for y in axes.get_ylim()])
    for method in METHODS:
        own = [p for p in shown if p[0] == method]
        axes.plot([p[2] for p in own], [p[3] for p in own], color=COLOURS[method], lw=1.1)
        room.take_line([(p[2], p[3]) for p in own])
        for _, voxel, speed, angle in own:
            size = min(16, max(9, 8 + 40 * voxel))
            axes.plot(speed, angle, MARKS[method], ms=size * 0.75, color=COLOURS[method], clip_on=False, zorder=5)
            room.take(speed, angle, size * 0.36)
    for _, speed, angle, _ in peers:
        axes.plot(speed, angle, "o", ms=7.5, mfc="white", mec=QUIET, mew=1.5, zorder=5)
        room.take(speed, angle, 4.5)
    for speed, angle in cut:
        axes.plot(speed, angle, "s", ms=8, color=COLOURS["surface"], zorder=5)
        room.take(speed, angle, 5)
        room.label(speed, angle, f"surface proxy in a cavity, milled {CAVITY_MINUTES:.0f} min", 7, fontsize=9.8, fontweight="bold")
    for method in METHODS:
        own = [p for p in shown if p[0] == method]
        if own:
            _, _, speed, angle = min(own, key=lambda p: abs(p[1] - USUAL_VOXEL_MM))
            room.label(speed, angle, LABELS[method], 7, fontsize=9.8, fontweight="bold")
    for name, speed, angle, pressed in peers:
        room.label(speed, angle, name + (" (pressed)" if pressed else ""), 5, fontsize=9, color=QUIET)
    low, high = axes.get_ylim()
    room.label(PAPER_EXPLORATION, low * (high / low) ** 0.28, "the paper, 2012: 62 k, no accuracy given", 4, fontsize=9,
               color=QUIET)
    if several:
        for _, voxel, speed, angle in shown:
            room.label(speed, angle, f"{voxel:.2g}", 6, fontsize=8.3, color=QUIET)
    return fig


def fitted_order(series):
    """p of error = c h^p, by least squares on the logarithms. series: two (h, error) at least, all positive."""
    xs, ys = [math.log(h) for h, _ in series], [math.log(e) for _, e in series]
    x, y = sum(xs) / len(xs), sum(ys) / len(ys)
    return sum((a - x) * (b - y) for a, b in zip(xs, ys)) / sum((a - x) ** 2 for a in xs)


def errors(accuracy, shape, field):
    """(voxel, mean error) of the surface proxy over all motions with a bur of 0.5 mm, coarse to fine."""
    by_voxel = {}
    for row in accuracy.where(method="surface", shape=shape, task=""):
        if row.text("unresolved") != "true" and row.is_near("bur_radius_mm", 0.5) and row.holds(field):
            by_voxel.setdefault(row.number("voxel_mm"), []).append(row.number(field))
    return [(voxel, mean(values)) for voxel, values in sorted(by_voxel.items(), reverse=True) if sum(values) > 0]


ABOVE = 1.25  # an error that much over the face's can be distinguished from it


def order_of(series, floor):
    """The fitted order of the error beyond the face's, as a label; errors add as squares."""
    floors = dict(floor)
    form = [(h, math.sqrt(e * e - floors[h] ** 2)) for h, e in series if h in floors and e > ABOVE * floors[h]]
    if len(form) > 1:
        return f"order {fitted_order(form):.1f}"
    if not form or form[0][0] != series[0][0] or len(series) < 2 or series[1][0] not in floors:
        return "as the face"
    finer = series[1][0]
    return f"order {fitted_order([form[0], (finer, floors[finer] * math.sqrt(ABOVE**2 - 1))]):.1f} or more"


def error_against_voxel(accuracy):
    fig = style.figure(
        860, 500, "Error of the surface proxy against voxel size",
        "Ball bur of 0.5 mm radius, presses and slides. A face is exact at any voxel size: its error is the 16-bit rounding of s.",
        f"{accuracy.source}. Circles: sphere. Squares: cylinder. Diamonds: face. Order: slope of the error beyond the face's.")
    for field, title, left in (("angle_deg_mean", "mean angle error, degrees", 76), ("depth_um_mean", "mean depth error, µm", 502)):
        axes = style.panel(fig, left, 72, left + 334, 420)
        floor = errors(accuracy, "face", field)
        curves = (("face", "face", QUIET, "D"), ("sphere", "sphere, R 4 mm", BLUE, "o"),
                  ("cylinder", "cylinder, R 2 mm", VERMILION, "s"))
        series = {shape: errors(accuracy, shape, field) for shape, *_ in curves}
        for shape in ("sphere", "cylinder"):
            if len(series[shape]) < 2:
                raise Missing(f"accuracy: surface on {shape} with a bur of 0.5 mm at two voxel sizes at least")
        style.lettered(axes.xaxis, 0.034, 0.55, [0.04, 0.078, 0.1, 0.2])
        style.decades(axes.yaxis, [e for s in series.values() for _, e in s])
        axes.set_xlabel("voxel, mm")
        axes.set_ylabel(title)
        for shape, _, colour, mark in curves:
            axes.plot(*zip(*series[shape]), marker=mark, ms=6.5, color=colour, lw=1.8)
        low, high = axes.get_ylim()
        e = low * (high / low) ** 0.93
        axes.plot([0.04, 0.08, 0.08, 0.04], [e / 4, e / 4, e, e / 4], color="#AEB6BE", lw=1.3)
        axes.annotate("order 2", (0.08, e / 2), (6, 0), textcoords="offset points", color=QUIET, fontsize=9)
        style.name_ends(axes, [(*series[s][0], label, "" if s == "face" else order_of(series[s], floor), TEXT)
                               for s, label, *_ in curves])
    return fig


def cost_against_size(rate, scale):
    fig = style.figure(
        860, 446, "Cost of a tick and memory of a scene",
        "Left: face, sphere and cylinder at 50 mm/s, voxels of 10/128 mm. Middle and right: a solid block, bur of 0.5 mm radius.",
        f"{rate.machine}, rates {rate.version}; volumes {scale.version}.\nCircles: surface proxy. Squares: occupancy proxy. "
        "Middle: median over alternating blocks.")
    by_radius, by_edge, by_memory = (style.panel(fig, left, 76, left + 200, 350) for left in (70, 352, 632))
    lines = {}
    for method in ("surface", "occupancy"):
        ticks = {}
        for row in rate.where(method=method, task="exploration"):
            if (row.text("shape") != "channel" and row.is_near("voxel_mm", USUAL_VOXEL_MM)
                    and row.is_near("speed_mm_s", SPEED_MM_S) and row.holds("updates_per_s")):
                ticks.setdefault(row.number("bur_radius_mm"), []).append(1e6 / row.number("updates_per_s"))
        radius = [(r, mean(us)) for r, us in sorted(ticks.items())]
        if len(radius) < 2:
            raise Missing(f"rate: exploration of {method} with two burs at least")
        volumes = sorted((round(row.number("volume_voxels") ** (1 / 3)), row.number("cost_to_smallest"), row.number("memory_mb"))
                         for row in scale.where(method=method, variant="whole-top"))
        if len(volumes) < 2:
            raise Missing(f"scale: {method} at two sizes at least")
        lines[method] = (radius, [(n, c) for n, c, _ in volumes], [(n, mb) for n, _, mb in volumes])
    style.lettered(by_radius.xaxis, 0.2, 3.8, [0.25, 0.5, 1.15, 3.0])
    style.decades(by_radius.yaxis, [us for radius, *_ in lines.values() for _, us in radius])
    by_radius.set_xlabel("bur radius, mm")
    by_radius.set_ylabel("µs a tick")
    for axes in (by_edge, by_memory):
        style.lettered(axes.xaxis, 105, 3300, [128, 256, 512, 1024])
        axes.set_xlabel("voxels along an edge")
    most = max(1.5, 1.1 * max(c for _, volume, _ in lines.values() for _, c in volume))
    by_edge.set_ylim(0, math.ceil(2 * most) / 2)
    by_edge.set_ylabel("cost of a tick, 128³ = 1")
    for bound in (0.8, 1.2):
        by_edge.axhline(bound, color=QUIET, lw=1, ls=(0, (3, 3)))
    by_edge.annotate("± 20 %", (128, 1.2), (0, 5), textcoords="offset points", color=QUIET, fontsize=9)
    style.decades(by_memory.yaxis, [mb for *_, memory in lines.values() for _, mb in memory])
    by_memory.set_ylabel("MB")
    for method, series in lines.items():
        for axes, line in zip((by_radius, by_edge, by_memory), series):
            axes.plot(*zip(*line), marker=MARKS[method], ms=6.5, color=COLOURS[method], lw=1.8, clip_on=False)
        by_radius.annotate(method, series[0][-1], (-8, 10), textcoords="offset points", fontweight="bold", ha="right")
    for axes, at, text in ((by_edge, 1, lambda v: f"{100 * (v - 1):+.0f} %"), (by_memory, 2, lambda v: f"{v:.0f} MB")):
        style.name_ends(axes, [(*s[at][-1], method, text(s[at][-1][1]), TEXT) for method, s in lines.items()])
    return fig
