/// Messages for failures of every module: what happened, where, what was kept, and one way out. Needs no window.
#pragma once

#include <QString>
#include <filesystem>

#include "engine/base/haptic_port.h"
#include "engine/loop/realtime.h"
#include "engine/step/step.h"
#include "scenarios/format/format_error.h"
#include "scenarios/import/import_error.h"
#include "scenarios/library/exercise_file.h"
#include "storage/base/error.h"
#include "ui/modules.h"
#include "ui/session/exercise_session.h"
#include "ui/session/operator_cut.h"

namespace cusp::ui {

/// A failure as people read it: one bold sentence, and the rest.
struct Message {
  QString what;
  QString more;
  QString line() const { return more.isEmpty() ? what : what + u' ' + more; }
};

Message describe(const StorageFailure& failure);
/// Of clock_ahead, before a question whether to go on: what the clock says, and what to do if that is wrong.
QString clock_question_text(const StorageFailure& doubt);
/// What the user was asked for.
enum class Secret : std::uint8_t { password, pin };
/// Of signing in, of making an account and of changing one: names the account's number, never the database's file.
Message describe_account(const StorageFailure& failure, const QString& number, Secret asked);
/// Of making a backup in the folder: names that where storage means its own database.
Message describe_backup_failure(const StorageFailure& failure, const std::filesystem::path& folder);
Message describe(const FormatFailure& failure);
Message describe(const ImportFailure& failure);
/// Of a finding it names the place alone; the editor and the verbs have their own text of one.
Message describe(const ExerciseFileFailure& failure);
Message describe(const PortFailure& failure);
Message describe(const SessionFailure& failure);
/// `tool_tilt_deg` of the exercise: a tilted handpiece can be why no bur fits.
Message describe(OperatorCutError error, double tool_tilt_deg);
Message describe(Fault fault);
/// How the loop of a device stands among other programs.
Message describe(const RealtimeGrant& grant);

}  // namespace cusp::ui
