#include "ui/widgets/save_bytes.h"

#include <QSaveFile>

namespace cusp::ui {
namespace {

/// A full disk cuts a write short, for which QSaveFile has no cause and would rename the half: the write after it names the cause.
bool write_all(QSaveFile& file, const QByteArray& bytes) {
  for (qint64 done = 0; done < bytes.size();) {
    const qint64 written = file.write(bytes.constData() + done, bytes.size() - done);
    if (written <= 0) return false;
    done += written;
  }
  return true;
}

}  // namespace

Result<void, QString> save_bytes(const QString& path, const QByteArray& bytes, Readers readers, const std::function<bool()>& before_named) {
  QSaveFile file(path);
  // Unbuffered: a failure within commit() has lost its cause.
  const bool opened = file.open(QIODevice::WriteOnly | QIODevice::Unbuffered);
  if (opened && readers == Readers::owner) file.setPermissions(QFileDevice::ReadOwner | QFileDevice::WriteOwner);
  if (opened && write_all(file, bytes)) {
    if (before_named && !before_named()) {
      file.cancelWriting();
      return std::unexpected(QString());
    }
    if (file.commit()) return {};
  }
  return std::unexpected(file.errorString());
}

}  // namespace cusp::ui
