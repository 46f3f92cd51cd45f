"""The paper's figures 13 and 14 on Cusp's methods: updates a second by task; displacement and force over time."""
import math
import statistics

import style
from contact_charts import PAPER_EXPLORATION, PAPER_PERFORATION
from style import BLUE, COLOURS, GREEN, MARKS, QUIET, TEXT, VERMILION
from tables import Missing

TASKS = (("displacement", "A  displacement"), ("exploration", "B  exploration"), ("perforation", "C  perforation"))
SHOWN = ("surface", "occupancy")
SAMPLE_S, SAMPLES = 0.025, 16  # as the paper samples; samples a task (tests/bench/tasks.h)
TASK_S = SAMPLE_S * SAMPLES


def need_samples(table):
    for task, _ in TASKS:
        for method in SHOWN:
            if not table.where(method=method, task=task):
                raise Missing(f"{table.name}: no samples of {method} in {task}")


def rates_by_task(pace):
    need_samples(pace)
    rates = [row.number("updates_per_s") for row in pace.rows]
    fig = style.figure(
        860, 535, "Updates a second in the paper's three tasks",
        "Solid block, sampled every 25 ms of stepping, one core; ball bur of 0.5 mm radius, 128³ voxels in 10 mm.",
        f"{pace.source}. Circles: surface proxy. Squares: occupancy proxy, the paper's method. Dashed: the paper, 2012.\n"
        f"Slowest sample: {style.short(min(rates))}.")
    axes = style.panel(fig, 76, 96, 836, 440)
    axes.set_xlim(0, 3 * TASK_S)
    axes.set_xlabel("seconds")
    axes.set_ylabel("updates a second")
    style.decades(axes.yaxis, rates + [PAPER_EXPLORATION, PAPER_PERFORATION])
    for i, (task, label) in enumerate(TASKS):
        start, middle = i * TASK_S, (i + 0.5) * TASK_S
        axes.annotate(label, (middle / (3 * TASK_S), 1), (0, 9), xycoords="axes fraction", textcoords="offset points",
                      ha="center", fontweight="bold", fontsize=9.8)
        if i:
            axes.axvline(start, color=QUIET, lw=1, ls=(0, (3, 3)), ymax=1.06, clip_on=False)
            paper = PAPER_EXPLORATION if i == 1 else PAPER_PERFORATION
            axes.plot([start, start + TASK_S], [paper, paper], color=TEXT, lw=1.4, ls=(0, (6, 3)))
            axes.annotate(f"the paper, 2012: {style.short(paper)}", (middle, paper), (0, -13), textcoords="offset points",
                          ha="center", fontsize=9)
        medians = {}
        for method in SHOWN:
            samples = [(start + row.number("time_s"), row.number("updates_per_s")) for row in pace.where(method=method, task=task)]
            axes.plot(*zip(*samples), marker=MARKS[method], ms=5, color=COLOURS[method], lw=1.6, clip_on=False)
            medians[method] = statistics.median_high([rate for _, rate in samples])
        upper = max(medians, key=medians.get)
        for method, median in medians.items():
            # Of the lower line where more room is: up to the paper's line, or to the upper one.
            below = method != upper and (not i or median / paper > medians[upper] / median)
            axes.annotate(f"{method} proxy {style.short(median)}", (middle, median), (0, 12 if not below else -14 if i else -20),
                          textcoords="offset points", ha="center", fontweight="bold", fontsize=9.8)
    return fig


def displacement_and_force(motion):
    need_samples(motion)
    end = math.ceil(2 * max(row.number("time_s") for row in motion.rows) - 1e-6) / 2
    most = max(abs(row.number(f"f{a}_n")) for row in motion.rows for a in "xyz")
    way = math.ceil(max(abs(row.number(f"{a}_mm")) for row in motion.rows for a in "xyz") - 1e-6)
    most = math.ceil(5 * max(most, 0.1) - 1e-6) / 5
    ends = [max(row.number("time_s") for row in motion.where(task=task)) for task, _ in TASKS]
    fig = style.figure(
        860, 760, "Displacement and force on each axis through the three tasks",
        "Solid block, the same scripted motion at 1 kHz, a point every 25 ms; 1 N/mm, wear up to 1 mm/s. z points out of the top.",
        f"{motion.source}. Ball bur of 0.5 mm radius, 128³ voxels in 10 mm. x dashed, y dotted, z solid.")
    looks = (("x", VERMILION, (0, (6, 3)), 1.4), ("y", GREEN, (0, (1, 2)), 1.6), ("z", BLUE, "-", 1.9))
    panels = (("displacement, mm", "surface", "{}_mm", -way, way, way / 2, 98), ("surface proxy, N", "surface", "f{}_n", -most / 2, most, most / 4, 304),
              ("occupancy proxy, N", "occupancy", "f{}_n", -most / 2, most, most / 4, 510))
    for title, method, field, low, high, step, top in panels:
        axes = style.panel(fig, 76, top, 812, top + 180)
        axes.set_xlim(0, end)
        axes.set_ylim(low, high)
        axes.set_yticks([low + step * i for i in range(round((high - low) / step) + 1)])
        axes.set_xticks([0.5 * i for i in range(round(2 * end) + 1)])
        axes.set_ylabel(title)
        if top < 500:
            axes.set_xticklabels([])
        else:
            axes.set_xlabel("seconds")
        for i, (_, label) in enumerate(TASKS):
            if i < 2:
                axes.axvline(ends[i], color=QUIET, lw=1, ls=(0, (3, 3)))
            if top < 100:
                middle = ((ends[i - 1] if i else 0) + ends[i]) / 2
                axes.annotate(label, (middle / end, 1), (0, 9), xycoords="axes fraction", textcoords="offset points", ha="center",
                              fontweight="bold", fontsize=9.8)
        named = []
        for axis, colour, dash, wide in looks:
            line = [(row.number("time_s"), row.number(field.format(axis))) for row in motion.where(method=method)]
            axes.plot(*zip(*line), color=colour, ls=dash, lw=wide)
            named.append((*line[-1], axis, "", colour))
        style.name_ends(axes, named)
    return fig
