#!/usr/bin/env python3
"""Charts and tables show the rows, name missing rows, and match the committed files."""
import math
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import contact_charts
import draw
import markdown_tables
import removal_charts
import stability_charts
import style
import task_charts
from tables import Missing, Row, Table, read, read_all

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "ablation"))

from mechanisms import MECHANISMS

RESULTS = HERE.parent / "results"
README = HERE.parent / "README.md"
PROJECT_README = HERE.parents[2] / "README.md"


def table(name, rows):
    return Table(name, "0123456789abcdef", 9, "A CPU", [Row(r) for r in rows])


def texts(figure):
    """Every text of a figure, axes included."""
    return [t.get_text() for t in figure.findobj(match=lambda a: hasattr(a, "get_text"))]


def without(tables, name, is_dropped):
    kept = [r for r in tables[name].rows if not is_dropped(r)]
    return {**tables, name: Table(name, tables[name].commit, tables[name].engine, tables[name].machine, kept)}


class Committed(unittest.TestCase):
    def setUp(self):
        self.tables = read_all(RESULTS)

    def tearDown(self):
        style.plt.close("all")

    def test_files_are_what_their_tables_give(self):
        done = subprocess.run([sys.executable, HERE / "draw.py", RESULTS, "--readme", README, "--check"], capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_tables_are_of_a_commit_not_of_files_changed_since(self):
        for name, one in self.tables.items():
            with self.subTest(name):
                self.assertRegex(one.commit, "^[0-9a-f]{40}$")

    def test_check_names_a_table_that_differs_and_a_chart_that_is_not_there(self):
        with tempfile.TemporaryDirectory() as folder:
            same, other, gone = (pathlib.Path(folder) / name for name in ("a.md", "b.md", "c.svg"))
            same.write_text("text")
            other.write_text("other")
            self.assertEqual(draw.differing({same: "text", other: "text", gone: "text"}), [str(other), str(gone)])

    def test_the_projects_readme_names_the_engine_version_of_its_charts(self):
        named = re.findall(r"[Ee]ngine version (\d+)", PROJECT_README.read_text(encoding="utf-8"))
        self.assertEqual(named, [str(self.tables[name].engine) for name in ("accuracy", "stability", "removal")])

    def test_every_figure_names_machine_engine_version_and_commit(self):
        machine = self.tables["accuracy"].machine
        for figure in (contact_charts.error_against_voxel(self.tables["accuracy"]), removal_charts.depth_over_time(self.tables["removal"])):
            self.assertTrue(any(f"{machine}, engine " in t and "commit" in t for t in texts(figure)))

    def test_no_title_or_footing_leaves_its_figure(self):
        t = self.tables
        for figure in (contact_charts.speed_against_accuracy(t["accuracy"], t["rate"], 0.25), contact_charts.speed_against_accuracy(t["accuracy"], t["rate"], 0.5),
                       contact_charts.error_against_voxel(t["accuracy"]), contact_charts.cost_against_size(t["rate"], t["scale"]),
                       task_charts.rates_by_task(t["pace"]), task_charts.displacement_and_force(t["motion"]), stability_charts.stability_map(t["stability"]),
                       stability_charts.stiffness_against_damping(t["stability"]), stability_charts.stiffness_by_cell(t["stability-full"]),
                       removal_charts.depth_over_time(t["removal"]), removal_charts.speed_error(t["removal"])):
            for text in figure.texts:
                with self.subTest(text.get_text()):
                    self.assertLessEqual(text.get_window_extent().x1, figure.bbox.x1)

    def test_every_voxel_size_that_was_measured_is_named(self):
        shown = texts(contact_charts.speed_against_accuracy(self.tables["accuracy"], self.tables["rate"], 0.5))
        for voxel in ("0.2", "0.1", "0.078", "0.04"):
            self.assertIn(voxel, shown)

    def test_a_cell_of_the_map_shows_failures_and_largest_stiffness(self):
        def row(k_max, k_exact, failures, **other):
            return {"method": "surface", "case": "face", "guard": "on", "device": "m0.1-b2", "grip": "soft", "friction_n": "0", "delay_ms": "1",
                    "k_max_n_per_mm": k_max, "k_exact_n_per_mm": k_exact, "failures": failures, **other}

        # The least over the usual device counts, and what another device fails in does not.
        stability = table("stability", [row("10.29", "1.5", ""), row("10.29", "1.66", "kicks"), row("1", "5", "through", device="m0.25-b5")])
        ratio, beyond, failed = stability_charts.cell(stability, "face", True, "surface", "on")
        self.assertAlmostEqual(ratio, 10.29 / 1.66)
        self.assertTrue(beyond)
        self.assertEqual(failed, ["kicks"])
        committed = self.tables["stability"]
        self.assertEqual(stability_charts.cell(committed, "face", True, "surface", "on")[2], [])
        self.assertIn("through", stability_charts.cell(committed, "thin-wall", False, "penalty", "on")[2])

    def test_missing_rows_are_named_and_nothing_is_drawn(self):
        for name, is_dropped, figure, word in (
                ("accuracy", lambda r: r.text("shape") == "cylinder", lambda t: contact_charts.error_against_voxel(t["accuracy"]), "cylinder"),
                ("accuracy", lambda r: True, lambda t: contact_charts.speed_against_accuracy(t["accuracy"], t["rate"], 0.25), "accuracy"),
                ("rate", lambda r: r.text("method") == "surface", lambda t: markdown_tables.methods(t["accuracy"], t["rate"]), "surface"),
                ("scale", lambda r: True, lambda t: contact_charts.cost_against_size(t["rate"], t["scale"]), "scale"),
                ("stability", lambda r: r.text("method") == "ray" and r.text("case") == "islands",
                 lambda t: stability_charts.stability_map(t["stability"]), "islands"),
                ("stability", lambda r: r.text("grip") == "firm", lambda t: stability_charts.stiffness_against_damping(t["stability"]), "firm"),
                ("removal", lambda r: r.text("tissue") == "enamel" and r.text("measure") == "depth",
                 lambda t: removal_charts.depth_over_time(t["removal"]), "enamel"),
                ("removal", lambda r: r.text("method") == "occupancy", lambda t: removal_charts.speed_error(t["removal"]), "occupancy"),
                ("removal", lambda r: r.text("measure") == "ridge", lambda t: markdown_tables.removal(t["removal"]), "ridge")):
            with self.subTest(word), self.assertRaisesRegex(Missing, word):
                figure(without(self.tables, name, is_dropped))

    def test_the_milled_cavity_is_shown_where_it_was_measured(self):
        fields = {"method": "surface", "motion": "slide", "speed_mm_s": "50", "minutes": "2", "tremor_mm": "0.05", "encoder_mm": "0"}
        numbers = ("updates_per_s", "angle_deg_mean", "angle_deg_p95", "angle_deg_p99", "pose_um_mean", "pose_um_p95", "depth_um_mean",
                   "force_step_excess_mn_p99", "force_step_excess_mn_max", "tick_us_p50", "tick_us_p999")
        slides = [{**fields, **dict.fromkeys(numbers, "7.5"), "bur_radius_mm": r} for r in ("0.25", "0.4", "0.5")]
        mill = {"method": "surface", "task": "mill", "minutes": "2", "tremor_mm": "0.05", "bur_radius_mm": "0.4", "tick_us_mean": "151", "tick_us_p999": "495"}
        slow = [{**slide, "speed_mm_s": "5", "tick_us_p50": "2.5"} for slide in slides]
        cavity = table("cavity", [*slides, *slow, mill])
        accuracy, rate = self.tables["accuracy"], self.tables["rate"]
        shown = markdown_tables.methods(accuracy, rate, cavity)
        self.assertTrue(shown.startswith(markdown_tables.methods(accuracy, rate)))
        self.assertIn("| 0.4 mm | 7.5 · 7.5 · 7.5 | 7.5 · 7.5 | 7.5 | 7.5 · 7.5 | 2.5 · 7.5 | 7.5 · 7.5 | 151 · 495 |", shown)
        self.assertIn("| 0.5 mm | 7.5 · 7.5 · 7.5 | 7.5 · 7.5 | 7.5 | 7.5 · 7.5 | 2.5 · 7.5 | 7.5 · 7.5 | – |", shown)
        label = "surface proxy in a cavity, milled 2 min"
        self.assertIn(label, texts(contact_charts.speed_against_accuracy(accuracy, rate, 0.5, cavity)))
        self.assertNotIn(label, texts(contact_charts.speed_against_accuracy(accuracy, rate, 0.5)))
        with self.assertRaisesRegex(Missing, "0.4 mm"):
            markdown_tables.methods(accuracy, rate, table("cavity", [slides[0], slides[2], *slow, mill]))
        self.assertIn("milled cavity", draw.write_tables({**self.tables, "cavity": cavity})["methods.md"])
        clean = {name: rows for name, rows in self.tables.items() if name != "cavity"}
        self.assertNotIn("milled cavity", draw.write_tables(clean)["methods.md"])

    def test_milling_has_a_line_for_each_bur_and_axis_and_names_longer_runs(self):
        row = {"bur": "inverted_cone 35", "axis": "fixed", "minutes": "2", "tick_us_mean": "80.4", "tick_us_p999": "251", "tick_us_p9999": "300",
               "work_us_max": "280", "deferred_percent": "0.25"}
        shown = markdown_tables.milling(table("mill-full", [row, {**row, "axis": "jitter", "minutes": "20"}]))
        self.assertIn("| inverted cone 35 | fixed | 80 · 251 · 300 | 280 | 0.25 |", shown)
        self.assertIn("| inverted cone 35, 20 min | jitter | 80 · 251 · 300 | 280 | 0.25 |", shown)
        with self.assertRaisesRegex(Missing, "inverted_cone 35"):
            markdown_tables.milling(table("mill-full", [{**row, "tick_us_mean": ""}]))
        self.assertNotIn("milling.md", draw.write_tables({name: rows for name, rows in self.tables.items() if name != "mill-full"}))

    def test_a_mechanism_that_is_off_shows_what_changes_beyond_the_spread(self):
        def rows(mechanism, **values):
            return [{"mechanism": mechanism, "part": "search", "quantity": q, "value": str(v)} for q, v in values.items()]

        angle, time, ticks = "cavity: angle mean, deg", "cavity: tick p50, us", "cuts: infeasible ticks"
        shown = markdown_tables.ablation(table("ablation", [
            *rows("as it stands", **{angle: 0.2, time: 4, ticks: 0}), *rows("as it stands", **{angle: 0.2, time: 5, ticks: 0}),
            *rows("polish", **{angle: 3, time: 3, ticks: 7}), *rows("leap", **{angle: 0.21, time: 5.4, ticks: 0}), *rows("edges", **{"fails: Edges.hold": 1})]))
        self.assertIn("| search | polish | cuts: infeasible ticks 0 → 7; cavity: angle mean 0.2 → 3 ° | cavity: tick p50 4 → 3 µs |", shown)
        self.assertIn("| search | leap | – | – |", shown)
        self.assertIn("| search | edges | Edges.hold fails | – |", shown)
        with self.assertRaisesRegex(Missing, "as it stands"):
            markdown_tables.ablation(table("ablation", rows("polish", **{angle: 3})))

    def test_each_mechanism_was_measured(self):
        measured = list(dict.fromkeys(row.text("mechanism") for row in self.tables["ablation"].rows))
        self.assertEqual([markdown_tables.AS_IT_STANDS, *(m.name for m in MECHANISMS)], measured)

    def test_a_full_sweep_widens_the_table_of_removal_only_where_it_was_run(self):
        self.assertIn("all 36 burs", markdown_tables.removal(self.tables["removal"], self.tables["removal-full"]))
        self.assertNotIn("all 36 burs", markdown_tables.removal(self.tables["removal"]))


class Figures(unittest.TestCase):
    def test_order_of_a_power_is_fitted_exactly(self):
        # error = 3 h^2
        self.assertAlmostEqual(contact_charts.fitted_order([(0.2, 0.12), (0.1, 0.03), (0.05, 0.0075)]), 2.0, places=12)

    def test_order_is_of_the_error_beyond_the_face_s(self):
        floor = [(h, 0.001) for h in (0.2, 0.1, 0.05)]
        series = [(h, math.hypot(0.5 * h * h, 0.001)) for h, _ in floor]
        self.assertEqual(contact_charts.order_of(series, floor), "order 2.0")
        self.assertEqual(contact_charts.order_of(floor, floor), "as the face")

    def test_large_numbers_take_a_unit_prefix(self):
        for value, text in ((62e3, "62 k"), (1.5e6, "1.5 M"), (671234, "671 k"), (0.25, "0.25"), (999.7e3, "1 M")):
            self.assertEqual(style.short(value), text)

    def test_a_ridge_counts_loss_beyond_wear(self):
        def table_of(um):
            fields = dict.fromkeys(("error_percent", "deviation_um_mean", "deviation_um_max", "excess_um_max", "tick_us_p99", "stuck_ms"), "0.5")
            return table("removal", [dict(fields, method=m, measure=k, direction="-z", tick_ms="1", alpha="1", ridge_um=str(um))
                                     for m in ("surface", "occupancy")
                                     for k in ("speed", "mixed", "order", "shape", "volume", "slide", "tick", "hole", "ridge")])
        self.assertIn("| -7.2 µm |", markdown_tables.removal(table_of(-7.25)))
        self.assertIn("| 7.2 µm |", markdown_tables.removal(table_of(7.25)))

    def test_slope_is_taken_where_the_bur_s_front_is_in_one_tissue(self):
        rows = [Row(time_s=str(0.1 * k), depth_mm=str(0.12 * k)) for k in range(80)]
        self.assertAlmostEqual(removal_charts.slope(rows, 1), 1.2, places=9)
        self.assertTrue(math.isnan(removal_charts.slope(rows[:5], 2)))

    def test_labels_of_meeting_lines_move_apart_about_their_middle(self):
        places = style.apart([10.0, 11.0, 40.0], 15)
        self.assertGreaterEqual(places[1] - places[0], 15)
        self.assertGreaterEqual(places[2] - places[1], 15)
        self.assertAlmostEqual(sum(places), 61.0)

    def test_bounds_of_passivity_are_the_published_ones(self):
        # Colgate and Schenkel: K = 2 b / T; 2 N s/m at 1 ms: 4000 N/m.
        self.assertAlmostEqual(stability_charts.colgate_n_per_mm(2.0), 4.0)
        # Abbott and Okamura: 2 f / encoder step; 0.1 N at 0.049 mm: 4.08 N/mm.
        self.assertAlmostEqual(stability_charts.abbott_okamura_n_per_mm(24.0, 0.1), 4.0816, places=4)


class Files(unittest.TestCase):
    def test_a_file_that_is_no_table_is_refused(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "rate.csv"
            for text in ("", "not,a,table\n1,2,3\n", "# commit c, machine m\na,b\n1,2\n", "# commit c, engine 9, machine m\na,b\n1\n", "# commit c, engine 9, machine m\na,b\n1,2,3\n"):
                path.write_text(text)
                with self.subTest(text), self.assertRaises(Missing):
                    read(path)
            with self.assertRaisesRegex(Missing, "accuracy.csv"):
                read_all(folder)

    def test_a_readme_keeps_all_but_its_tables(self):
        marks = "".join(f"before {t}\n<!-- {t}: written by draw.py -->\nold\n<!-- /{t} -->\n" for t in ("methods", "stability", "removal"))
        drawn = {f"{t}.md": f"new {t}\n" for t in ("methods", "stability", "removal")}
        self.assertEqual(draw.placed(marks + "after\n", drawn, "README.md"),
                         "".join(f"before {t}\n<!-- {t}: written by draw.py -->\nnew {t}\n<!-- /{t} -->\n" for t in ("methods", "stability", "removal")) + "after\n")
        with self.assertRaisesRegex(Missing, "no place"):
            draw.placed("no marks\n", drawn, "README.md")
        with self.assertRaisesRegex(Missing, "methods"):
            draw.placed("<!-- methods: written by draw.py -->\n", drawn, "README.md")


if __name__ == "__main__":
    unittest.main()
