/// Pictures of exercises' teeth, drawn in the background and kept in the cache folder under the exercise's content hash.
/// GUI thread; the drawing has one of its own.
#pragma once

#include <QImage>
#include <QObject>
#include <QSet>
#include <QThreadPool>
#include <atomic>
#include <filesystem>

#include "ui/student/exercises.h"

namespace cusp::ui {

class ThumbnailCache : public QObject {
  Q_OBJECT

 public:
  enum class Use { card, cover };  // with the target on it, for lists; the bare tooth, for the sign-in

  explicit ThumbnailCache(std::filesystem::path cache, QObject* parent = nullptr);
  /// Gives up the picture that is being drawn, and does not wait for it to grow.
  ~ThumbnailCache() override;

  /// The picture in the present theme, or a null image: then it is being drawn, and ready() comes. Where there is no OpenGL it never comes.
  QImage picture(const Exercise& exercise, const std::filesystem::path& folder, Use use);

 Q_SIGNALS:
  void ready();

 private:
  std::filesystem::path cache_;
  std::atomic<bool> closing_{false};
  QThreadPool pool_;
  QSet<QString> asked_;
};

}  // namespace cusp::ui
