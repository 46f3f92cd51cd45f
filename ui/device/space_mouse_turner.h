/// The SpaceMouse turns, moves and zooms a view of the tooth, as the right mouse button and the wheel do; while the mouth mirror
/// is in, it leads the mirror. Its left button brings back the view that it began from, its right one puts the mirror in or takes
/// it out. Thread: GUI.
#pragma once

#include <QObject>
#include <QTimer>
#include <optional>

#include "device/hid/space_mouse_reader.h"
#include "ui/modules.h"
#include "ui/render/camera.h"
#include "ui/render/mouth_mirror.h"

namespace cusp::ui {

class ToothView;

/// The camera after dt_s of this motion. A full deflection turns by 90 degrees a second, moves by half the view and
/// comes nearer by a factor of e, times `speed`. Pure.
Camera led(const Camera& camera, const hid::SpaceMouseMotion& motion, double speed, double dt_s);
/// The mirror after dt_s: the hand leads it as the camera shows it, by up to 20 mm and 90 degrees a second, times `speed`. Pure.
MouthMirror led(const MouthMirror& mirror, const Camera& camera, const hid::SpaceMouseMotion& motion, double speed, double dt_s);

class SpaceMouseTurner : public QObject {
  Q_OBJECT

 public:
  /// `reader` outlives this; the view owns it.
  SpaceMouseTurner(ToothView& view, hid::SpaceMouseReader& reader);

 Q_SIGNALS:
  /// The cap is off its rest. At each look while the view is led.
  void moved();
  /// The right button.
  void mirror_asked();

 private:
  void look();

  ToothView& view_;
  hid::SpaceMouseReader& reader_;
  QTimer timer_;
  std::optional<Camera> first_;  // what the left button goes back to
  std::chrono::steady_clock::time_point before_{};
  std::uint32_t buttons_ = 0;
};

}  // namespace cusp::ui
