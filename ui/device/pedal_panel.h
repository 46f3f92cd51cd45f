/// The foot pedal on the device page: which one, how far it is down, and its calibration step by step. It stands in the
/// card that it is put into, or brings one. Thread: GUI.
#pragma once

#include <QWidget>
#include <memory>

#include "device/hid/pedal_reader.h"
#include "ui/modules.h"

class QVBoxLayout;

namespace cusp::ui {

class Settings;

class PedalPanel : public QWidget {
  Q_OBJECT

 public:
  /// `reader` and `settings` outlive this; `settings` null: nothing is kept.
  PedalPanel(hid::PedalReader& reader, Settings* settings, QWidget* parent = nullptr);
  ~PedalPanel() override;

  /// "VEC USB Footpedal: connected", for a list of devices.
  QString summary() const;

 public Q_SLOTS:
  /// Reads what is there now; by itself ten times a second while it is seen.
  void look();

 Q_SIGNALS:
  void summary_changed(const QString& summary);

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  void make_controls(QVBoxLayout* column);
  void make_lesson(QVBoxLayout* column);
  void connect_lesson();
  void connect_settings();
  void connect_device();
  enum class Lesson : std::uint8_t;
  void learn(Lesson lesson);
  void show_devices();
  void show_lesson();
  struct Inner;
  std::unique_ptr<Inner> inner_;
};

}  // namespace cusp::ui
