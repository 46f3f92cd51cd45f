"""The tables of the READMEs, each with the machine, engine version and commit that measured it."""
import math

from contact_charts import CAVITY_MINUTES, CAVITY_TREMOR_MM, SPEED_MM_S, USUAL_VOXEL_MM, explored, in_cavity
from removal_charts import axes_along
from stability_charts import is_usual
from style import LABELS, METHODS, short
from tables import Missing, mean, needed

SLOW_MM_S = 5.0  # of a probing hand


def small(value):
    return "0" if value == 0 else "< 0.0001" if value < 1e-4 else f"{value:.2g}" if value < 100 else f"{value:.0f}"


def lines(head, rows):
    return "".join(f"| {' | '.join(cells)} |\n" for cells in [head, *rows]).replace("\n", "\n|" + "---|" * len(head) + "\n", 1)


def cavity_rows(cavity):
    """What the surface proxy does in a cavity that a trembling hand has milled, by the radius of the exploring ball."""
    def pair(row, *fields):
        values = [needed(row.number(f), f"cavity: {f} with a bur of {row.text('bur_radius_mm')} mm") for f in fields]
        return " · ".join(small(v) for v in values)

    rows = []
    for radius in (0.25, 0.4, 0.5):
        slid = explored(cavity, radius)
        milled = in_cavity(cavity, radius, task="mill")
        rows.append([f"{radius:.2g} mm", pair(slid, "angle_deg_mean", "angle_deg_p95", "angle_deg_p99"), pair(slid, "pose_um_mean", "pose_um_p95"),
                     pair(slid, "depth_um_mean"), pair(slid, "force_step_excess_mn_p99", "force_step_excess_mn_max"),
                     pair(explored(cavity, radius, SLOW_MM_S), "tick_us_p50", "tick_us_p999"), pair(slid, "tick_us_p50", "tick_us_p999"),
                     pair(milled[0], "tick_us_mean", "tick_us_p999") if milled else "–"])
    return rows


def in_a_cavity(cavity):
    head = ["surface proxy in a milled cavity, ball bur r", "angle error mean · p95 · p99, degrees", "pose error mean · p95, µm", "mean depth error, µm",
            "force step beyond the exact one p99 · most, mN", "exploring tick at 5 mm/s p50 · p99.9, µs", "the same at 50 mm/s",
            "milling tick mean · p99.9, µs"]
    return "\n" + lines(head, cavity_rows(cavity)) + (
        f"\n{cavity.source}: a ball of 0.4 mm mills 4.8 × 1.9 × 1.8 mm for {CAVITY_MINUTES:.0f} minutes at 5 mm/s with a tremor of {CAVITY_TREMOR_MM} mm "
        "at 8 to 12 Hz; balls explore it, at 50 mm/s unless said, beside the exact proxy in the union of its path; times are thread CPU time of ticks "
        "that follow each other at once.\n")


def methods(accuracy, rate, cavity=None):
    rows = []
    for method in METHODS:
        cells = [[] for _ in range(5)]
        for radius in (0.25, 0.5):
            def usual(table):
                return [r for r in table.where(method=method) if r.is_near("bur_radius_mm", radius) and r.is_near("voxel_mm", USUAL_VOXEL_MM)]

            explored = [r for r in usual(rate) if r.text("task") == "exploration" and r.text("shape") != "channel"
                        and r.is_near("speed_mm_s", SPEED_MM_S)]
            drilled = [r for r in usual(rate) if r.text("task") == "perforation"]
            slid = [r for r in usual(accuracy) if not r.text("task") and r.text("motion") == "slide" and r.is_near("speed_mm_s", SPEED_MM_S)
                    and r.text("shape") in ("face", "sphere")]

            def figure(found, value, what):
                return needed(mean([value(r) for r in found]), f"{what}: {method} with a bur of {radius} mm")

            tick = figure(explored, lambda r: 1 / r.number("updates_per_s"), "rate")
            ratio = figure(explored, lambda r: r.number("ratio_to_occupancy"), "rate")
            angle = figure(slid, lambda r: r.number("angle_deg_mean"), "accuracy")
            depth = figure(slid, lambda r: r.number("depth_um_mean"), "accuracy")
            drill = figure(drilled, lambda r: 1 / r.number("updates_per_s"), "rate")
            for cell, text in zip(cells, (short(1 / tick), f"{ratio:.2g}×", small(angle), small(depth), short(1 / drill))):
                cell.append(text)
        rows.append([LABELS[method], *(" · ".join(cell) for cell in cells)])
    head = ["clean path, ball bur r 0.25 · 0.5 mm", "exploring, updates/s", "over occupancy", "mean angle error, degrees",
            "mean depth error, µm", "drilling, updates/s"]
    return lines(head, rows) + (
        f"\n{accuracy.machine}, one core; accuracy {accuracy.version}; rate {rate.version}: voxels of 10/128 mm, "
        "0.3 mm below the offset surface at 50 mm/s; rates are means over face, sphere and cylinder, errors over face and sphere; "
        "drilling at 1 mm/s, all updates of the volume included.\n") + (in_a_cavity(cavity) if cavity else "")


def milling(full):
    """A cutting tick with every bur of the catalogue, from rows of `rate --task mill --full`."""
    def tick(row):
        fields = ("tick_us_mean", "tick_us_p999", "tick_us_p9999")
        return " · ".join(small(needed(row.number(f), f"milling: {f} of {row.text('bur')}")) for f in fields)

    least = min(r.number("minutes") for r in full.rows)
    rows = []
    for row in full.rows:
        name = row.text("bur").replace("_", " ") + (f", {row.number('minutes'):g} min" if row.number("minutes") > least else "")
        rows.append([name, row.text("axis"), tick(row), small(row.number("work_us_max")), f"{row.number('deferred_percent'):.2g}"])
    return lines(["bur", "axis", "tick mean · p99.9 · p99.99, µs", "most counted work, µs", "ticks deferred, %"], rows) + (
        f"\n{full.source}: each bur mills for {least:g} minutes at 5 mm/s with a tremor of {CAVITY_TREMOR_MM} mm, on a thin neck of 0.1 mm, its axis fixed or jittering by "
        "0.1 degrees; thread CPU time. Counted work: of the search for the proxy, by the line that fits the row's ticks best.\n")


AS_IT_STANDS = "as it stands"  # ablation/ablate.py
CHANGED = 0.1  # beyond the spread of the tree as it stands
LEAST = {"deg": 0.005, "um": 0.02, "us": 0.3, "%": 0.01}  # a smaller difference is none, by a quantity's unit
UNITS = {"deg": "°", "um": "µm", "us": "µs"}
MOST_SHOWN = 4


def changes(rows, known):
    """(factor, text) of each quantity that a mechanism's rows hold beyond what is known of the tree as it stands; worse ones are above 1."""
    found = []
    for row in rows:
        name, value = row.text("quantity"), row.number("value")
        if name not in known:
            found.append((math.inf, f"{name.removeprefix('fails: ')} fails"))
            continue
        low, high = min(known[name]), max(known[name])
        least = LEAST.get(name.rsplit(", ", 1)[-1], 1.0)
        if low * (1 - CHANGED) <= value <= high * (1 + CHANGED) or min(abs(value - low), abs(value - high)) < least:
            continue
        stands = high if value > high else low
        what, _, unit = name.rpartition(", ")
        written = f" {UNITS.get(unit, unit)}" if what else ""
        found.append((value / stands if stands > 0 else math.inf, f"{what or name} {small(stands)} → {small(value)}{written}"))
    return found


def ablation(table):
    """What each mechanism of contact and removal changes when it is off, from the rows of ablation/ablate.py."""
    known = {}
    for row in table.where(mechanism=AS_IT_STANDS):
        known.setdefault(row.text("quantity"), []).append(row.number("value"))
    if not known:
        raise Missing("ablation: the tree as it stands")
    shown = {}
    for row in table.rows:
        if row.text("mechanism") != AS_IT_STANDS:
            shown.setdefault((row.text("part"), row.text("mechanism")), []).append(row)
    rows = []
    for (part, name), of in shown.items():
        found = sorted(changes(of, known), key=lambda one: abs(math.log(one[0])) if one[0] > 0 else math.inf, reverse=True)
        worse, better = [text for factor, text in found if factor > 1], [text for factor, text in found if factor < 1]
        rows.append([part, name, *("; ".join(some[:MOST_SHOWN]) + (f"; {len(some) - MOST_SHOWN} more" if len(some) > MOST_SHOWN else "") or "–"
                                   for some in (worse, better))])
    times = max(len(v) for v in known.values())
    return lines(["part", "mechanism", "worse without it", "better without it"], rows) + (
        f"\n{table.source}: each mechanism alone is off, by an edit of ablation/mechanisms.py. Of short runs on one core: balls of 0.25 and 0.5 mm explore what "
        f"0.4 mm has milled, clean shapes, cuts and channels with 0.5 mm, burs 57, 35, 368-023 and 862-012 on shapes and in their slots (means over the rows), 4 and 57 mill, balls widen holes with their own necks; else the worst row. "
        f"Shown: what lies {100 * CHANGED:.0f} % beyond {times} measurements of the tree as it stands. Runs are short: one event can decide the mean of a worst row. "
        "Where that is little, the tests of ablation/ablate.py ran too: a test that fails is named.\n")


def stability(table):
    rows = []
    for method in METHODS:
        found = [r for r in table.where(method=method, guard="on")
                 if r.text("unresolved") != "true" and (not r.holds("k_max_n_per_mm") or is_usual(r))]
        ratios = [r.number("k_max_n_per_mm") / r.number("k_exact_n_per_mm") for r in found if r.holds("k_max_n_per_mm")]
        walls = [r for r in found if r.text("case") == "thin-wall"]
        if not ratios or not walls:
            raise Missing(f"stability: {method}, guard on")

        def most(value):
            return max((v for v in map(value, found) if not math.isnan(v)), default=0.0)

        stuck = sum(int(r.number("stuck")) for r in found if r.holds("stuck"))
        cases = {}
        for r in found:
            cases[r.text("case")] = cases.get(r.text("case"), True) and not r.text("failures")
        rows.append([
            LABELS[method], f"{min(ratios):.2g}× to {max(ratios):.2g}×",
            f"{sum(int(r.number('passed_through')) for r in walls)} of {sum(int(r.number('runs')) for r in walls)}",
            f"{stuck} times" if stuck > 1 else "once" if stuck else "never",
            f"{small(most(lambda r: r.number('force_step_p99_mn')))} · {small(most(lambda r: r.number('force_step_mn')))}",
            small(most(lambda r: r.number("energy_mj") - r.number("energy_exact_mj"))), small(most(lambda r: r.number("vibration_mn"))),
            f"{sum(cases.values())} of {len(cases)}"])
    head = ["guard on", "largest stable stiffness over the exact proxy's", "fell through a 0.2 mm wall", "stuck for 50 ms", "force step p99 · most, mN",
            "energy fed beyond the exact proxy, mJ", "vibration in the paper's tasks, mN", "cases without failure"]
    return lines(head, rows) + (f"\n{table.source}: device of 0.1 kg and 2 N s/m (assumed), loop delay 1 ms; the worst over every case, grip and voxel "
                                "size.\n")


def worst(rows, field):
    """The largest absolute value of a field; NaN if no row holds it."""
    return max((abs(r.number(field)) for r in rows if r.holds(field)), default=math.nan)


def resolved(table, measure, method="surface"):
    return [r for r in table.where(measure=measure, method=method) if r.text("unresolved") != "true"] if table else []


def removal(table, full=None):
    """The table of removal. full: rows of `removal --full`, each below the row that it extends; None without them."""
    def percent(value):
        return f"{value:.2g} %"

    def um(value):
        return f"{value:.2g} µm"

    def us(value):
        return f"{value:.0f} µs"

    occupancy = resolved(table, "speed", "occupancy")
    along = worst([r for r in table.where(measure="speed", method="occupancy")
                   if axes_along(r.text("direction")) <= 1 and r.is_near("tick_ms", 1) and r.is_near("alpha", 1)], "error_percent")
    of_occupancy = percent(worst(occupancy, "error_percent"))
    if not math.isnan(along):
        of_occupancy += "; along the axes at 1 ms and full push " + percent(along)
    ridges = [r.number("ridge_um") for r in resolved(table, "ridge") if r.holds("ridge_um")]
    shaped = {r.text("bur") for r in table.where(measure="shape")}
    # quantity, goal, value of the surface proxy, its format, the occupancy method's value
    wanted = [
        ("drilling speed, every pair of voxel, tick, direction, tissue, push and bur", "1 %", worst(resolved(table, "speed"), "error_percent"), percent, of_occupancy),
        (f"all {len(full.where(measure='speed', method='surface')) if full else 0} of the 1.0 mm round bur at 0.1 mm", "1 %", worst(resolved(full, "speed"), "error_percent"), percent, "–"),
        ("half in one tissue, half in another: against the harmonic mean", "2 %", worst(resolved(table, "mixed"), "error_percent"), percent, "–"),
        ("the same path in halves, or in other ticks: volume", "0.1 %", worst(resolved(table, "order"), "error_percent"), percent, "–"),
        ("volume of one stroke, with every shape of bur", "0.5 %", worst(resolved(table, "volume"), "error_percent"), percent, "–"),
        (f"with all {burs(full)} burs", "0.5 %", worst(resolved(full, "volume"), "error_percent"), percent, "–"),
        ("shape left by known strokes at 1, 50 and 200 mm/s, mean deviation", "0.5 µm", worst(resolved(table, "shape"), "deviation_um_mean"), um, "–"),
        ("shape left, maximum", "10 µm", worst(resolved(table, "shape"), "deviation_um_max"), um, "–"),
        (f"all {burs(full)} burs, mean deviation", "0.5 µm", worst(resolved(full, "shape"), "deviation_um_mean"), um, "–"),
        (f"all {burs(full)} burs, maximum", "10 µm", worst(resolved(full, "shape"), "deviation_um_max"), um, "–"),
        ("sliding while cutting: excess over the wear of a tick, maximum", "0.5 µm", worst(resolved(table, "slide"), "excess_um_max"), um, "–"),
        ("ridge between two cuts after 40 passes: height error", "5 µm", max(ridges, default=math.nan), um, "–"),
        ("a hole widened in circles by each round bur, its own neck at the mouth: longest without a cut", "10 ms",
         max((r.number("stuck_ms") for r in table.where(measure="hole")), default=math.nan), lambda value: f"{value:.0f} ms", "–"),
        ("cutting tick with the largest bur, p99", "250 µs", worst(resolved(table, "tick"), "tick_us_p99"), us,
         us(worst(resolved(table, "tick", "occupancy"), "tick_us_p99"))),
    ]
    rows = []
    for what, goal, value, reads, other in wanted:
        of_full = what.startswith(("all ", "with all "))
        if math.isnan(value) and of_full:
            continue
        rows.append([what, goal, reads(needed(value, "removal: " + what)), other])
    head = ["worst of", "goal", "surface proxy (Cusp)", "occupancy proxy (the paper)"]
    of_full = f" (--full: {full.version})" if full and full.commit != table.commit else ""
    return lines(head, rows) + (f"\n{table.source}{of_full}: solid blocks, round burs of 0.5 to 2.3 mm and a fissure of 1.0 mm, voxels of 0.04 "
                                f"to 0.2 mm; burs under three voxels of radius are left out. But for the row of holes, balls have thin necks. Shapes and volumes of strokes: {len(shaped)} burs.\n")


def burs(full):
    return len({r.text("bur") for r in full.where(measure="shape")}) if full else 0


def figures(tables):
    """The bench README's summary: one row a quantity, for the surface proxy and the paper's method."""
    accuracy, rate, scale, stability_table, cut = (tables[k] for k in ("accuracy", "rate", "scale", "stability", "removal"))

    def of(rows, field, take, what):
        values = [r.number(field) for r in rows if r.holds(field)]
        return needed(take(values) if values else math.nan, f"figures: {what}")

    def usual(table, method, **texts):
        return [r for r in table.where(method=method, **texts) if r.is_near("bur_radius_mm", 0.5) and r.is_near("voxel_mm", USUAL_VOXEL_MM)]

    rows = []
    for what, cell in (
            ("`rate`: own channel, updates/s, slowest",
             lambda m: short(of(usual(rate, m, shape="channel"), "updates_per_s", min, "channel"))),
            ("`rate`: tick exploring, p99, µs, worst",
             lambda m: small(of(usual(rate, m, task="exploration"), "tick_us_p99", max, "tick"))),
            ("`accuracy`: angle p95 on every shape but the channel, °, worst slide",
             lambda m: small(of([r for r in usual(accuracy, m, motion="slide") if r.text("shape") != "channel"
                                 and r.text("unresolved") != "true"], "angle_deg_p95", max, "angle"))),
            ("`accuracy`: pose error in the own channel, µm, mean · worst",
             lambda m: small(of(usual(accuracy, m, shape="channel"), "pose_um_mean", mean, "pose")) + " · "
             + small(of(usual(accuracy, m, shape="channel"), "pose_um_max", max, "pose"))),
            ("`scale`: cost of a tick, 1024³ over 128³", lambda m: f"{of(scale.where(method=m, variant='whole-top'), 'cost_to_smallest', lambda v: v[-1], 'scale'):.2f}"),
            ("`scale`: memory at 1024³, MB", lambda m: f"{of(scale.where(method=m), 'memory_mb', max, 'memory'):.0f}"),
            ("`stability`: penetration, guard on, µm, worst",
             lambda m: small(of([r for r in stability_table.where(method=m, guard="on") if r.text("unresolved") != "true"], "penetration_um", max, "penetration"))),
            ("`removal`: drilling speed error, %, worst", lambda m: small(worst(resolved(cut, "speed", m), "error_percent"))),
            ("`removal`: cutting tick, largest bur, p99, µs", lambda m: small(worst(resolved(cut, "tick", m), "tick_us_p99")))):
        rows.append([what, cell("surface"), cell("occupancy")])
    source = ", ".join(f"{name} {tables[name].engine} ({tables[name].short_commit})" for name in ("accuracy", "rate", "scale", "stability", "removal"))
    return lines(["ball bur r 0.5 mm, voxels of 10/128 mm", LABELS["surface"], LABELS["occupancy"]], rows) + f"\n{rate.machine}; engine (commit): {source}.\n"
