/// Bytes to a file that is written beside its name and renamed: no half file is left. Thread: any.
#pragma once

#include <QByteArray>
#include <QString>
#include <cstdint>
#include <functional>

#include "engine/base/result.h"

namespace cusp::ui {

/// Who may read the file: whom the umask lets, or the file that is replaced; or its owner alone.
enum class Readers : std::uint8_t { usual, owner };

/// A failure leaves what was there before, and gives the cause: "No space left on device". A stick's file system may know no owner.
/// `before_named` is called once all is written; false: nothing is left of it, and there is no cause to give.
Result<void, QString> save_bytes(const QString& path, const QByteArray& bytes, Readers readers = Readers::usual, const std::function<bool()>& before_named = {});

}  // namespace cusp::ui
