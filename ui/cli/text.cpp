#include "ui/cli/text.h"

#include <optional>

#include "scenarios/format/keys.h"
#include "storage/base/clock.h"
#include "ui/modules.h"
#include "ui/text/failure_text.h"

namespace cusp::ui {

namespace {

QString text(const std::string& s) { return QString::fromStdString(s); }

QString number(const std::map<std::string, double>& args, const char* key) {
  const auto it = args.find(key);
  return it == args.end() ? QString() : QString::number(it->second, 'g', 6);
}

std::optional<FormatError> format_error(const std::string& code) {
  for (int i = 0; i <= static_cast<int>(FormatError::unwritable); ++i) {
    if (key_of(static_cast<FormatError>(i)) == code) return static_cast<FormatError>(i);
  }
  return std::nullopt;
}

QString tissue_of(const Finding& f, const TissueNames& own) {
  if (f.detail == "region") return CliText::tr("a region");
  const auto tissue = scenario_tissue_from_key(f.detail);
  return tissue ? tissue_name(*tissue, own) : text(f.detail);
}

/// Of a finding of scenarios/checks; empty for any other.
QString reason_of_checks(const Finding& f, const TissueNames& own) {
  const std::string& c = f.code;
  if (c == "target_opens_pulp") return CliText::tr("the target opens the pulp");
  if (c == "target_holds_pulp") return CliText::tr("the target holds pulp, as the access to a root canal does");
  if (c == "pulp_rule_off") return CliText::tr("opening the pulp does not fail the attempt");
  if (c == "leeway_opens_pulp") return CliText::tr("the tolerance zone reaches the pulp");
  if (c == "target_cuts_protected") return CliText::tr("the target takes a protected tissue (%1)").arg(tissue_of(f, own));
  if (c == "leeway_cuts_protected") return CliText::tr("the tolerance zone reaches a protected tissue (%1)").arg(tissue_of(f, own));
  if (c == "target_without_tissue") return CliText::tr("the target holds nothing that could be cut");
  if (c == "target_uncuttable") return CliText::tr("the target holds a tissue that cannot be cut (%1)").arg(tissue_of(f, own));
  if (c == "idle_earns") return CliText::tr("an attempt that cuts nothing earns points");
  if (c == "token_passes") return CliText::tr("an attempt that cuts a twentieth of the target passes");
  if (c == "token_earns") return CliText::tr("an attempt that cuts a twentieth of the target earns points");
  if (c == "target_fails") return CliText::tr("an attempt that cuts the target and nothing else does not pass");
  if (c == "criterion_unmeasured") return CliText::tr("%1 cannot be measured on this specimen with this target").arg(text(f.detail));
  if (c == "text_of_template") return CliText::tr("the text is still that of the exercise it was copied from (%1)").arg(text(f.detail));
  if (c == "text_other_tooth") return CliText::tr("the title names another tooth (%1)").arg(text(f.detail));
  if (c == "text_figure") return CliText::tr("the text names a length that the target has not (%1)").arg(text(f.detail));
  return {};
}

/// Of a finding about burs, handpieces and heat; empty for any other.
QString reason_of_tools(const Finding& f) {
  const std::string& c = f.code;
  if (c == "bur_not_of_number") return CliText::tr("the catalogue’s bur %1 has another shape or diameter").arg(text(f.detail));
  if (c == "no_instrument") return CliText::tr("it has no instrument");
  if (c == "bur_small") return CliText::tr("a bur’s radius is below 3 voxels");
  if (c == "head_short") return CliText::tr("a bur’s head is shorter than 6 voxels");
  if (c == "neck_wider_than_ball") return CliText::tr("a bur’s neck is wider than its ball");
  if (c == "bur_wider_than_target") return CliText::tr("no bur fits into the target");
  if (c == "bur_short") return CliText::tr("no bur reaches the floor before its shank touches");
  if (c == "two_spindles") return CliText::tr("only one handpiece can be used at a time");
  if (c == "spindle_missing") return CliText::tr("vibration and sound need a handpiece (%1)").arg(text(f.detail));
  if (c == "heat_missing") return CliText::tr("%1 is graded, and the exercise does not reckon coolant and heat").arg(text(f.detail));
  return {};
}

QString reason(const Finding& f, const TissueNames& own) {
  const std::string& c = f.code;
  if (const QString found = reason_of_checks(f, own); !found.isEmpty()) return found;
  if (const QString found = reason_of_tools(f); !found.isEmpty()) return found;
  if (c == "no_target") return CliText::tr("it has no target");
  if (c == "path_count" || c == "point_count") return CliText::tr("the target’s path does not fit its shape");
  if (c == "empty_target") return CliText::tr("the target is empty");
  if (c == "no_direction") return CliText::tr("a shape of the target has no direction");
  if (c == "target_endless") return CliText::tr("the target has no end on a side");
  if (c == "target_tissue_missing") return CliText::tr("the target is made of a tissue that the tooth does not have (%1)").arg(tissue_of(f, own));
  if (c == "lesion_missing") return CliText::tr("the target follows a carious lesion, and the tooth has none");
  if (c == "nothing_protected") return CliText::tr("damage of a protected part fails the attempt, and nothing is protected");
  if (c == "critical_twice") return CliText::tr("%1 is named twice among what fails the attempt").arg(text(f.detail));
  if (c == "ridge_of_plastic") return CliText::tr("%1 cannot be measured where tooth and neighbours are of one plastic").arg(text(f.detail));
  if (c == "no_criteria") return CliText::tr("the rubric has no criterion");
  if (c == "weight_zero") return CliText::tr("%1 brings no points").arg(text(f.detail));
  if (c == "weights_zero") return CliText::tr("no criterion brings points");
  if (c == "target_missing") return CliText::tr("%1 is of a target that the exercise does not have").arg(text(f.detail));
  if (c == "bands_not_ordered") return CliText::tr("the bands are not in rising order");
  if (c == "pass_unreachable") return CliText::tr("the pass mark cannot be reached");
  if (c == "protected_missing") return CliText::tr("a protected tissue is missing (%1)").arg(tissue_of(f, own));
  if (c == "protected_twice") return CliText::tr("%1 is protected twice, and what is removed of it counts twice").arg(tissue_of(f, own));
  if (c == "tissue_missing") return CliText::tr("the specimen holds a tissue that is not described (%1)").arg(tissue_of(f, own));
  if (c == "tissue_unused") return CliText::tr("a tissue does not occur in the specimen (%1)").arg(tissue_of(f, own));
  if (c == "target_outside") return CliText::tr("the target lies outside the specimen");
  if (c == "voxel_mismatch") return CliText::tr("the volume’s voxels are not of the size that is stated");
  if (c == "wall_of_other_side") return CliText::tr("a mesial or distal wall of the target stands on the other side of this tooth");
  if (c == "sides_unknown") return CliText::tr("the target names mesial and distal walls, and the file does not state where mesial lies");
  if (c == "feature_thin") return CliText::tr("a feature is thinner than 2.5 voxels and cannot be judged");
  if (c == "corner_below_bur") return CliText::tr("the target’s corners are sharper than the smallest bur");
  if (c == "leeway_below_voxel") return CliText::tr("the tolerance zone is thinner than a voxel");
  if (c == "point_off_floor") return CliText::tr("points of the path do not lie on the floor");
  if (c == "target_scores_less") return CliText::tr("an attempt that meets the target loses points");
  if (c == "bands_without_edge") return CliText::tr("%1 earns full points whatever is measured").arg(text(f.detail));
  if (c == "language_missing") return CliText::tr("a text is missing in a language (%1)").arg(text(f.detail));
  if (c == "expected_beyond_limit") return CliText::tr("the expected time is longer than the time limit");
  if (c == "weight_vanishes") return CliText::tr("a criterion brings less than a twentieth of a point");
  if (c == "tooth_turned") return CliText::tr("the tooth is turned from its frame");
  if (c == "tooth_tilted") return CliText::tr("the tooth is tilted");
  if (c == "landmark_outside") return CliText::tr("a landmark does not lie on the tooth (%1)").arg(text(f.detail));
  if (c == "nothing_can_be_cut") return CliText::tr("nothing can be cut");
  if (c == "schema") return text(f.detail);
  return text(c);
}

}  // namespace

QString finding_text(const Finding& f, const TissueNames& own) {
  if (const auto code = format_error(f.code)) {
    return describe(FormatFailure{*code, f.path, f.detail}).line();
  }
  QString out = f.path.empty() ? reason(f, own) : text(f.path) + QStringLiteral(": ") + reason(f, own);
  const QString value = number(f.args, "value");
  const QString limit = number(f.args, "limit");
  if (!value.isEmpty() && !limit.isEmpty()) return CliText::tr("%1 (%2, limit %3).").arg(out, value, limit);
  if (!value.isEmpty()) return CliText::tr("%1 (%2).").arg(out, value);
  return out + u'.';
}

QString no_plan_text(const Scenario& scenario) {
  if (scenario.tool_tilt_deg == 0.0) return CliText::tr("No bur of the exercise fits into its target.");
  return CliText::tr("No bur of the exercise fits into its target while the handpiece is tilted by %1 degrees.").arg(QString::number(scenario.tool_tilt_deg));
}

QString not_computed_text(const ReplayProof& proof) {
  return CliText::tr("The record is whole. It was made by engine %1 and is not computed again by engine %2.").arg(proof.engine_version).arg(kEngineVersion);
}

}  // namespace cusp::ui
