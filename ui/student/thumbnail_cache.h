/// Pictures of exercises' teeth, drawn in the background and kept in the cache folder under the exercise's content hash.
/// GUI thread; the drawing has one of its own.
#pragma once

#include <QHash>
#include <QImage>
#include <QObject>
#include <QSet>
#include <QThreadPool>
#include <atomic>
#include <filesystem>
#include <memory>

#include "ui/student/exercises.h"

namespace cusp::ui {

class ThumbnailCache : public QObject {
  Q_OBJECT

 public:
  enum class Use { card, cover };  // with the target on it, coarse, for lists; the bare tooth, for the sign-in

  explicit ThumbnailCache(std::filesystem::path cache, QObject* parent = nullptr);
  /// Gives up the picture that is being drawn, and does not wait for it to grow.
  ~ThumbnailCache() override;

  /// The picture in the present theme, or a null image where none was drawn yet.
  QImage kept(const Exercise& exercise, Use use) const;
  /// The same; a null image is being drawn, and ready() comes. Where there is no OpenGL it never comes.
  QImage picture(const Exercise& exercise, const std::filesystem::path& folder, Use use);
  /// Gives up all that waits or is being drawn: an attempt needs the processor. The next picture() begins again.
  void stop();

 Q_SIGNALS:
  void ready();

 private:
  QString file_of(const QString& name) const;

  std::filesystem::path cache_;
  std::shared_ptr<std::atomic<bool>> stopped_ = std::make_shared<std::atomic<bool>>(false);  // of the pictures asked since
  QThreadPool pool_;
  QSet<QString> asked_;
  QHash<QString, QImage> without_file_;  // of this run: a full disk or a folder that cannot be written took none
};

}  // namespace cusp::ui
