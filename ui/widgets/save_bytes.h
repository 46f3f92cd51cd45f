/// Bytes to a file that is written beside its name and renamed: no half file is left. Thread: any.
#pragma once

#include <QByteArray>
#include <QString>

#include "engine/base/result.h"

namespace cusp::ui {

/// A failure leaves what was there before, and gives the cause: "No space left on device".
Result<void, QString> save_bytes(const QString& path, const QByteArray& bytes);

}  // namespace cusp::ui
