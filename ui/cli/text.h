/// Text that only the verbs print. Codes of other modules have theirs in ui/text.
#pragma once

#include <QCoreApplication>
#include <QString>
#include <string>

#include "scenarios/format/validate.h"
#include "ui/modules.h"
#include "ui/session/replay.h"
#include "ui/text/incident_text.h"
#include "ui/text/names.h"

namespace cusp::ui {

struct CliText {
  Q_DECLARE_TR_FUNCTIONS(cusp::ui::Cli)
};
/// Descriptions of options are given to CLI11 as text.
inline std::string help(const QString& text) { return text.toStdString(); }

/// What is wrong with a scenario, with its place. `own`: names of the specimen's own tissues, as far as it is known.
QString finding_text(const Finding& finding, const TissueNames& own = {});
/// Why a scripted operator has nothing to do: no bur fits, held as the exercise's handpiece rests.
QString no_plan_text(const Scenario& scenario);
/// That a record of another engine was proved without being computed again. Pre: !proof.same_engine.
QString not_computed_text(const ReplayProof& proof);

}  // namespace cusp::ui
