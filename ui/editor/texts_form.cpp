#include "ui/editor/texts_form.h"

#include <QBoxLayout>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSignalBlocker>
#include <algorithm>
#include <cmath>
#include <utility>

#include "scenarios/format/ranges.h"
#include "ui/editor/form_parts.h"
#include "ui/editor/target_names.h"
#include "ui/text/language.h"
#include "ui/text/names.h"
#include "ui/widgets/format.h"
#include "ui/widgets/parts.h"

namespace cusp::ui {
namespace {

constexpr int kMostSeen = 16;         // languages of the list at once
constexpr double kMostMinutes = 240;  // half a day of a course
constexpr int kNoLevel = -1;          // of a box's entry

bool is_spoken(const QString& code) {
  return std::ranges::any_of(languages(), [&](const Language& language) { return language.code == code; });
}

}  // namespace

LocalText title_of_copy(const LocalText& title) {
  LocalText out;
  for (const auto& [language, text] : title) {
    // Content of the exercise, which is not translated by tr().
    const QString end = language == "de" ? u" (Kopie)"_qs : u" (copy)"_qs;
    const auto most = static_cast<qsizetype>(kMostTextCharacters) - end.size();
    const std::u32string name = QString::fromStdString(text).toStdU32String();
    out[language] = (QString::fromStdU32String(name.substr(0, static_cast<std::size_t>(most))) + end).toStdString();
  }
  return out;
}

void show_text(QLineEdit& edit, const LocalText& texts, const std::string& language) {
  const auto it = texts.find(language);
  const QString text = it == texts.end() ? QString() : QString::fromStdString(it->second);
  // A typed space at the end stays.
  if (edit.text().trimmed() == text) return;
  edit.setText(text);
  if (!edit.hasFocus()) edit.setCursorPosition(0);  // of a long text its beginning shows
}

struct TextsForm::Section {
  QString code;
  QWidget* whole = nullptr;
  QLineEdit* title = nullptr;
  QPlainTextEdit* briefing = nullptr;
  QLabel* refused = nullptr;  // why the exercise keeps another briefing; hidden while it has this one
  QVBoxLayout* targets = nullptr;
  struct TargetTitle {
    std::size_t part;  // of the target's union
    QWidget* row;
    QLineEdit* edit;
  };
  std::vector<TargetTitle> target_titles;
  QPushButton* away = nullptr;  // null: the language stays

  /// From the briefing through the fields below it.
  QWidget* last_focus() const {
    QWidget* from = briefing;
    for (const TargetTitle& one : target_titles) setTabOrder(std::exchange(from, one.edit), one.edit);
    if (away) setTabOrder(std::exchange(from, away), away);
    return from;
  }
  void focus_goes_to(const Section& next) const {
    QWidget* from = last_focus();
    for (QWidget* to : std::initializer_list<QWidget*>{next.title, next.briefing, next.away})
      if (to) setTabOrder(std::exchange(from, to), to);
  }
};

TextsForm::TextsForm(EditorModel& model, QWidget* parent) : QWidget(parent), model_(model) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(px(16), px(12), px(16), px(16));
  column->setSpacing(px(8));
  texts_ = new QVBoxLayout;
  texts_->setSpacing(px(8));
  column->addLayout(texts_);
  fit_sections();  // first of all, as the focus goes
  make_add(*column);
  make_level_and_time(*column);
  column->addStretch();
  connect(&model_, &EditorModel::changed, this, &TextsForm::follow_model);
  follow_model();
}

/// Hidden while it is whole: a field that loses the focus fits the form to the model.
TextsForm::~TextsForm() { hide(); }

QStringList TextsForm::shown_languages() const {
  QStringList out;
  for (const auto& section : sections_) out += section->code;
  return out;
}

std::unique_ptr<TextsForm::Section> TextsForm::make_section(const QString& code) {
  auto out = std::make_unique<Section>(Section{code, new QWidget, new QLineEdit, new QPlainTextEdit, make_label({}, TextRole::caption, Weight::regular, "look"), new QVBoxLayout, {}, nullptr});
  auto* column = new QVBoxLayout(out->whole);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(px(8));
  out->briefing->setTabChangesFocus(true);
  out->briefing->setFixedHeight(px(140));
  out->title->setMaxLength(static_cast<int>(kMostTextCharacters));
  out->refused->setWordWrap(true);
  out->refused->hide();
  //: %1: a language
  column->addWidget(labelled(tr("Title, %1").arg(language_name(code)), out->title));
  //: %1: a language
  column->addWidget(labelled(tr("Briefing, %1").arg(language_name(code)), out->briefing));
  column->addWidget(out->refused);
  out->targets->setSpacing(px(8));
  column->addLayout(out->targets);
  if (!is_spoken(code)) {
    out->away = make_button(tr("Remove %1").arg(language_name(code)), ButtonKind::quiet, u"trash"_qs);
    column->addWidget(out->away, 0, Qt::AlignLeft);
    connect(out->away, &QPushButton::clicked, this, [this, code] { remove(code); });
  }
  connect(out->title, &QLineEdit::textEdited, this,
          [this, key = code.toStdString()](const QString& text) { model_.set_title(key, text.trimmed()); });
  connect(out->title, &QLineEdit::editingFinished, this, [this] {
    model_.end_gesture();
    follow_model();
  });
  connect(out->briefing, &QPlainTextEdit::textChanged, this, [this, section = out.get()] { take_briefing(*section); });
  return out;
}

/// A text that the exercise cannot hold stays in the field, with a message.
void TextsForm::take_briefing(const Section& section) {
  const QString text = section.briefing->toPlainText().trimmed();
  const auto length = text.toUcs4().size(), most = static_cast<qsizetype>(kMostTextCharacters);
  const bool was_taken = section.refused->isHidden();
  section.refused->setVisible(length > most);
  if (length <= most && (model_.set_briefing(section.code.toStdString(), text) || !text.isEmpty())) return;
  //: %1: characters of a text, %2: the most that an exercise can hold
  const QString longer = tr("%1 of at most %2 characters. The exercise keeps the briefing as it was.").arg(QLocale().toString(length), QLocale().toString(most));
  section.refused->setText(length > most ? longer : tr("An exercise needs a briefing in English. It keeps the one from before until another is typed."));
  section.refused->show();
  if (was_taken) announce(section.briefing, section.refused->text());
}

bool TextsForm::half_filled() const {
  return std::ranges::any_of(sections_, [](const auto& section) { return !section->refused->isHidden(); });
}

void TextsForm::make_add(QVBoxLayout& column) {
  add_ = new QComboBox;
  add_->addItem(tr("Add a language…"));
  for (const Language& language : world_languages()) add_->addItem(language.name, language.code);
  add_->setStyleSheet(u"combobox-popup: 0;"_qs);  // a list that scrolls; the style's own fills the screen
  add_->setMaxVisibleItems(kMostSeen);
  add_->setAccessibleName(tr("Add a language"));
  column.addWidget(add_);
  connect(add_, &QComboBox::activated, this, [this](int row) {
    const QString code = add_->itemData(row).toString();
    add_->setCurrentIndex(0);
    if (code.isEmpty()) return;
    fit_sections(code);
    for (const auto& section : sections_)
      if (section->code == code) section->title->setFocus();
  });
}

QStringList TextsForm::wanted_languages() const {
  QStringList out;
  for (const Language& language : languages()) out += language.code;
  const Scenario& s = model_.scenario();
  for (const LocalText* texts : {&s.title, &s.briefing})
    for (const auto& [code, text] : *texts) out += QString::fromStdString(code);
  for (const Region* one : named_targets(s.target))
    for (const auto& [code, text] : one->title) out += QString::fromStdString(code);
  out += shown_languages();  // a cleared text may be typed anew
  return out;
}

/// Fields that stay keep their focus and what is typed in them.
void TextsForm::fit_sections(const QString& also) {
  QStringList wanted = wanted_languages();
  if (!also.isEmpty()) wanted += also;
  wanted.removeDuplicates();
  for (qsizetype i = 0; i < wanted.size(); ++i) {
    const auto at = std::ranges::find(sections_, wanted[i], [](const auto& section) { return section->code; });
    if (at != sections_.end()) continue;
    const auto place = std::min<qsizetype>(i, std::ssize(sections_));
    auto section = make_section(wanted[i]);
    texts_->insertWidget(static_cast<int>(place), section->whole);
    if (place > 0) sections_[static_cast<std::size_t>(place - 1)]->focus_goes_to(*section);
    sections_.insert(sections_.begin() + place, std::move(section));
  }
}

void TextsForm::remove(const QString& code) {
  model_.remove_language(code.toStdString());
  std::erase_if(sections_, [&](const auto& section) {
    if (section->code != code) return false;
    section->whole->hide();
    section->whole->deleteLater();
    return true;
  });
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
  expected_ = new NumberBox(model_, tr("Expected time"), u"min"_qs, 0, kMostMinutes, 5, 1,
                            [this](double minutes) { return model_.set_expected_time_s(std::round(60 * minutes)); });
  expected_->drop_needless_decimals();
  expected_->setSpecialValueText(tr("not stated"));
  add_row(&column, tr("Expected time"), expected_);
}

/// A field for each of several targets; fields that stay keep what is typed in them.
void TextsForm::fit_target_titles(Section& section) {
  const Region& whole = model_.scenario().target;
  const auto is_titled = [&](std::size_t part) { return can_be_target(whole, {part}) && !whole.parts[part].name.empty(); };
  std::erase_if(section.target_titles, [&](const Section::TargetTitle& one) {
    if (is_titled(one.part)) return false;
    one.edit->disconnect(this);  // a hidden field loses the focus, and would fit these rows within this loop
    one.row->hide();
    one.row->deleteLater();
    return true;
  });
  for (std::size_t part = 0, at = 0; part < whole.parts.size(); ++part) {
    if (!is_titled(part)) continue;
    if (at == section.target_titles.size() || section.target_titles[at].part != part) {
      auto* edit = new QLineEdit;
      edit->setMaxLength(static_cast<int>(kMostTextCharacters));
      //: %1: which of several targets, %2: a language
      QWidget* row = labelled(tr("Name of target %1, %2").arg(part + 1).arg(language_name(section.code)), edit);
      section.targets->insertWidget(static_cast<int>(at), row);
      section.target_titles.insert(section.target_titles.begin() + static_cast<std::ptrdiff_t>(at), {part, row, edit});
      section.last_focus();
      // A name that is cleared to be typed anew is none yet.
      connect(edit, &QLineEdit::editingFinished, this, [this, part, edit, key = section.code.toStdString()] {
        model_.set_target_title(part, key, edit->text().trimmed());
        model_.end_gesture();
        follow_model();
      });
    }
    QLineEdit* edit = section.target_titles[at++].edit;
    if (!edit->hasFocus() || !edit->isModified()) show_text(*edit, whole.parts[part].title, section.code.toStdString());
  }
}

void TextsForm::follow_model() {
  const Scenario& s = model_.scenario();
  level_->setCurrentIndex(level_->findData(s.level ? static_cast<int>(*s.level) : kNoLevel));
  expected_->show_value(s.expected_time_s / 60);
  fit_sections();
  for (const auto& section : sections_) {
    const std::string code = section->code.toStdString();
    show_text(*section->title, s.title, code);
    fit_target_titles(*section);
    const auto it = s.briefing.find(code);
    const QString text = it == s.briefing.end() ? QString() : QString::fromStdString(it->second);
    if (section->briefing->toPlainText().trimmed() != text && !section->briefing->hasFocus() && section->refused->isHidden()) {
      const QSignalBlocker quiet(section->briefing);
      section->briefing->setPlainText(text);
    }
  }
}

}  // namespace cusp::ui
