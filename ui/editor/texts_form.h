/// Title and briefing of an exercise in each of its languages, its level and expected time. Thread: GUI.
#pragma once

#include <QStringList>
#include <QWidget>
#include <memory>
#include <vector>

#include "ui/editor/editor_model.h"
#include "ui/widgets/half_filled.h"

class QComboBox;
class QLineEdit;
class QVBoxLayout;

namespace cusp::ui {

class NumberBox;

/// Languages that Cusp speaks, then those that the exercise has or that were added here. The fields of one go when it is removed.
class TextsForm : public QWidget, public HalfFilled {
  Q_OBJECT

 public:
  explicit TextsForm(EditorModel& model, QWidget* parent = nullptr);
  ~TextsForm() override;
  /// Codes of the languages with fields, in their order.
  QStringList shown_languages() const;
  /// A briefing stands in its field that the exercise cannot hold.
  bool half_filled() const override;

 private:
  struct Section;
  void make_add(QVBoxLayout& column);
  void make_level_and_time(QVBoxLayout& column);
  std::unique_ptr<Section> make_section(const QString& code);
  void fit_target_titles(Section& section);
  void take_briefing(const Section& section);
  QStringList wanted_languages() const;
  /// `also`: a language that has no text yet.
  void fit_sections(const QString& also = {});
  void remove(const QString& code);
  void follow_model();

  EditorModel& model_;
  QVBoxLayout* texts_ = nullptr;
  std::vector<std::unique_ptr<Section>> sections_;
  QComboBox *add_ = nullptr, *level_ = nullptr;
  NumberBox* expected_ = nullptr;  // minutes
};

/// "Fissure (copy)", in each language of the title; no longer than an exercise can hold.
LocalText title_of_copy(const LocalText& title);

/// Shows the text of a language. Spaces at the end of the typed text stay.
void show_text(QLineEdit& edit, const LocalText& texts, const std::string& language);

}  // namespace cusp::ui
