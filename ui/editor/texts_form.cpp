#include "ui/editor/texts_form.h"

#include <QBoxLayout>
#include <QComboBox>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QSignalBlocker>

#include "ui/editor/form_parts.h"
#include "ui/text/names.h"
#include "ui/widgets/format.h"
#include "ui/widgets/parts.h"

namespace cusp::ui {
namespace {

constexpr const char* kLanguages[] = {"en", "de"};
constexpr double kMostMinutes = 240;  // half a day of a course
constexpr int kNoLevel = -1;          // of a box's entry

}  // namespace

LocalText title_of_copy(const LocalText& title) {
  LocalText out;
  for (const auto& [language, text] : title) {
    const QString name = QString::fromStdString(text);
    // Content of the exercise, which is not translated by tr().
    out[language] = (language == "de" ? u"%1 (Kopie)"_qs : u"%1 (copy)"_qs).arg(name).toStdString();
  }
  return out;
}

void show_text(QLineEdit& edit, const LocalText& texts, const std::string& language) {
  const auto it = texts.find(language);
  const QString text = it == texts.end() ? QString() : QString::fromStdString(it->second);
  // A typed space at the end stays.
  if (edit.text().trimmed() != text) edit.setText(text);
}

TextsForm::TextsForm(EditorModel& model, QWidget* parent) : QWidget(parent), model_(model) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(px(16), px(12), px(16), px(16));
  column->setSpacing(px(8));
  const QString titles[] = {tr("Title, English"), tr("Title, German")};
  const QString briefings[] = {tr("Briefing, English"), tr("Briefing, German")};
  for (int i = 0; i < 2; ++i) {
    titles_[i] = new QLineEdit;
    briefings_[i] = new QPlainTextEdit;
    briefings_[i]->setTabChangesFocus(true);
    briefings_[i]->setFixedHeight(px(140));
    column->addWidget(labelled(titles[i], titles_[i]));
    column->addWidget(labelled(briefings[i], briefings_[i]));
    const std::string code = kLanguages[i];
    connect(titles_[i], &QLineEdit::textEdited, this,
            [this, code](const QString& text) { model_.set_title(code, text.trimmed()); });
    connect(titles_[i], &QLineEdit::editingFinished, this, [this] {
      model_.end_gesture();
      follow_model();
    });
    connect(briefings_[i], &QPlainTextEdit::textChanged, this, [this, code, edit = briefings_[i]] {
      model_.set_briefing(code, edit->toPlainText().trimmed());
    });
  }
  make_level_and_time(*column);
  column->addStretch();
  connect(&model_, &EditorModel::changed, this, &TextsForm::follow_model);
  follow_model();
}

void TextsForm::make_level_and_time(QVBoxLayout& column) {
  level_ = new QComboBox;
  level_->addItem(tr("not stated"), kNoLevel);
  for (std::size_t i = 0; i < kLevelKeys.size(); ++i) level_->addItem(level_name(static_cast<Level>(i)), static_cast<int>(i));
  column.addWidget(labelled(tr("Level"), level_));
  connect(level_, &QComboBox::activated, this, [this] {
    const int chosen = level_->currentData().toInt();
    model_.set_level(chosen == kNoLevel ? std::nullopt : std::optional(static_cast<Level>(chosen)));
  });
  expected_ = new NumberBox(model_, tr("Expected time"), u"min"_qs, 0, kMostMinutes, 5, 0,
                            [this](double minutes) { return model_.set_expected_time_s(60 * minutes); });
  expected_->setSpecialValueText(tr("not stated"));
  add_row(&column, tr("Expected time"), expected_);
}

void TextsForm::follow_model() {
  const Scenario& s = model_.scenario();
  level_->setCurrentIndex(level_->findData(s.level ? static_cast<int>(*s.level) : kNoLevel));
  expected_->show_value(s.expected_time_s / 60);
  for (int i = 0; i < 2; ++i) {
    show_text(*titles_[i], s.title, kLanguages[i]);
    const auto it = s.briefing.find(kLanguages[i]);
    const QString text = it == s.briefing.end() ? QString() : QString::fromStdString(it->second);
    if (briefings_[i]->toPlainText().trimmed() != text && !briefings_[i]->hasFocus()) {
      const QSignalBlocker quiet(briefings_[i]);
      briefings_[i]->setPlainText(text);
    }
  }
}

}  // namespace cusp::ui
