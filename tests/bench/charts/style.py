"""Shared by all charts: colours and marks of methods, headings, axes, label placement. Colours: Okabe and Ito."""
import math

import matplotlib

matplotlib.use("agg")
from matplotlib import pyplot as plt  # noqa: E402
from matplotlib.ticker import FixedLocator, FuncFormatter, NullFormatter  # noqa: E402

TEXT, QUIET, GRID = "#1B1F24", "#5B646D", "#E3E6E9"
BLUE, VERMILION, ORANGE, GREEN, PURPLE, SKY = "#0072B2", "#D55E00", "#E69F00", "#009E73", "#CC79A7", "#56B4E9"

METHODS = ("surface", "gradient", "penalty", "ray", "occupancy", "occupancy-pivot")
LABELS = {"surface": "surface proxy (Cusp)", "gradient": "gradient proxy", "penalty": "penalty", "ray": "ray proxy",
          "occupancy": "occupancy proxy (the paper)", "occupancy-pivot": "occupancy, pivot only"}
COLOURS = {"surface": BLUE, "gradient": SKY, "penalty": PURPLE, "ray": GREEN, "occupancy": VERMILION,
           "occupancy-pivot": ORANGE}
MARKS = {"surface": "o", "gradient": "h", "penalty": "v", "ray": "^", "occupancy": "s", "occupancy-pivot": "D"}

PX = 1 / 100  # inches: the unit in which charts are laid out. Offsets of labels are points, of which an inch has 72

plt.rcParams.update({
    "font.family": ["Noto Sans", "DejaVu Sans"], "font.size": 9.5, "svg.fonttype": "none", "svg.hashsalt": "cusp",
    "text.color": TEXT, "axes.labelcolor": TEXT, "axes.edgecolor": QUIET, "axes.linewidth": 0.8,
    "xtick.color": QUIET, "ytick.color": QUIET, "xtick.labelcolor": QUIET, "ytick.labelcolor": QUIET,
    "axes.grid": True, "grid.color": GRID, "grid.linewidth": 0.8, "axes.spines.top": False, "axes.spines.right": False,
    "axes.axisbelow": True, "lines.markeredgecolor": "white", "lines.markeredgewidth": 0.8, "figure.dpi": 72,
})


def figure(wide, high, title, below, footing):
    """A figure of wide x high pixels with a title, a subtitle and a footing."""
    fig = plt.figure(figsize=(wide * PX, high * PX))
    fig.text(20 / wide, 1 - 30 / high, title, fontsize=13.5, fontweight="bold")
    fig.text(20 / wide, 1 - 50 / high, below, fontsize=9.5, color=QUIET)
    lines = footing.split("\n")
    for i, line in enumerate(lines):
        fig.text(20 / wide, (12 + 17 * (len(lines) - 1 - i)) / high, line, fontsize=8.2, color=QUIET)
    return fig


def panel(fig, left, top, right, bottom):
    """Axes between these pixels, counted from the upper left corner."""
    wide, high = fig.get_size_inches() / PX
    return fig.add_axes([left / wide, 1 - bottom / high, (right - left) / wide, (bottom - top) / high])


def short(value):
    """Three digits with a unit prefix: 62 k, 1.5 M, 0.25."""
    for unit, name in ((1e6, " M"), (1e3, " k")):
        if abs(value) >= unit * 0.9995:
            return f"{value / unit:.3g}{name}"
    return f"{value:.3g}"


def decades(axis, values):
    """A logarithmic axis from the decade below the least value to the one above the most."""
    low, high = math.floor(math.log10(min(values)) + 1e-9), math.ceil(math.log10(max(values)) - 1e-9)
    lettered(axis, 10.0**low, 10.0 ** max(high, low + 1), [10.0**n for n in range(low, max(high, low + 1) + 1)])


def lettered(axis, low, high, at):
    """A logarithmic axis with labels at given values."""
    axes, of = axis.axes, "x" if axis.axis_name == "x" else "y"
    getattr(axes, f"set_{of}scale")("log")
    getattr(axes, f"set_{of}lim")(low, high)
    axis.set_major_locator(FixedLocator(at))
    axis.set_major_formatter(FuncFormatter(lambda v, _: f"{v:.0f}" if v >= 1000 and of == "x" and v < 2000 else short(v)))
    axis.set_minor_formatter(NullFormatter())


def apart(places, least):
    """Moves places on a line until neighbours are at least `least` apart; order and middle stay."""
    order = sorted(range(len(places)), key=lambda i: places[i])
    out = list(places)
    for before, i in zip(order, order[1:]):
        out[i] = max(out[i], out[before] + least)
    shift = sum(out[i] - places[i] for i in order) / max(1, len(order))
    return [y - shift for y in out]


def name_ends(axes, ends, gap=9, line=15):
    """Names beside the right ends of lines, apart from each other. ends: (x, y, name, second line or "", colour)."""
    pixels = [axes.transData.transform((x, y)) for x, y, *_ in ends]
    lines = [line * (2 if second else 1) for _, _, _, second, _ in ends]
    ys = apart([p[1] for p in pixels], max(lines))
    for (x, y, name, second, colour), pixel, at in zip(ends, pixels, ys):
        offset = (gap, at - pixel[1])
        axes.annotate(name, (x, y), offset, textcoords="offset points", fontweight="bold", va="center", color=colour,
                      bbox={"fc": "white", "ec": "none", "pad": 0.5})
        if second:
            axes.annotate(second, (x, y), (gap, offset[1] - line), textcoords="offset points", va="center", color=QUIET)


class Room:
    """Label placement: keeps the occupied boxes, in points."""

    def __init__(self, axes):
        self.axes, self.boxes = axes, []
        self.renderer = axes.figure.canvas.get_renderer()

    def take(self, x, y, half):
        px, py = self.axes.transData.transform((x, y))
        self.boxes.append((px - half, py - half, px + half, py + half))

    def take_line(self, points):
        """Occupies a line by small boxes along it."""
        pixels = [self.axes.transData.transform(p) for p in points]
        for (ax, ay), (bx, by) in zip(pixels, pixels[1:]):
            steps = max(1, round(math.hypot(bx - ax, by - ay) / 3))
            for i in range(steps + 1):
                x, y = ax + (bx - ax) * i / steps, ay + (by - ay) * i / steps
                self.boxes.append((x - 1, y - 1, x + 1, y + 1))

    def overlap(self, box):
        frame = self.axes.bbox
        out = 0.0
        if box[0] < frame.x0 or box[2] > frame.x1 + 20 or box[1] < frame.y0 or box[3] > frame.y1 + 8:
            out += 1e6
        for b in self.boxes:
            wide, high = min(box[2], b[2]) - max(box[0], b[0]), min(box[3], b[3]) - max(box[1], b[1])
            if wide > 0 and high > 0:
                out += wide * high
        return out

    def label(self, x, y, text, reach, **font):
        """Places a label beside a point on the ring and side with the least overlap; a line leads to a distant label."""
        label = self.axes.annotate(text, (x, y), (0, 0), textcoords="offset points", ha="center", va="center", **font)
        extent = label.get_window_extent(self.renderer)
        half_w, half_h = extent.width / 2 + 2, extent.height / 2 + 1
        px, py = self.axes.transData.transform((x, y))
        best = None
        for ring in (0, 8, 18, 30):
            for dx, dy in ((1, 0), (-1, 0), (0, -1), (0, 1), (1, -1), (-1, -1), (1, 1), (-1, 1)):
                cx, cy = px + dx * (reach + ring + half_w), py + dy * (reach + ring + half_h)
                box = (cx - half_w, cy - half_h, cx + half_w, cy + half_h)
                cost = self.overlap(box) + 0.8 * ring
                if best is None or cost < best[0] - 1e-9:
                    best = (cost, cx - px, cy - py, box, ring)
        _, dx, dy, box, ring = best
        label.set_position((dx, dy))
        self.boxes.append(box)
        if ring:
            self.axes.annotate("", (x, y), (dx - math.copysign(half_w, dx) * (dx != 0), dy - math.copysign(half_h, dy) * (dy != 0)),
                               textcoords="offset points", arrowprops={"arrowstyle": "-", "color": QUIET, "lw": 0.7})
        return label
