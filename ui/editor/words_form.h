/// Title and briefing of an exercise in each language. GUI thread.
#pragma once

#include <QWidget>

#include "ui/editor/editor_model.h"

class QLineEdit;
class QPlainTextEdit;

namespace cusp::ui {

class WordsForm : public QWidget {
  Q_OBJECT

 public:
  explicit WordsForm(EditorModel& model, QWidget* parent = nullptr);

 private:
  void follow_model();

  EditorModel& model_;
  QLineEdit* titles_[2] = {};
  QPlainTextEdit* briefings_[2] = {};
};

/// The text of a language, unless it stands there but for a space that is just being typed.
/// "Fissure (copy)", in each language that the title is in.
LocalText title_of_copy(const LocalText& title);

void show_text(QLineEdit& edit, const LocalText& texts, const std::string& language);

}  // namespace cusp::ui
