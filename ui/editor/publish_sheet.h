/// The question before a version is published, with what it changes, who uses an older version and whether it was tried out.
/// Asks once more before an exercise is published that nobody tried out. Scrolls above its buttons where the screen is lower than
/// what it shows. Thread: GUI.
#pragma once

#include <QDialog>

#include "ui/editor/publish_facts.h"
#include "ui/modules.h"
#include "ui/widgets/ports.h"

class QPushButton;
class QScrollArea;
class QVBoxLayout;

namespace cusp::ui {

class PublishSheet : public QDialog {
  Q_OBJECT

 public:
  PublishSheet(PublishFacts facts, const QString& title, const Ports& ports, QWidget* parent);
  QPushButton* publish() const { return publish_; }
  QPushButton* try_out() const { return try_; }  // nullptr if it was tried out; disabled after forbid_opengl()
  /// Closes and emits publish_wanted(), after a question if nobody tried the exercise out.
  void accept() override;

 Q_SIGNALS:
  void publish_wanted();
  void try_out_wanted();

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void fit_height();
  void add_changes(QVBoxLayout& column);
  void add_uses(QVBoxLayout& column);
  void add_trial(QVBoxLayout& column);
  void add_buttons(QVBoxLayout& column);

  PublishFacts facts_;
  const Ports& ports_;
  QScrollArea* area_ = nullptr;
  QPushButton *publish_ = nullptr, *try_ = nullptr;
};

}  // namespace cusp::ui
