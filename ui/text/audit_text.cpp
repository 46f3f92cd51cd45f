#include "ui/text/names.h"
#include "ui/text/audit_text.h"

#include <QCoreApplication>
#include <QStringList>
#include <cmath>

#include "scenarios/format/keys.h"
#include "ui/modules.h"
#include "ui/widgets/format.h"

namespace cusp::ui {
namespace {

struct AuditText {
  Q_DECLARE_TR_FUNCTIONS(cusp::ui::Audit)
};

QString mm(double value) { return format_value({value, {}, u"mm"_qs, value * 100 == static_cast<int>(value * 100) ? 2 : 3}); }

QString around_name(const std::string& key) {
  if (key == "neighbours") return AuditText::tr("Neighbouring teeth");
  if (key == "gingiva") return AuditText::tr("Gums about the tooth");
  if (key == "bone") return AuditText::tr("Jaw bone about the tooth");
  return AuditText::tr("The rest of the jaw");
}

QString tissue_of_key(const std::string& key, const TissueNames& own) {
  const auto tissue = scenario_tissue_from_key(key);
  return tissue ? tissue_name(*tissue, own) : QString::fromStdString(key);
}

/// What was taken, as one reads it after "with".
QStringList taken(const AuditReport& report, const TissueNames& own) {
  QStringList out;
  for (const AuditStep& step : report.steps)
    if (step.taken) out.push_back(choice_name(step.choice, own));
  return out;
}

/// Where single attempts part by chance: what half the voxels change in the mean.
QString means_sentence(const AuditReport& report) {
  if (!report.at_half_voxel || report.at_half_voxel->attempts_per_operator < 2) return {};
  const GradeChange& half = *report.at_half_voxel;
  return u' ' + AuditText::tr("Single attempts differ by chance: over %1 attempts of each operator, half the voxels change the mean score by %2 ± %3 points.")
                    .arg(installed_locale().toString(half.attempts_per_operator), format_number(std::abs(half.score), 1), format_number(half.standard_error, 1));
}

/// Whether other sizes were tried, and each of them too grades otherwise at its half or beside the exercise.
bool every_size_fails(const AuditReport& report) {
  bool tried = false;
  for (const AuditStep& step : report.steps) {
    if (step.choice.aspect != Aspect::voxel) continue;
    if (step.change.within(report.tolerance_points)) return false;
    tried = true;
  }
  return tried;
}

/// What half the voxels change; empty if they grade the same, or if nothing is known of them.
QString half_sentence(const AuditReport& report) {
  if (report.detail_holds()) return {};
  const GradeChange& half = *report.at_half_voxel;
  QString out;
  if (!half.measures_alike) {
    out = AuditText::tr("Half the voxels change which criteria can be measured.");
  } else if (!half.passes_alike) {
    out = AuditText::tr("Half the voxels change whether an attempt passes, or a critical event.");
  } else if (std::abs(half.score) > report.tolerance_points) {
    out = AuditText::tr("Half the voxels change a score by %1 points, more than the %2 that the exercise allows.")
              .arg(format_number(std::abs(half.score), 1), format_points(report.tolerance_points));
  } else {
    out = AuditText::tr("Half the voxels may change a score by more than the %1 points that the exercise allows.")
              .arg(format_points(report.tolerance_points));
  }
  return every_size_fails(report) ? out + u' ' + AuditText::tr("No other size that was tried holds.") : out;
}

}  // namespace

QString choice_name(const Choice& c, const TissueNames& own) {
  switch (c.aspect) {
    case Aspect::voxel: return AuditText::tr("Detail of %1").arg(mm(c.instead));
    case Aspect::band: return AuditText::tr("Surface band halved");
    case Aspect::region: return AuditText::tr("Only near the target");
    case Aspect::around: return AuditText::tr("%1 left out").arg(around_name(c.subject));
    case Aspect::tissue: return AuditText::tr("%1 left out").arg(tissue_of_key(c.subject, own));
    case Aspect::friction: return AuditText::tr("Friction left out");
    case Aspect::spindle: return AuditText::tr("Handpiece left out");
    case Aspect::vibration: return AuditText::tr("Vibration left out");
    case Aspect::heat: return AuditText::tr("Heat left out");
    case Aspect::tilt: return AuditText::tr("Tilting of the handpiece left out");
  }
  return {};
}

QString verdict_name(Verdict verdict) {
  switch (verdict) {
    case Verdict::needed: return AuditText::tr("needed");
    case Verdict::not_needed: return AuditText::tr("not needed");
    case Verdict::shown: return AuditText::tr("same score");
    case Verdict::unplayable: return AuditText::tr("cannot be played");
    case Verdict::unresolved: return AuditText::tr("too coarse");
  }
  return {};
}

QString leanest_sentence(const AuditReport& report, const TissueNames& own) {
  const QString half = half_sentence(report);
  if (!report.changed() && !half.isEmpty()) return half + means_sentence(report);
  if (!report.changed())
    return AuditText::tr("Nothing can be left out: the exercise is as lean as its scores allow (within %1 points).")
               .arg(format_points(report.tolerance_points)) +
           means_sentence(report);
  const QString what = taken(report, own).join(u", "_qs);
  const bool finer = report.leanest.specimen.voxel_mm < report.scenario.specimen.voxel_mm;
  const QString finding = finer ? AuditText::tr("The detail was too coarse for its scores; now half the voxels change none by more than %1 points: %2.")
                              : AuditText::tr("Every attempt keeps its score within %1 points: %2.");
  QString out = finding.arg(format_points(report.tolerance_points), what);
  if (report.leanest_result) {
    const ModelCost &was = report.as_set.cost, &is = report.leanest_result->cost;
    out += u' ' + AuditText::tr("An update takes %1 µs instead of %2, the tooth %3 MB instead of %4.")
                      .arg(format_number(is.us_a_tick, 0), format_number(is.us_a_tick - is.us_more, 0),
                           format_number(static_cast<double>(is.bytes) / 1e6, 0), format_number(static_cast<double>(was.bytes) / 1e6, 0));
  }
  if (!half.isEmpty()) out += u' ' + half;
  return out + means_sentence(report) + u' ' + AuditText::tr("One thing after another was tried: a leaner set may exist.");
}

Message describe(const AuditFailure& failure) {
  if (failure.code == AuditError::cancelled) return {AuditText::tr("The audit was stopped."), AuditText::tr("Nothing was changed.")};
  if (failure.code == AuditError::no_path)
    return {AuditText::tr("A scripted operator cannot reach the target (%1), so nothing can be measured.").arg(operator_name(failure.where)),
            AuditText::tr("Look at its checks first.")};
  return {AuditText::tr("The exercise cannot be played as it stands (%1).").arg(QString::fromStdString(failure.where)),
          AuditText::tr("Look at its checks first.")};
}

}  // namespace cusp::ui
