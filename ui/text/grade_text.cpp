#include "ui/text/grade_text.h"

#include <algorithm>
#include <cmath>

#include "scenarios/format/keys.h"
#include "scenarios/grading/grader.h"
#include "ui/text/metric_names.h"
#include "ui/text/names.h"
#include "ui/text/text.h"
#include "ui/widgets/format.h"

namespace cusp::ui {

QString target_title(std::string_view name, const Region* whole) {
  if (whole != nullptr)
    for (const Region* one : named_targets(*whole))
      if (one->name == name && !one->title.empty()) return local(one->title);
  QString out = QString::fromUtf8(name.data(), static_cast<qsizetype>(name.size())).replace(u'_', u' ');
  if (!out.isEmpty()) out[0] = out[0].toUpper();
  return out;
}

QString metric_name(const std::string& m, const Region* whole, const TissueNames& own) {
  if (const auto [metric, target] = scenarios::split_metric(m); !target.empty())
    return Text::tr("%1 (%2)", "a measurement of one of several targets").arg(metric_name(std::string(metric), nullptr, own), target_title(target, whole));
  if (m == "target_removed") return Text::tr("Target removed");
  if (m == "overcut_leeway_floor") return Text::tr("Over-cut within tolerance, floor");
  if (m == "overcut_leeway_side") return Text::tr("Over-cut within tolerance, walls");
  if (m == "overcut_beyond_floor") return Text::tr("Over-cut, floor");
  if (m == "overcut_beyond_side") return Text::tr("Over-cut, walls");
  if (m == "uncut_remainder") return Text::tr("Not removed");
  if (m == "depth_least") return Text::tr("Floor depth, shallowest");
  if (m == "depth_mean") return Text::tr("Floor depth, mean");
  if (m == "depth_most") return Text::tr("Floor depth, deepest");
  if (m == "wall_angle_mesial") return Text::tr("Mesial wall, divergence");
  if (m == "wall_angle_distal") return Text::tr("Distal wall, divergence");
  if (m == "wall_angle_buccal") return Text::tr("Buccal wall, divergence");
  if (m == "wall_angle_lingual") return Text::tr("Lingual wall, divergence");
  if (m == "convergence_mesiodistal") return Text::tr("Convergence, mesial to distal wall");
  if (m == "convergence_buccolingual") return Text::tr("Convergence, buccal to lingual wall");
  if (m == "floor_flatness") return Text::tr("Floor, deviation from flat");
  if (m == "floor_tilt") return Text::tr("Floor, tilt");
  if (m == "isthmus_width") return Text::tr("Isthmus, least width");
  if (m == "ridge_mesial") return Text::tr("Mesial marginal ridge");
  if (m == "ridge_distal") return Text::tr("Distal marginal ridge");
  if (m == "remaining_over_pulp") return Text::tr("Dentine over pulp");
  if (m == "protected_removed") return Text::tr("Removed of what is protected");
  if (m == "protected_damage") return Text::tr("Protected part damaged");
  if (m == "time") return Text::tr("Time");
  if (m == "force_peak") return Text::tr("Peak force");
  if (m == "force_mean") return Text::tr("Mean force");
  if (m == "pulp_exposure") return Text::tr("Pulp opened");
  if (m == "dry_cutting_time") return Text::tr("Cut without coolant");
  if (m == "temperature_rise_peak") return Text::tr("Tooth warmer by");
  if (m == "dry_cutting") return Text::tr("Tooth overheated");
  if (const QString name = group_metric_name(m); !name.isEmpty()) return name;
  if (m.starts_with("removed_")) {
    if (const auto tissue = scenario_tissue_from_key(m.substr(8))) return Text::tr("%1 removed").arg(tissue_name(*tissue, own));
  }
  return text(m);
}

QString metric_unit(const std::string& m) {
  const auto metric = scenarios::metric_from_key(m);
  return metric ? QString::fromUtf8(metric->unit.data(), static_cast<qsizetype>(metric->unit.size())) : QString();
}

bool is_yes_or_no(const std::string& m) {
  const auto metric = scenarios::metric_from_key(m);
  return metric && metric->unit.empty();
}

namespace {

QString yes_or_no(double value) {
  constexpr double kYesFrom = 0.5;  // between 0 and 1: bands may lie between them
  return value < kYesFrom ? Text::tr("no") : Text::tr("yes");
}

Measured with_uncertainty(const Measure& m) { return {m.value, m.uncertainty, text(m.unit)}; }

}  // namespace

QString measure_text(const Measure& m) { return is_yes_or_no(m.metric) ? yes_or_no(m.value) : format(with_uncertainty(m)); }
QString measure_value(const Measure& m) { return is_yes_or_no(m.metric) ? yes_or_no(m.value) : format_value(with_uncertainty(m)); }
QString measure_uncertainty(const Measure& m) { return is_yes_or_no(m.metric) ? QString() : format_uncertainty(with_uncertainty(m)); }

QString critical_name(const std::string& critical) {
  if (critical == "pulp_exposure") return Text::tr("The pulp was exposed");
  if (critical == "protected_damage") return Text::tr("Something protected was damaged");
  if (critical == "dry_cutting") return Text::tr("The tooth was overheated by cutting dry");
  return metric_name(critical);
}

namespace {

QString number_of(double value) {
  for (int decimals = 0; decimals < 3; ++decimals) {
    const double scaled = value * std::pow(10.0, decimals);
    if (std::abs(scaled - std::round(scaled)) < 1e-6) return format_number(value, decimals);
  }
  return format_number(value, 3);
}

QString with_unit(double value, const QString& unit) {
  return isolate(unit.isEmpty() ? number_of(value) : number_of(value) + QChar(0x00A0) + unit_text(unit));
}

/// To the tenth of a percent, but "100 %" never appears where points are missing.
QString share_text(double share) {
  const double tenths = std::round(share * 1000);
  return with_unit((share < 1.0 ? std::min(tenths, 999.0) : tenths) / 10, u"%"_qs);
}

/// As many decimals as keep value and limit apart, up to three, and never fewer than `least`: "96.97", not "97", of 97.
int decimals_apart(double value, double limit, int least) {
  int decimals = least;
  const auto same = [&](int n) { return format_number(value, n) == format_number(limit, n); };
  while (decimals < 3 && same(decimals)) ++decimals;
  return decimals;
}

}  // namespace

QString wanted_text(const Criterion& c) {
  const QString unit = metric_unit(c.metric);
  const Bands& b = c.bands;
  if (is_yes_or_no(c.metric)) {
    const bool no = b.ideal_lo <= 0 && b.ideal_hi >= 0, yes = b.ideal_lo <= 1 && b.ideal_hi >= 1;
    if (no && yes) return Text::tr("yes or no");
    if (no || yes) return yes_or_no(yes ? 1 : 0);
  }
  // A side whose three edges coincide has no edge: nothing lies beyond it.
  const bool open_low = b.fail_lo == b.ideal_lo && b.acc_lo == b.ideal_lo;
  const bool open_high = b.fail_hi == b.ideal_hi && b.acc_hi == b.ideal_hi;
  if (open_low && !open_high) return Text::tr("up to %1").arg(with_unit(b.ideal_hi, unit));
  if (open_high && !open_low) return Text::tr("%1 or more").arg(with_unit(b.ideal_lo, unit));
  if (b.ideal_lo == b.ideal_hi) return with_unit(b.ideal_lo, unit);
  return Text::tr("%1 to %2").arg(number_of(b.ideal_lo), with_unit(b.ideal_hi, unit));
}

QString reason_text(const CriterionGrade& g) {
  const auto arg = [&](const char* key) {
    const auto it = g.reason_args.find(key);
    return it == g.reason_args.end() ? 0.0 : it->second;
  };
  const QString unit = text(g.measure.unit);
  if (g.reason_code == "little_drilled") {
    return Text::tr("Counts for %1, because target is left").arg(share_text(arg("share")));
  }
  const double value = arg("value"), limit = arg("limit");
  if (g.reason_code == "needs_dof") {
    return Text::tr("Brings no points: it takes a device of %1 axes, and this one has %2").arg(format_number(value, 0), format_number(limit, 0));
  }
  if (is_yes_or_no(g.id) && (g.reason_code == "too_much" || g.reason_code == "too_little")) {
    //: Of a measurement that is "yes" or "no": what it is, and what earns full points.
    return Text::tr("%1; full points for %2").arg(yes_or_no(value), yes_or_no(limit));
  }
  const int decimals = decimals_apart(value, limit, unit == u"%" ? 1 : 2);
  const QString v = format({value, std::nullopt, unit, decimals}), l = with_unit(limit, unit);
  const QString apart = format({std::abs(value - limit), std::nullopt, unit, decimals});
  if (g.reason_code == "full") return Text::tr("Full points");
  if (g.reason_code == "not_measured") return Text::tr("Could not be measured");
  if (g.reason_code == "too_deep") return Text::tr("%1, %2 deeper than %3").arg(v, apart, l);
  if (g.reason_code == "too_shallow") return Text::tr("%1, %2 short of %3").arg(v, apart, l);
  const QString whole = format_value({value, std::nullopt, unit, decimals});
  if (g.reason_code == "too_much") return Text::tr("%1; full points up to %2").arg(whole, l);
  if (g.reason_code == "too_dry") return Text::tr("%1 without coolant; full points up to %2").arg(whole, l);
  if (g.reason_code == "too_warm") return Text::tr("%1 warmer; full points up to %2").arg(whole, l);
  if (g.reason_code == "too_little") {
    return scenarios::split_metric(g.id).metric == "target_removed" ? Text::tr("%1 removed; full points from %2").arg(whole, l)
                                    : Text::tr("%1; full points from %2").arg(whole, l);
  }
  return text(g.reason_code);
}

int point_forms(double points) { return format_points(points) == format_points(1) ? 1 : 2; }

QString points_text(double points) { return Text::tr("%1 point(s)", nullptr, point_forms(std::abs(points))).arg(format_points(points)); }

QString lost_text(const CriterionGrade& g, double lost, const Region* whole, const TissueNames& own) {
  return Text::tr("%1: %2 point(s) lost", nullptr, point_forms(lost)).arg(metric_name(g.id, whole, own), format_points(lost));
}

QString counted_text(const Grade& grade, const Rubric& rubric) {
  if (std::ranges::none_of(grade.criteria, &CriterionGrade::counts_with_target)) return {};
  double share = 1.0;
  bool own = false;  // criteria of one of several targets count with it
  for (const CriterionGrade& c : grade.criteria) {
    if (!c.counts_with_target) continue;
    share = std::min(share, scenarios::share_counted(grade, rubric, c.id));
    own = own || !scenarios::split_metric(c.id).target.empty();
  }
  if (!(share < 1.0)) return {};
  if (own) return Text::tr("The rest counts for less where its own target is left, the least of it for %1.").arg(share_text(share));
  return Text::tr("The rest counts for %1, because target is left.").arg(share_text(share));
}

QString changes_text(const GradeChanges& c, const Region* whole, const TissueNames& own) {
  const QString before = text(c.evaluator_before);
  if (c.none()) return Text::tr("Stored with marking %1: the same points.").arg(before);
  QStringList names;
  for (const CriterionChange& one : c.criteria) names += metric_name(one.id, whole, own);
  for (const std::string& event : c.critical) names += metric_name(event);
  return Text::tr("Stored with marking %1: %2 points. What differs: %3.").arg(before, format_points(c.score_before), names.join(u", "_qs));
}

QString advice_text(const CriterionGrade& g) {
  // What was drilled too little is advised about once, by the target's own criterion.
  if (g.reason_code == "full" || g.reason_code == "not_measured" || g.reason_code == "little_drilled" ||
      g.reason_code == "needs_dof") {
    return {};
  }
  const std::string m(scenarios::split_metric(g.id).metric);
  if (m == "target_removed") return Text::tr("Turn the view and look for what remains inside the target line.");
  if (m == "overcut_leeway_floor" || m == "overcut_beyond_floor")
    return Text::tr("Lift off and read the depth before you go deeper.");
  if (m == "overcut_leeway_side" || m == "overcut_beyond_side")
    return Text::tr("Keep the bur’s edge inside the target line; push less near the walls.");
  if (m == "uncut_remainder") return Text::tr("Turn the view and clear the corners along the walls.");
  if (m.starts_with("depth_")) {
    if (g.reason_code == "too_deep") return Text::tr("Stop pushing at the required depth and move sideways.");
    return Text::tr("Cut to the required depth over the whole floor.");
  }
  const bool too_little = g.reason_code == "too_little", too_much = g.reason_code == "too_much";
  if (m == "remaining_over_pulp")
    return too_much ? Text::tr("Cut to the required depth over the whole floor.") : Text::tr("Keep away from the pulp: stop at the required depth.");
  if (m.starts_with("wall_angle_") || m.starts_with("convergence_"))
    return Text::tr("Hold the bur along the axis of the preparation and draw it along the wall without leaning.");
  if (m == "floor_flatness" || m == "floor_tilt") return Text::tr("Go over the whole floor once more at one depth.");
  if (m == "isthmus_width") {
    if (too_little) return Text::tr("Widen the outline until the bur passes freely.");
    return Text::tr("Compare the width with the bur before you widen the outline.");
  }
  if (m.starts_with("ridge_"))
    return too_much ? Text::tr("Carry the outline closer to the marginal ridge; read its thickness from above.")
                    : Text::tr("Stop short of the marginal ridge; read its thickness from above.");
  if (const QString advice = group_advice(m, too_little ? OffBy::too_little : OffBy::too_much); !advice.isEmpty()) return advice;
  if (m == "force_peak" || m == "force_mean") return too_little ? QString() : Text::tr("Push less; let the bur do the work.");
  if (m == "time") {
    return too_little ? Text::tr("Take more time: read depth and walls before you end the attempt.") : Text::tr("Plan the way of the bur before the first cut.");
  }
  if (g.reason_code == "too_dry") return Text::tr("Run the coolant before the bur touches the tooth.");
  if (g.reason_code == "too_warm") return Text::tr("Run the coolant, push less, and lift off now and then.");
  if (too_much) return Text::tr("Take away less of it.");
  return Text::tr("Take away more of it.");
}

QString own_rating_name(OwnRating rating) {
  switch (rating) {
    case OwnRating::met: return Text::tr("met");
    case OwnRating::partly: return Text::tr("partly met");
    case OwnRating::not_met: return Text::tr("not met");
  }
  return {};
}

}  // namespace cusp::ui
