/// What went wrong in any room, put into words: what happened, where, what was kept, and one way out. Needs no window.
#pragma once

#include <QString>

#include "engine/base/haptic_port.h"
#include "engine/loop/realtime.h"
#include "engine/step/step.h"
#include "scenarios/format/format_error.h"
#include "scenarios/import/import_error.h"
#include "storage/base/error.h"
#include "ui/modules.h"
#include "ui/session/exercise_run.h"

namespace cusp::ui {

/// A failure as people read it: one bold sentence, and what else there is to know.
struct Told {
  QString what;
  QString more;
  QString line() const { return more.isEmpty() ? what : what + u' ' + more; }
};

Told tell(const StorageFailure& failure);
/// What a person was asked for.
enum class Secret : std::uint8_t { password, pin };
/// Of signing in, of making an account and of changing one: names the person's number, never the database's file.
Told tell_account(const StorageFailure& failure, const QString& number, Secret asked);
Told tell(const FormatFailure& failure);
Told tell(const ImportFailure& failure);
Told tell(const PortFailure& failure);
Told tell(const RunFailure& failure);
Told tell(Fault fault);
/// How the loop of a device stands among other programs.
Told tell(const RealtimeGrant& grant);

}  // namespace cusp::ui
