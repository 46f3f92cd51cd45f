/// The Haply Inverse3 on the device page: whether its service answers, what it tells, and how it lies in the hand's
/// space. Thread: GUI; the service is asked on a thread of its own.
#pragma once

#include <QWidget>
#include <functional>
#include <memory>

#include "device/inverse/inverse_port.h"

namespace cusp {

class Settings;

class InversePanel : public QWidget {
  Q_OBJECT

 public:
  using MakePort = std::function<std::unique_ptr<InversePort>(const InverseSettings&)>;
  /// `settings` outlives this; null: nothing is kept.
  explicit InversePanel(Settings* settings, MakePort make_port = make_inverse_port, QWidget* parent = nullptr);
  ~InversePanel() override;

  QString summary() const;
  /// What a go is to be made with.
  InverseSettings chosen() const;
  /// Lets go of the device, so that a go may have it; looks again when the panel is seen next.
  void let_go();

 Q_SIGNALS:
  void summary_changed(const QString& summary);

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  struct Inner;
  std::unique_ptr<Inner> inner_;
};

}  // namespace cusp
