/// Draws a ToothPicture into images on a thread of low priority, one frame at a time. The window copies them: composing it
/// with OpenGL costs software more than the tooth. A context that the graphics card has lost is made anew.
/// Thread: GUI; Drawn is called on the painter's.
#pragma once

#include <QImage>
#include <QSize>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "ui/render/patch_feed.h"
#include "ui/render/tooth_picture.h"
#include "ui/view/paint_context.h"

class QThread;

namespace cusp::ui {

/// What a frame shows. What is nullopt stays as it was in the frame before.
struct FrameOrder {
  Scene3d scene;
  QSize size_px;
  int mesh = 0;                               // number of the mesh; another one than before begins empty
  std::vector<BakedPatch> patches;            // to put first
  std::shared_ptr<PatchFeed> feed;            // then what waits there, a bounded number of bytes after the first frame; may be null
  std::optional<std::shared_ptr<const SceneryLook>> scenery;
  std::optional<std::vector<OverlayLine>> lines;
  std::optional<SurfaceMarks> marks;
  std::optional<SectionImage> section;
  QImage spare;                               // reused where its size fits
};

struct FinishedFrame {
  QImage image;  // smaller than ordered beyond OpenGL's limits; null: drawing failed
  QString why;   // then the OpenGL call that failed
  int mesh = 0;
  bool lost = false;            // no image: the next order has to hold everything, for another context
  std::vector<BakedPatch> fed;  // taken from the feed
  TickTimes changes;            // that this frame shows first
  bool more = false;            // further patches wait in the feed
  double draw_ms = 0;           // uploading, drawing and reading back
  bool in_software = false;     // no graphics card drew it
};

class ViewPainter {
 public:
  using Drawn = std::function<void(FinishedFrame frame)>;  // on the painter's thread

  /// nullptr where the platform has no OpenGL, or forbid_opengl() was called.
  static std::unique_ptr<ViewPainter> create(Drawn drawn);
  ViewPainter(Drawn drawn, std::unique_ptr<PaintContext> context);
  /// Waits for the frame in work.
  ~ViewPainter();
  ViewPainter(const ViewPainter&) = delete;
  ViewPainter& operator=(const ViewPainter&) = delete;

  /// Pre: every order before has been answered.
  void draw(FrameOrder order);

 private:
  class Canvas;
  void run();
  FinishedFrame draw_in(std::optional<Canvas>& canvas, FrameOrder& order);
  bool make_context();
  std::optional<FrameOrder> next_order();

  Drawn drawn_;
  std::unique_ptr<PaintContext> context_;
  int losses_ = 0;  // of contexts since the newest image
  std::unique_ptr<QThread> thread_;
  std::mutex mutex_;  // guards what follows
  std::condition_variable wake_;
  std::optional<FrameOrder> order_;
  bool over_ = false;
};

}  // namespace cusp::ui
