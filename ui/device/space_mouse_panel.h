/// The SpaceMouse on the device page: its live values, its rest and dead zone, how fast it turns the view. It stands in
/// the card that it is put into, or brings one. Thread: GUI.
#pragma once

#include <QWidget>
#include <memory>

#include "device/hid/space_mouse_reader.h"
#include "ui/modules.h"

class QVBoxLayout;

namespace cusp::ui {

class Settings;

class SpaceMousePanel : public QWidget {
  Q_OBJECT

 public:
  /// `reader` and `settings` outlive this; `settings` null: nothing is kept.
  SpaceMousePanel(hid::SpaceMouseReader& reader, Settings* settings, QWidget* parent = nullptr);
  ~SpaceMousePanel() override;

  /// "SpaceMouse Compact: connected", for a list of devices.
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
  void make_axes(QVBoxLayout* column);
  void make_settings(QVBoxLayout* column);
  void make_rest(QVBoxLayout* column);
  void connect_settings();
  void connect_rest();
  struct Inner;
  std::unique_ptr<Inner> inner_;
};

}  // namespace cusp::ui
