#include "ui/editor/check_messages.h"

#include <QCoreApplication>

#include "scenarios/format/keys.h"
#include "scenarios/format/ranges.h"
#include "ui/modules.h"
#include "ui/text/failure_text.h"
#include "ui/text/grade_text.h"
#include "ui/text/language.h"
#include "ui/widgets/format.h"

namespace cusp::ui {
namespace {

struct CheckText {
  Q_DECLARE_TR_FUNCTIONS(cusp::ui::Checks)
};

QString mm(double value) { return format({value, {}, QStringLiteral("mm"), 2}); }

/// What names a finding's parts besides the finding.
struct OwnNames {
  const Region* whole;
  const TissueNames& tissues;
};

QString tissue_of(const Finding& f, const OwnNames& own) {
  if (f.detail == "region") return CheckText::tr("a region");
  const auto tissue = scenario_tissue_from_key(f.detail);
  return tissue ? tissue_name(*tissue, own.tissues) : QString::fromStdString(f.detail);
}

QString language_of(const Finding& f) {
  if (f.detail == "en") return CheckText::tr("English");
  if (f.detail == "de") return CheckText::tr("German");
  return language_name(QString::fromStdString(f.detail));
}

/// Name of the number at `path`; empty if it has none.
QString figure_name(const std::string& path) {
  const auto ends = [&](const char* with) { return path.ends_with(with); };
  if (ends("/stiffness_n_per_mm")) return CheckText::tr("The stiffness of a tissue");
  if (ends("/speed_mm_s")) return CheckText::tr("The removal speed of a tissue");
  if (path.starts_with("/instruments/")) return CheckText::tr("A measure of a bur");
  if (ends("/full_force_n")) return CheckText::tr("The force at which cutting is fastest");
  if (ends("/tool_tilt_deg")) return CheckText::tr("The tilt of the handpiece");
  if (ends("/tool_turn_deg")) return CheckText::tr("The turn of the handpiece");
  if (ends("/width_mm")) return CheckText::tr("The target’s width");
  if (ends("/depth_mm") && path.starts_with("/target")) return CheckText::tr("The target’s depth");
  if (path.find("/taper_deg/") != std::string::npos) return CheckText::tr("The lean of a wall");
  if (ends("/corner_radius_mm")) return CheckText::tr("The corner radius");
  if (path.starts_with("/leeway/")) return CheckText::tr("The tolerance zone");
  if (ends("/time_s")) return CheckText::tr("The time limit");
  if (ends("/expected_time_s")) return CheckText::tr("The expected time");
  if (ends("/pass")) return CheckText::tr("The pass mark");
  if (ends("/weight")) return CheckText::tr("The points of a criterion");
  if (ends("/voxel_mm")) return CheckText::tr("The fineness");
  return {};
}

QString range_message(const Finding& f, double value, double least, double most) {
  const QString name = figure_name(f.path);
  const NumberRange* range = range_of(f.path);
  const QString unit = range ? unit_text(QString::fromUtf8(range->unit.data(), static_cast<qsizetype>(range->unit.size()))) : QString();
  const auto shown = [&](double v) {
    return isolate(installed_locale().toString(v, 'g', 6) + (unit.isEmpty() ? QString() : QChar(0x00A0) + unit));
  };
  return CheckText::tr("%1 is %2; it has to lie between %3 and %4.")
      .arg(name.isEmpty() ? isolate(QString::fromStdString(f.path)) : name, shown(value), shown(least), shown(most));
}

/// Message of a finding of scenarios/checks; empty for any other.
QString exercise_message(const Finding& f, const OwnNames& own, double value, double limit) {
  const QString& c = QString::fromStdString(f.code);
  const bool title = f.path.starts_with("/title");
  if (c == u"target_holds_pulp") {
    return CheckText::tr("The target holds %1 of pulp, as the access to a root canal does. If that is not meant, raise its floor.")
        .arg(format({value, {}, QStringLiteral("mm3"), 1}));
  }
  if (c == u"pulp_rule_off") return CheckText::tr("Opening the pulp does not fail the attempt. Switch that on unless it is meant so.");
  if (c == u"target_cuts_protected") return CheckText::tr("The target takes %1, which is protected.").arg(tissue_of(f, own));
  if (c == u"leeway_cuts_protected") return CheckText::tr("The tolerance zone reaches %1, which is protected.").arg(tissue_of(f, own));
  if (c == u"target_without_tissue") return CheckText::tr("The target holds nothing that could be cut.");
  if (c == u"target_uncuttable") return CheckText::tr("The target holds %1, which cannot be cut.").arg(tissue_of(f, own));
  if (c == u"idle_earns") {
    return CheckText::tr("An attempt that cuts nothing gets %1 points. Grade how much of the target is removed.").arg(format_points(value));
  }
  if (c == u"token_passes") {
    return CheckText::tr("An attempt that cuts a twentieth of the target passes, with %1 points. Grade how much of the target is removed.")
        .arg(format_points(value));
  }
  if (c == u"token_earns") {
    return CheckText::tr("An attempt that cuts a twentieth of the target gets %1 points. Give full points for the target only where most of it is removed.")
        .arg(format_points(value));
  }
  if (c == u"target_fails" && !f.detail.empty()) {
    return CheckText::tr("An attempt that cuts the target and nothing else fails: %1.").arg(critical_name(f.detail));
  }
  if (c == u"target_fails") {
    return CheckText::tr("An attempt that cuts the target and nothing else gets %1 points, and the pass mark is %2. Fit the bands to the target.")
        .arg(format_points(value), format_points(limit));
  }
  if (c == u"criterion_unmeasured") {
    return CheckText::tr("%1 cannot be measured on this tooth with this target, so nobody would be graded by it. Remove it, or change tooth or target.")
        .arg(metric_name(f.detail, own.whole, own.tissues));
  }
  if (c == u"weight_vanishes") {
    return CheckText::tr("%1 brings less than a twentieth of a point. Give it more, or remove it.").arg(metric_name(f.detail, own.whole, own.tissues));
  }
  if (c == u"text_of_template") {
    return title ? CheckText::tr("The title in %1 is still that of the exercise it was copied from.").arg(language_of(f))
                 : CheckText::tr("The briefing in %1 is still that of the exercise it was copied from.").arg(language_of(f));
  }
  if (c == u"text_other_tooth") {
    return CheckText::tr("The title in %1 names tooth %2; the exercise is on tooth %3.")
        .arg(language_of(f), format_number(value, 0), format_number(limit, 0));
  }
  if (c == u"text_figure") {
    return CheckText::tr("The briefing in %1 names %2, which the target no longer has.").arg(language_of(f), mm(value));
  }
  return {};
}

double arg_of(const Finding& f, const char* key) {
  const auto it = f.args.find(key);
  return it == f.args.end() ? 0.0 : it->second;
}

/// Message of a finding about the target; empty for any other.
QString target_message(const Finding& f, const OwnNames& own, double value, double limit) {
  const QString c = QString::fromStdString(f.code);
  if (c == u"no_target" || c == u"empty_target") return CheckText::tr("There is no target to cut.");
  if (c == u"no_direction") return CheckText::tr("A shape of the target has no direction: an axis has no length, or two are parallel.");
  if (c == u"target_tissue_missing") return CheckText::tr("The target is made of %1, which this tooth does not have.").arg(tissue_of(f, own));
  if (c == u"lesion_missing") return CheckText::tr("The target follows a carious lesion, and this tooth has none.");
  if (c == u"target_endless") return CheckText::tr("The target has no end on a side. Cut it with a shape that has one.");
  if (c == u"nothing_protected") return CheckText::tr("Damage of a protected part fails the attempt, and nothing is protected.");
  if (c == u"path_count" || c == u"point_count") return CheckText::tr("The target’s points do not fit its shape.");
  if (c == u"protected_missing") return CheckText::tr("%1 is protected, but this tooth has none.").arg(tissue_of(f, own));
  if (c == u"protected_twice") {
    return CheckText::tr("%1 is protected twice: what is removed of it counts twice. Take one of the two out of the file.").arg(tissue_of(f, own));
  }
  if (c == u"target_outside") {
    return CheckText::tr("The target reaches out of the tooth: to %1, where the tooth ends at %2.").arg(mm(value), mm(limit));
  }
  if (c == u"feature_thin") {
    return CheckText::tr("%1 is too thin to be judged at this fineness; from %2 it can.").arg(mm(value), mm(limit));
  }
  if (c == u"corner_below_bur") {
    return CheckText::tr("The corner radius %1 is sharper than the smallest bur leaves it (%2).").arg(mm(value), mm(limit));
  }
  if (c == u"leeway_below_voxel") {
    return CheckText::tr("The tolerance zone of %1 is finer than the tooth is known (%2).").arg(mm(value), mm(limit));
  }
  if (c == u"wall_of_other_side") {
    return CheckText::tr("A mesial or distal wall of the target stands on the other side of this tooth. Draw the target anew, or choose the tooth’s right number.");
  }
  if (c == u"sides_unknown") {
    return CheckText::tr("The target names mesial and distal walls, and the file does not state where mesial lies. Choose the tooth’s number and propose landmarks.");
  }
  if (c == u"point_off_floor") return CheckText::tr("A point of the target does not lie on its floor.");
  if (c == u"target_scores_less") {
    return CheckText::tr("An attempt that meets the target exactly loses %1 points for %2.")
        .arg(format_points(arg_of(f, "lost")), metric_name(f.detail, own.whole, own.tissues));
  }
  if (c == u"target_opens_pulp") {
    return f.detail == "horn"
               ? CheckText::tr("The target opens the pulp by %1. Raise its floor, or draw it clear of the pulp.").arg(mm(value))
               : CheckText::tr("The target reaches into the pulp, and opening it fails the attempt: nobody could pass.");
  }
  if (c == u"leeway_opens_pulp") {
    return CheckText::tr("The tolerance zone reaches the pulp: it lies %1 from the target.").arg(mm(value));
  }
  return {};
}

/// Message of a finding about burs and handpieces; empty for any other.
QString tool_message(const Finding& f, const OwnNames& own, double value, double limit) {
  const QString c = QString::fromStdString(f.code);
  const QString name = QString::fromStdString(f.detail);
  if (c == u"no_instrument") return CheckText::tr("There is no bur to work with. Add one.");
  if (c == u"bur_not_of_number") {
    return CheckText::tr("The catalogue’s bur %1 has another shape or diameter (%2). Add it from the catalogue again, or change its diameter.").arg(name, mm(limit));
  }
  if (c == u"bur_small") {
    return CheckText::tr("Bur %1 is too small for this fineness: its diameter is %2, from %3 it cuts truly.")
        .arg(name, mm(2 * value), mm(2 * limit));
  }
  if (c == u"head_short") {
    return CheckText::tr("The head of bur %1 is too short for this fineness: %2 long, from %3 it cuts truly.")
        .arg(name, mm(value), mm(limit));
  }
  if (c == u"neck_wider_than_ball") return CheckText::tr("The neck of bur %1 is wider than its head.").arg(name);
  if (c == u"bur_wider_than_target") {
    return CheckText::tr("No bur fits: the smallest is %1 wide, the target %2.").arg(mm(value), mm(limit));
  }
  if (c == u"bur_short") {
    return CheckText::tr("No bur reaches the floor: the longest cuts %1 deep before its shank touches, and the target is %2 deep.").arg(mm(value), mm(limit));
  }
  if (c == u"two_spindles") return CheckText::tr("Only one handpiece can be used at a time.");
  if (c == u"spindle_missing") {
    return f.detail == "sound" ? CheckText::tr("The drilling sound needs a handpiece.")
                               : CheckText::tr("Vibration needs a handpiece.");
  }
  if (c == u"heat_missing") {
    return CheckText::tr("%1 is graded, but this exercise does not reckon coolant and heat.").arg(metric_name(f.detail, own.whole, own.tissues));
  }
  return {};
}

}  // namespace

QString check_message(const Finding& f, const Region* whole, const TissueNames& tissues) {
  const OwnNames own{whole, tissues};
  const QString c = QString::fromStdString(f.code);
  const double value = arg_of(f, "value"), limit = arg_of(f, "limit");
  if (c == u"out_of_range" && f.args.contains("least")) return range_message(f, value, arg_of(f, "least"), arg_of(f, "most"));
  for (const auto message : {exercise_message, target_message, tool_message})
    if (const QString found = message(f, own, value, limit); !found.isEmpty()) return found;
  if (c == u"critical_twice") {
    return CheckText::tr("%1 stands twice among what fails the attempt. Switch it off and on again.").arg(metric_name(f.detail, whole, tissues));
  }
  if (c == u"ridge_of_plastic") {
    return CheckText::tr("%1 cannot be measured where tooth and neighbours are of plastic: both are one material. Remove it, or the neighbours.")
        .arg(metric_name(f.detail, whole, tissues));
  }
  if (c == u"no_criteria") return CheckText::tr("Nothing is graded yet. Add a criterion.");
  if (c == u"target_missing") return CheckText::tr("%1 is of a target that this exercise does not have. Remove it.").arg(metric_name(f.detail, whole, tissues));
  if (c == u"weight_zero") return CheckText::tr("%1 has no points. Give it some, or remove it.").arg(metric_name(f.detail, whole, tissues));
  if (c == u"bands_not_ordered") {
    return CheckText::tr("The bands of %1 are not in rising order.").arg(metric_name(f.detail, whole, tissues));
  }
  if (c == u"bands_without_edge") {
    return CheckText::tr("%1 earns its points whatever is measured. Set what earns them, or remove it.").arg(metric_name(f.detail, whole, tissues));
  }
  if (c == u"pass_unreachable") {
    return CheckText::tr("The pass mark %1 is out of reach: at most %2 points can be had.")
        .arg(format_points(value), format_points(limit));
  }
  if (c == u"tissue_missing") return CheckText::tr("The tooth holds %1, which this exercise does not describe.").arg(tissue_of(f, own));
  if (c == u"tissue_unused") return CheckText::tr("%1 is described, but this tooth has none.").arg(tissue_of(f, own));
  if (c == u"voxel_mismatch") {
    return CheckText::tr("The file’s fineness is %2, not %1 as stated.").arg(mm(value), mm(limit));
  }
  if (c == u"language_missing") {
    if (f.path.starts_with("/target")) return CheckText::tr("The name of a target is missing in %1.").arg(language_of(f));
    return f.path == "/title" ? CheckText::tr("The title is missing in %1.").arg(language_of(f))
                              : CheckText::tr("The briefing is missing in %1.").arg(language_of(f));
  }
  if (c == u"expected_beyond_limit")
    return CheckText::tr("The expected time, %1, is longer than the time limit, %2.").arg(duration_text(value), duration_text(limit));
  if (c == u"tooth_turned") {
    return CheckText::tr("The tooth lies %1 degrees off its frame. Beyond %2 nobody knows its mesial side: turn the file.")
        .arg(format_number(value, 0), format_number(limit, 0));
  }
  if (c == u"tooth_tilted") {
    return CheckText::tr("The tooth’s long axis leans by %1 degrees, at most %2 are usual: turn the file.")
        .arg(format_number(value, 0), format_number(limit, 0));
  }
  if (c == u"landmark_outside") return CheckText::tr("A landmark does not lie on the tooth. It may be another file’s.");
  if (c == u"nothing_can_be_cut") return CheckText::tr("Nothing of this tooth can be cut.");
  return CheckText::tr("Something is wrong at %1.").arg(isolate(QString::fromStdString(f.path)));
}

EditorPlace place_of(const Finding& f) {
  const std::string& p = f.path;
  if (p.starts_with("/title") || p.starts_with("/briefing") || p == "/level" || p == "/expected_time_s") return EditorPlace::title;
  if (p.starts_with("/instruments")) return EditorPlace::burs;
  if (p.starts_with("/rubric") || p == "/self_assessment") return EditorPlace::points;
  const bool figure = p.ends_with("/stiffness_n_per_mm") || p.ends_with("/speed_mm_s") || f.code == "nothing_can_be_cut";
  if (p.starts_with("/phenomena") || p.starts_with("/device/tool_") || (p.starts_with("/tissues") && figure)) return EditorPlace::tissues;
  if (p.starts_with("/specimen") || p.starts_with("/tissues") || p.starts_with("/protected")) return EditorPlace::tooth;
  return EditorPlace::shape;
}

}  // namespace cusp::ui
