"""The mechanisms of contact and removal, each with the edits that turn it off and the code that goes on without it.

part: where it works. edits: (file, text to find, text to put); the text stands in the file exactly once, and what is put compiles
without a warning, so that no function or variable is left without a use.
"""
from dataclasses import dataclass


@dataclass(frozen=True)
class Mechanism:
    name: str
    part: str
    edits: tuple


def mechanism(part, name, *edits):
    return Mechanism(name, part, edits)


CONTACT = "engine/contact/surface_contact.cpp"
FOLLOW = "engine/contact/surface_follow.cpp"
FREE = "engine/contact/surface_free.cpp"
GATHER = "engine/contact/surface_gather.cpp"
PLANES = "engine/contact/surface_planes.cpp"
CONSTRAINTS = "engine/contact/surface_constraints.cpp"
POLISH = "engine/contact/surface_polish.cpp"
IN_SWEEP = "engine/contact/surface_in_sweep.cpp"
RESOLVE = "engine/contact/surface_resolve.cpp"
CUT_CELLS = "engine/contact/features/cut_cells.cpp"
CAVITY = "engine/contact/surface_cavity.cpp"
WALLS = "engine/contact/cavity/cavity_walls.cpp"
DESCENT = "engine/contact/cavity/cavity_descent.cpp"
HELD = "engine/contact/cavity/held_by_sweep.cpp"
VOID = "engine/contact/cavity/swept_void.cpp"
FOOT = "engine/contact/head_foot.cpp"
HEADER = "engine/contact/surface_contact.h"
STEP = "engine/step/step_surface.cpp"

MECHANISMS = [
    # What answers without a search.
    mechanism("free space", "FreeSpace: ticks in known free space ask nothing",
              (CONTACT, "  if (free_.valid && free_.bur ==", "  if (false && free_.bur =="),
              (CONTACT, "  if (free_pause_ > 0)\n", "  if (out.active == 0) return out;\n  if (free_pause_ > 0)\n")),
    mechanism("free space", "FreeSpace: the plane beyond which nothing stands",
              (FREE, "    if (glm::dot(n, pose) - found.c < kLeastFree) return false;", "    if (found.bounded || glm::dot(n, pose) - found.c < kLeastFree) return false;")),

    # The search by planes.
    mechanism("search", "polish: the answer corrected on the fields",
              (FOLLOW, "  if (!s.left && !held && found.active > 0) polished", "  if (false && !s.left && found.active > 0) polished")),
    mechanism("search", "polish: none where four planes enclose the head",
              (POLISH, "  if (!group_surfaces(found, t) || enclosed(found, t)) return out;", "  if (!group_surfaces(found, t) || (false && enclosed(found, t))) return out;")),
    mechanism("search", "polish: none where the field is creased",
              (POLISH, "        (field.creased && (all_resolved_", "        (false && (all_resolved_")),
    mechanism("search", "foot: the point under the push is a candidate",
              (FOLLOW, "  if (s.with_foot) {\n", "  if (false && s.with_foot) {\n")),
    mechanism("search", "prediction: constraints first built where the proxy will go",
              (FOLLOW, "  s.uses_prediction = predicted_mm > 2.0 * kTangentsHoldMm;", "  s.uses_prediction = false && predicted_mm > 2.0 * kTangentsHoldMm;")),
    mechanism("search", "prediction: the proxy's excess over the device",
              (STEP, "state.prediction_holds ? motion.way + state.predicted_excess * moved : motion.way;",
               "false && state.prediction_holds ? motion.way + state.predicted_excess * moved : motion.way;")),
    mechanism("search", "prediction: not where an edge stands deep in a head",
              (FOLLOW, "!tool.ball() && deep_in_edge(s.at)", "false && deep_in_edge(s.at)")),
    mechanism("search", "prediction: after a cut, where the proxy will go",
              (STEP, "                                             cut.end() - cut.pose, cut", "                                             0.0 * (cut.end() - cut.pose), cut")),
    mechanism("search", "leap of a ball that rolls over an edge",
              (FOLLOW, "tool.ball() ? leap_of_ball(found, s.at, y - s.at, rolls)", "tool.ball() ? Vec3(0.0)")),
    mechanism("search", "leap of a head that rolls over an edge",
              (FOLLOW, " : leap_of_head(found, y, s, rolls);", " : Vec3(0.0);")),
    mechanism("search", "turn_back(): a head's ways are halved where its search turns back",
              (FOLLOW, "    s.trust = std::max(kLeastTrustMm, 0.5 *", "    s.trust = std::max(s.trust, 0.5 *")),
    mechanism("search", "turn_back(): planes of earlier passes hold a head",
              (FOLLOW, "  if (s.turns > 0) add_kept", "  if (false && s.turns > 0) add_kept")),
    mechanism("search", "a longer step where a head leaves its step",
              (FOLLOW, "s.creep.planes > 0 ? kLongerStep * s.step : 0.0", "false && s.creep.planes > 0 ? kLongerStep * s.step : 0.0")),
    mechanism("search", "passes that build again from the last build's candidates",
              (FOLLOW, "  if (!rebuild_constraints(tool, s.at, s.asked)) {", "  if (s.asked > -1.0 || !rebuild_constraints(tool, s.at, s.asked)) {")),
    mechanism("search", "passes that only turn the active tangents",
              (FOLLOW, "  if (!(s.last_moved > kTangentsHoldMm)) {", "  if (false && !(s.last_moved > kTangentsHoldMm)) {")),
    mechanism("search", "the plane search starts from the last active set",
              (CONTACT, "{active_set_.plane, static_cast<std::size_t>(active_set_.count)});", "{active_set_.plane, static_cast<std::size_t>(0 * active_set_.count)});")),
    mechanism("search", "contradicting planes are relaxed to the pose",
              (CONTACT, "  if (!found.feasible) {\n    // Tangents of points", "  if (false && !found.feasible) {\n    // Tangents of points")),
    mechanism("search", "an outrun device is solved for in parts",
              (STEP, "  if ((contact.active > 0 || contact.deferred) && led", "  if (false && (contact.active > 0 || contact.deferred) && led")),
    mechanism("search", "budget of a tick",
              (HEADER, "  bool spent() const noexcept { return candidates_left_ <= 0", "  bool spent() const noexcept { return false && candidates_left_ <= 0"),
              (CAVITY, "(pass == 0 || candidates_left_ > 0)", "(pass >= 0 || candidates_left_ > 0)")),

    # Candidates and constraints.
    mechanism("constraints", "candidates serve several ticks",
              (GATHER, "const double margin = step + std::min(most_margin_mm, std::max(kLeastMargin, steps * step));",
               "const double margin = step + 0.0 * std::min(most_margin_mm, std::max(kLeastMargin, steps * step));")),
    mechanism("constraints", "HeadBand: of a face, points that hold off",
              (CONSTRAINTS, "    if (sources_[i].kind == Kind::surface && !may_be_surface) return;", "    if (false && !may_be_surface) return;")),
    mechanism("constraints", "planes over which a head stands too high are left out",
              (CONSTRAINTS, "      if (foot.over + tool.thin(c.field) > slack_mm + kNormalRounding) return;", "      if (false && foot.over > slack_mm + kNormalRounding) return;")),
    mechanism("constraints", "a foot beside the deepest place of a head",
              ("engine/contact/head_foot.h", "  return foot.deepest ? foot : foot_beside", "  return foot.deepest || reach > 0.0 ? foot : foot_beside"),
              (CONSTRAINTS, "    if (!foot.deepest) foot = foot_beside", "    if (false && !foot.deepest) foot = foot_beside")),
    mechanism("constraints", "a rim close by that stands deeper",
              (FOOT, "  if (!bur.head.rim(near, reach, rim)) return foot;", "  if (reach > 0.0 || !bur.head.rim(near, reach, rim)) return foot;")),
    mechanism("constraints", "planes of a ball end where other surfaces begin",
              (PLANES, "    const bool beyond = c.others > 0 && (past(Vec3", "    const bool beyond = false && (past(Vec3")),
    mechanism("constraints", "planes of a head end where other surfaces begin",
              (PLANES, "      if (!beyond) {\n        if (height > slack_mm) return out;", "      if (true || !beyond) {\n        if (height > slack_mm) return out;")),
    mechanism("constraints", "points that lie on an edge are left out",
              (PLANES, "  return all_resolved_ && c.others > 0 && (c.feature", "  return false && all_resolved_ && c.others > 0 && (c.feature")),
    mechanism("constraints", "the bulge of a scratch while it cuts",
              (PLANES, "const double bulge = !all_resolved_ &&", "const double bulge = false &&")),
    mechanism("constraints", "past poses of a head relax its planes (CutMemory)",
              (CONTACT, "  past_count_ = tool.ball() ? 0 : memory_.near(at, {tool.index, tool.axis}, past_);", "  past_count_ = 0 * memory_.near(at, {tool.index, tool.axis}, past_);")),
    mechanism("constraints", "clearance of 1 um, of another head of 2 um",
              (HEADER, "kClearanceMm = 0.001, kHeadClearanceMm = 0.002;", "kClearanceMm = 0.0, kHeadClearanceMm = 0.0;")),

    # Features.
    mechanism("features", "edges",
              (GATHER, "      const Kind kind = part == ToolPart::shank ", "      if (edge && part == ToolPart::head) return;\n      const Kind kind = part == ToolPart::shank ")),
    mechanism("features", "an edge's bend and twist",
              (CONSTRAINTS, "    const Vec3f &ba = fa.other_normal, &bb = fb.other_normal, &wa = fa.third_normal, &wb = fb.third_normal;",
               "    const Vec3f none(0.0f);\n    const Vec3f &ba = none, &bb = none, &wa = none, &wb = none;")),
    mechanism("features", "edges between cuts, resolved some a tick",
              (RESOLVE, "  const bool on = when != Resolve::off;", "  const bool on = false && when != Resolve::off;")),
    mechanism("features", "a mouth's edge ends with its cell",
              (CUT_CELLS, "  double from = out.other_d_mm, to = out.third_d_mm;", "  double from = out.other_d_mm, to = out.third_d_mm;\n  if (to > 0.0) return;")),
    mechanism("features", "voxels inside at an inner edge hold off a head",
              (GATHER, "(of_head ? page->feature[i].inner_edge : page->feature[i].inside)", "(of_head && false ? page->feature[i].inner_edge : page->feature[i].inside)")),
    mechanism("features", "no foot where a rim reaches into an inner edge",
              (GATHER, "    if (at.inner_edge && near_rim(tool, x - pose)) continue;", "    if (false && near_rim(tool, x - pose)) continue;")),
    mechanism("features", "a voxel inside counts once",
              (GATHER, "        if (!insides_.add(voxel)) return;", "        if (false && !insides_.add(voxel)) return;")),

    # The cavity that balls have cut.
    mechanism("cavity", "one sweep answers alone",
              (CONTACT, "(solve_in_sweep(volume, tool, from, device, reach_mm, out) ||", "((false && solve_in_sweep(volume, tool, from, device, reach_mm, out)) ||")),
    mechanism("cavity", "free neck and shank are known for some ticks",
              (IN_SWEEP, "  if (known.bur == tool.bur &&", "  if (false && known.bur == tool.bur &&")),
    mechanism("cavity", "curvature in the metric",
              (CAVITY, "at) * found.weight[a];\n  return out;", "at) * found.weight[a];\n  return out * 0.0;")),
    mechanism("cavity", "a pass solves again by its own curvature",
              (CAVITY, "    if (found.feasible && apart(bend, used) &&", "    if (false && apart(bend, used) &&")),
    mechanism("cavity", "KeptPlanes: a search that turns back keeps its planes",
              (CAVITY, "    if (turns > 0) keep_planes(found, y);", "    if (false && turns > 0) keep_planes(found, y);")),
    mechanism("cavity", "a ball's ways are halved from its search's fourth turn on",
              (CAVITY, "turns >= kMostTurns ? kTrustFalls : turns", "turns >= 100 * kMostTurns ? kTrustFalls : turns")),
    mechanism("cavity", "a neck's point is moved out of what balls have carved",
              (GATHER, "  if (source.kind == Kind::shank && sweeps_.size() > 0 &&", "  if (false && source.kind == Kind::shank && sweeps_.size() > 0 &&")),
    mechanism("cavity", "a neck's point is moved out of what is not carved yet",
              (CONSTRAINTS, "    if (walls_.uncarved_holds(c.point) &&", "    if (false && walls_.uncarved_holds(c.point) &&")),
    mechanism("cavity", "a feature whose place jumps keeps both",
              (CAVITY, "turns > 0 ? CavityWalls::Jump::keeps_both", "false && turns > 0 ? CavityWalls::Jump::keeps_both")),
    mechanism("cavity", "refine(): from a place to its feature",
              (CAVITY, "    if (candidate >= 0) continue;\n    const auto i = static_cast<std::size_t>(-1 - candidate);\n    const double slack", "    if (candidate >= -1000000) continue;\n    const auto i = static_cast<std::size_t>(-1 - candidate);\n    const double slack")),
    mechanism("cavity", "ridges between places are looked for",
              (WALLS, "    if (a >= 0 && b >= 0) sample_between", "    if (false && a >= 0 && b >= 0) sample_between")),
    mechanism("cavity", "settle(): a place that two looks do not meet",
              (WALLS, "  if (!met) {\n    Descent d;", "  if (!met) return false;\n  if (!met) {\n    Descent d;")),
    mechanism("cavity", "what was found serves on in the next tick",
              (WALLS, "  past_count_ = past_sweeps_ = 0;\n  feature_count_ =", "  release();\n  past_count_ = past_sweeps_ = 0;\n  feature_count_ =")),
    mechanism("cavity", "features found serve on in the next tick",
              (WALLS, "  feature_count_ = std::min(feature_count_, kMostKept);\n", "  feature_count_ = 0 * std::min(feature_count_, kMostKept);\n")),
    mechanism("cavity", "past poses of a ball relax the specimen's planes",
              (CAVITY, "  relax_by_past(0, own);", "  relax_by_past(0, 0 * own);")),
    mechanism("cavity", "sweeps that pass the ball move its places",
              (WALLS, "  for (int k = 0; k < past_sweeps_; ++k) {", "  for (int k = 0; k < 0 * past_sweeps_; ++k) {")),
    mechanism("cavity", "sweeps too shallow at a cell are left out",
              (VOID, "      if (within <= 0.0 || square[k][id - all[k].from] > within2) continue;\n", "      if (false && (within <= 0.0 || square[k][id - all[k].from] > within2)) continue;\n")),
    mechanism("cavity", "a cell's sweeps named beyond its faces",
              (VOID, "  int names = 8;\n  for (int axis = 0; axis < 3; ++axis)", "  int names = 8;\n  for (int axis = 0; axis < 0; ++axis)")),

    # Removal.
    mechanism("removal", "the pose settles on what was carved",
              (STEP, "  if (!state.carved) return;\n", "  if (!state.carved || bur != 0xffff) return;\n")),
    mechanism("removal", "a slide stands only as deep as its wear allows",
              (STEP, "  if (!(tau < kShallowTauMm)) return false;", "  if (tau >= -1.0 || !(tau < kShallowTauMm)) return false;")),
    mechanism("removal", "ticks of a stroke are carved together",
              (STEP, "  if (length_to(state.cut_way, next) >= longest_mm)", "  if (length_to(state.cut_way, next) >= 0.0 * longest_mm)")),
    mechanism("removal", "a head's sweep bends",
              (STEP, "  if (state.cut_way.count + 1 < Polyline::kMost) {", "  if (false && state.cut_way.count + 1 < Polyline::kMost) {")),
    mechanism("removal", "what neck and shank lean on does not push",
              (STEP, "  pressed.walls = {wall, walls};", "  pressed.walls = {wall, 0 * walls};")),
]
