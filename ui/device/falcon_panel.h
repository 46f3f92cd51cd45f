/// One Falcon on the device page: homing, its live values, a test of its force, and for staff the self-test and the
/// weighing, whose results are taken over into the station's settings. Thread: GUI; the device has a thread of its own,
/// and is held only while the panel is seen.
#pragma once

#include <QWidget>
#include <memory>

#include "storage/repositories/device_tests.h"
#include "ui/modules.h"
#include "ui/settings/device_settings.h"
#include "ui/widgets/ports.h"

class QVBoxLayout;

namespace cusp::ui {

class FalconPanel : public QWidget {
  Q_OBJECT

 public:
  /// `settings` outlives this. Students see, home and feel it; what changes the station is staff's.
  FalconPanel(DeviceSettings& settings, Ports ports, Role role, QWidget* parent = nullptr);
  ~FalconPanel() override;

  /// Which one; releases the one before.
  void set_device(const std::string& kind, const std::string& name);
  /// Its state as a short text, for lists and tests.
  QString summary() const;
  /// Releases the device, so that an attempt may have it.
  void release();

 Q_SIGNALS:
  /// A self-test has come to its end: without tester and time.
  void tested(const DeviceTest& test);

 public Q_SLOTS:
  /// Reads what is there now; by itself twenty times a second while it is seen.
  void look();

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  void make_live(QVBoxLayout* column);
  void make_tests(QVBoxLayout* column);
  void make_trim(QVBoxLayout* column);
  void open();
  void start_force_test();
  void start_self_test();
  void start_weighing();
  void trial_over();
  void self_test_over();
  void save_report();
  void show_measured();

  struct Inner;
  std::unique_ptr<Inner> inner_;
};

}  // namespace cusp::ui
