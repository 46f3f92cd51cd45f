/// Holds the mouth mirror in a view: puts it behind the tooth, drags and tilts it with the mouse, moves it by keys. Thread: GUI.
#pragma once

#include <QObject>
#include <QPointF>
#include <optional>

#include "ui/view/tooth_view.h"

namespace cusp::ui {

class MirrorHold : public QObject {
  Q_OBJECT

 public:
  /// The view owns it.
  explicit MirrorHold(ToothView& view);

  /// Behind `place_mm` as the camera sees it now; the camera steps back until it sees the whole mirror.
  void take(Vec3 place_mm);
  /// The camera goes as near as it was, from where it looks now.
  void put_away();
  bool held() const { return view_.scene().mirror.has_value(); }

  /// I J K L move it up, left, down and right; U and O bring it nearer and take it away; with Shift the four tilt it.
  /// False for other keys, and without a mirror.
  bool press_key(int key, Qt::KeyboardModifiers modifiers);

 protected:
  /// Takes the mouse from the view over the mirror: left drags, right tilts, the wheel moves it nearer or away.
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  bool over(QPointF at) const;
  void drag(QPointF to);
  double mm_per_px() const;

  ToothView& view_;
  std::optional<Camera> before_;  // the camera as it was when the mirror was taken
  std::optional<QPointF> last_;  // of a drag
  Qt::MouseButton button_ = Qt::NoButton;
};

}  // namespace cusp::ui
