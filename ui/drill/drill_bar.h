/// The bar over the drilling screen: the way out, the exercise, the clock, the device, Pause and Finish. A narrow bar leaves out
/// the device's name, then the texts of Leave and Pause, and shortens the title and the tag at last. Thread: GUI.
#pragma once

#include <QFrame>

#include "engine/base/haptic_port.h"
#include "engine/loop/realtime.h"
#include "ui/modules.h"

class QLabel;
class QPushButton;

namespace cusp::ui {

class DrillBar : public QFrame {
  Q_OBJECT

 public:
  explicit DrillBar(QWidget* parent = nullptr);

  void set_exercise(const QString& title, const QString& aside);
  void set_seconds(double seconds);
  /// Beside the clock; 0: none. Below five minutes and below one the time that is left is shown and read out.
  void set_time_limit(double seconds);
  void set_device(const DeviceLimits& device);
  /// Only a device that pushes a hand suffers from late ticks; shown, and read out, as soon as the loop knows what it was
  /// granted.
  void show_grant(const RealtimeGrant& grant);
  /// Pause, or Resume once it stands. If `on` is false (an assessment), the button shows with Resume alone.
  void offer_pause(bool on);
  void set_stopped(bool stopped);
  void enable_pause(bool on);
  void enable_leave(bool on);
  void enable_finish(bool on);

 Q_SIGNALS:
  void leave();
  void pause();
  void finish();

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  enum class Detail { whole, no_device, icons, short_texts };
  void show_time_left(double left_s);
  void show_detail(Detail detail);
  void show_texts(Detail detail);
  /// The most detail that the width holds.
  void fit();

  QLabel *title_, *aside_, *clock_, *limit_, *device_name_;
  QPushButton *leave_, *pause_, *finish_;
  QString whole_title_, whole_aside_;
  DeviceLimits device_;
  double limit_s_ = 0;
  int warned_ = 0;  // how many of the two warnings were given
  bool shown_grant_ = false, delayed_ = false, stopped_ = false, offers_pause_ = true;
};

}  // namespace cusp::ui
