/// The Haply Inverse3 on the device page: whether its service answers, its live values, and how it lies in the hand's
/// space. It stands in the card that it is put into, or brings one. Thread: GUI. The service is asked as a background task, and only
/// when the user asks for it; no call here waits for it.
#pragma once

#include <QWidget>
#include <functional>
#include <memory>

#include "device/inverse/inverse_port.h"
#include "ui/modules.h"

class QVBoxLayout;

namespace cusp::ui {

class Settings;

class InversePanel : public QWidget {
  Q_OBJECT

 public:
  using MakePort = std::function<std::unique_ptr<InversePort>(const InverseSettings&)>;
  /// `settings` outlives this; null: nothing is kept.
  explicit InversePanel(Settings* settings, MakePort make_port = make_inverse_port, QWidget* parent = nullptr);
  ~InversePanel() override;

  /// For students: direction, scale and port of the station are shown and stay.
  void fix_settings();
  /// "Haply Inverse3: answers", for a list of devices.
  QString summary() const;
  /// What an attempt is to be made with.
  InverseSettings chosen() const;
  /// Asks the service. Answers show by themselves.
  void connect_to_it();
  /// Releases the device, or stops asking for it. It is free once wait_for_dropped_devices() returns (ui/session/background_task.h).
  void release();

 Q_SIGNALS:
  void summary_changed(const QString& summary);

 protected:
  void hideEvent(QHideEvent* event) override;

 private:
  void make_values(QVBoxLayout* column);
  void make_fields(QVBoxLayout* column);
  void make_acts(QVBoxLayout* column);
  void connect_all();
  void look();
  void take_answer();
  QString show_answers();

  struct Inner;
  std::unique_ptr<Inner> inner_;
};

}  // namespace cusp::ui
