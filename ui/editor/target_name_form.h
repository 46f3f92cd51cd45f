/// Makes the chosen part of the target one of several targets, by giving it a name. Thread: GUI.
#pragma once

#include <QWidget>

#include "ui/editor/editor_model.h"

class QLineEdit;

namespace cusp::ui {

/// Stands only where the chosen part can be one. The name is in the window's language; the page of texts has those of the others.
class TargetNameForm : public QWidget {
  Q_OBJECT

 public:
  explicit TargetNameForm(EditorModel& model, QWidget* parent = nullptr);

 private:
  void take();
  void follow_model();

  EditorModel& model_;
  QLineEdit* name_ = nullptr;
};

}  // namespace cusp::ui
