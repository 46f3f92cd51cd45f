#include "ui/app/run_marker.h"

#include <QCoreApplication>
#include <QDir>

namespace cusp::ui {
namespace {

constexpr const char* kEnding = ".running";

}  // namespace

RunMarker::RunMarker(const QString& folder) {
  const QDir place(folder);
  place.mkpath(QStringLiteral("."));
  for (const QString& name : place.entryList({QStringLiteral("*") + QLatin1String(kEnding)}, QDir::Files)) {
    QLockFile other(place.filePath(name));
    other.setStaleLockTime(0);  // an old one is that of a program that runs long
    found_crash_ = other.tryLock(0) || found_crash_;
  }
  own_ = std::make_unique<QLockFile>(place.filePath(QString::number(QCoreApplication::applicationPid()) + QLatin1String(kEnding)));
  own_->setStaleLockTime(0);
  const bool set = own_->tryLock(0);
  remove_at_any_end(set ? QFile::encodeName(own_->fileName()).constData() : nullptr);
}

RunMarker::~RunMarker() = default;

}  // namespace cusp::ui
