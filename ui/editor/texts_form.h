/// Title and briefing of an exercise in each language, its level and expected time. Thread: GUI.
#pragma once

#include <QWidget>

#include "ui/editor/editor_model.h"

class QComboBox;
class QLineEdit;
class QPlainTextEdit;
class QVBoxLayout;

namespace cusp::ui {

class NumberBox;

class TextsForm : public QWidget {
  Q_OBJECT

 public:
  explicit TextsForm(EditorModel& model, QWidget* parent = nullptr);

 private:
  void make_level_and_time(QVBoxLayout& column);
  void follow_model();

  EditorModel& model_;
  QLineEdit* titles_[2] = {};
  QPlainTextEdit* briefings_[2] = {};
  QComboBox* level_ = nullptr;
  NumberBox* expected_ = nullptr;  // minutes
};

/// "Fissure (copy)", in each language of the title.
LocalText title_of_copy(const LocalText& title);

/// Shows the text of a language. Spaces at the end of the typed text stay.
void show_text(QLineEdit& edit, const LocalText& texts, const std::string& language);

}  // namespace cusp::ui
