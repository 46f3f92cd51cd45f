/// Bytes to a file that is written beside its name and renamed: no half file is left. Thread: any.
#pragma once

#include <QByteArray>
#include <QString>
#include <cstdint>

#include "engine/base/result.h"

namespace cusp::ui {

/// Who may read the file: whom the umask lets, or the file that is replaced; or its owner alone.
enum class Readers : std::uint8_t { usual, owner };

/// A failure leaves what was there before, and gives the cause: "No space left on device". A stick's file system may know no owner.
Result<void, QString> save_bytes(const QString& path, const QByteArray& bytes, Readers readers = Readers::usual);

}  // namespace cusp::ui
