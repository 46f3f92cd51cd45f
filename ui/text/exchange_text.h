/// Text for files between stations: what they carry, what reading one did, and whose key is trusted. Needs no window.
#pragma once

#include <QStringList>

#include "storage/exchange/exchange.h"
#include "ui/modules.h"
#include "ui/text/failure_text.h"

namespace cusp::ui {

/// "3 attempts, 12 people and 2 exercises"; what is none is left out. "nothing" if all are none.
QString counts_text(const ExchangeCounts& counts);
/// "Results", "People, cohorts, assignments and exercises".
QString exchange_kind_name(ExchangeKind kind);
/// "station", "office", "former key", "revoked".
QString key_role_name(KeyRole role);

/// What reading did, in one sentence: it is new, it was read before, or it came late.
QString outcome_text(ReadOutcome outcome);
/// What was new, what waits, and each account that was changed at both places, a sentence each.
QStringList read_in_text(const ReadIn& read);

/// Before students who left are erased: what other stations may know of them, and what an erasure here means. Empty: none is known.
QString departed_elsewhere_text(const std::vector<OtherKey>& known);

/// Of giving out, looking into or reading in a file, and of giving out an appeal pack: names the file where storage means its own database.
Message describe_exchange_failure(const StorageFailure& failure, const QString& file);

/// Of reading a station's key from a file.
Message describe_key_failure(const StorageFailure& failure, const QString& file);

}  // namespace cusp::ui
