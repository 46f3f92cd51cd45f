#include "ui/admin/departed_card.h"

#include <QBoxLayout>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <algorithm>

#include "ui/admin/on_window.h"
#include "ui/admin/stations_model.h"
#include "ui/text/exchange_text.h"
#include "ui/text/failure_text.h"
#include "ui/widgets/number_field.h"

namespace cusp::ui {
namespace {

constexpr std::size_t kNamesShown = 3;  // in the text
constexpr int kNamesHigh = 120;         // px at 100 %, of the list of all

QString names_of(const std::vector<DepartedStudent>& students) {
  QStringList names;
  for (std::size_t i = 0; i < students.size() && i < kNamesShown; ++i) names += QString::fromStdString(students[i].account.name);
  return names.join(u", ");
}

QString whole_list_of(const std::vector<DepartedStudent>& students) {
  QStringList lines;
  for (const DepartedStudent& one : students)
    lines += DepartedCard::tr("%1, %2 (%3)", "name, number (day of the newest attempt)")
                 .arg(QString::fromStdString(one.account.name), QString::fromStdString(one.account.number), date_text(one.last_utc_us));
  return lines.join(u'\n');
}

/// What the question was about.
struct AskedErasure {
  int years = 0;
  ClockTrust trust = ClockTrust::checked;
  std::vector<DepartedStudent> shown;
};

/// nullopt, and nobody is erased, if somebody would be who was not shown.
Stored<std::optional<DepartedStudents>> erase_shown(const RecordsBeside& records, const Actor& actor, const AskedErasure& asked) {
  const auto store = open_beside(records);
  if (!store) return std::unexpected(store.error());
  const auto now = departed_students((*store)->context(), actor, asked.years);
  if (!now) return std::unexpected(now.error());
  const bool all_shown = std::ranges::all_of(now->erasable, [&asked](const DepartedStudent& one) {
    return std::ranges::any_of(asked.shown, [&one](const DepartedStudent& shown) { return shown.account.id == one.account.id; });
  });
  if (!all_shown) return std::optional<DepartedStudents>();
  auto erased = erase_departed((*store)->context(), actor, asked.years, asked.trust);
  if (!erased) return std::unexpected(erased.error());
  return std::optional(std::move(*erased));
}

}  // namespace

DepartedCard::DepartedCard(RecordsBeside records, const Actor& actor, const Ports& ports, QWidget* parent)
    : Card(tr("Students who left"), {}, parent), records_(std::move(records)), actor_(actor), ports_(ports) {
  years_ = new NumberField;
  years_->setRange(0, kMostRetainedYears);
  years_->setDecimals(0);
  years_->setSpecialValueText(tr("as the school decides"));
  years_->show_value(0);
  body()->addWidget(labelled(tr("Years without an attempt"), years_));
  text_ = make_label({}, TextRole::body, Weight::regular, "text2");
  text_->setWordWrap(true);
  text_->hide();
  body()->addWidget(text_);
  names_ = new QPlainTextEdit;
  names_->setReadOnly(true);
  names_->setTabChangesFocus(true);
  names_->setAccessibleName(tr("Students who would be erased"));
  names_->setFixedHeight(px(kNamesHigh));
  names_->hide();
  body()->addWidget(names_);
  erase_ = make_button(tr("Erase them"), ButtonKind::erase);
  erase_->setEnabled(false);
  body()->addWidget(erase_);
  connect(years_, &QDoubleSpinBox::valueChanged, this, &DepartedCard::look);
  connect(erase_, &QPushButton::clicked, this, &DepartedCard::erase);
}

int DepartedCard::years() const { return static_cast<int>(years_->value()); }
QString DepartedCard::found() const { return text_->text(); }
void DepartedCard::choose_years(int years) { years_->setValue(years); }

void DepartedCard::look() {
  found_ = {};
  text_->clear();
  text_->hide();
  names_->hide();
  erase_->setEnabled(false);
  if (years() == 0 || working_) return;
  task_ = BackgroundTask([records = records_, actor = actor_, asked = years(), self = QPointer(this)] {
    auto shared = std::make_shared<Stored<Found>>(read_departed(records, actor, asked));
    QMetaObject::invokeMethod(
        QCoreApplication::instance(),
        [self, asked, shared] {
          if (self && self->years() == asked && !self->working_) self->show_found(*shared);
        },
        Qt::QueuedConnection);
  }, BackgroundTask::Holds::nothing);
}

Stored<DepartedCard::Found> DepartedCard::read_departed(const RecordsBeside& records, const Actor& actor, int years) {
  const auto store = open_beside(records.for_reading());
  if (!store) return std::unexpected(store.error());
  auto departed = departed_students((*store)->context(), actor, years);
  if (!departed) return std::unexpected(departed.error());
  const auto keys = other_keys((*store)->context(), actor);
  if (!keys) return std::unexpected(keys.error());
  return Found{std::move(*departed), *keys};
}

void DepartedCard::show_found(const Stored<Found>& found) {
  if (!found) return report_failure(found.error());
  found_ = *found;
  const std::vector<DepartedStudent>& erasable = found_.departed.erasable;
  const int gone = static_cast<int>(erasable.size()), stay = static_cast<int>(found_.departed.waiting.size());
  QString text = gone == 0 ? tr("Nobody has been away that long.") : tr("%n student(s): %1", nullptr, gone).arg(names_of(erasable));
  if (erasable.size() > kNamesShown) text += QStringLiteral(" …");
  if (stay > 0) text += u'\n' + tr("%n student(s) stay: an assessment of theirs is not released.", nullptr, stay);
  text_->setText(text);
  text_->show();
  names_->setPlainText(whole_list_of(erasable));
  names_->setVisible(erasable.size() > kNamesShown);
  erase_->setEnabled(gone > 0);
}

void DepartedCard::erase() {
  const DepartedStudents& departed = found_.departed;
  if (working_ || departed.erasable.empty()) return;
  const int gone = static_cast<int>(departed.erasable.size());
  QString more = tr("Names, numbers and PINs go, and every text about their attempts. The attempts stay under a pseudonym. "
                    "It cannot be undone; backups made before still hold the names.");
  if (departed.doubt) more.prepend(clock_question_text(*departed.doubt) + u' ');
  if (const QString elsewhere = departed_elsewhere_text(found_.others); !elsewhere.isEmpty()) more.prepend(elsewhere + u' ');
  const AskedErasure asked{years(), departed.doubt ? ClockTrust::confirmed : ClockTrust::checked, departed.erasable};
  ports_.ask(this, {tr("Erase %n student(s) for good?", nullptr, gone), more, tr("Erase"), true}, [self = QPointer(this), asked](bool yes) {
    if (!self || !yes || self->working_) return;
    self->working_ = true;
    self->erase_->setEnabled(false);
    self->task_ = BackgroundTask([records = self->records_, actor = self->actor_, asked,
                                  then = on_window<Stored<std::optional<DepartedStudents>>>(self.data(), &DepartedCard::show_erased)] {
      then(erase_shown(records, actor, asked));
    });
  });
}

void DepartedCard::show_erased(const Stored<std::optional<DepartedStudents>>& outcome) {
  working_ = false;
  look();
  emit erased();
  if (!outcome) return report_failure(outcome.error());
  const std::optional<DepartedStudents>& departed = *outcome;
  if (!departed) {
    emit reported(Band::Kind::look, tr("More students have been away that long by now."), tr("Nobody was erased. Check the list, then erase."));
    return;
  }
  const QString done = tr("%n student(s) are erased.", nullptr, static_cast<int>(departed->erasable.size()));
  if (departed->failed) {
    emit reported(Band::Kind::bad, done, describe(*departed->failed).line() + u' ' + tr("The others are not erased."));
    return;
  }
  emit reported(Band::Kind::good, done, tr("The attempts stay under a pseudonym."));
}

void DepartedCard::report_failure(const StorageFailure& failure) {
  const Message message = describe(failure);
  emit reported(Band::Kind::bad, message.what, message.more);
}

}  // namespace cusp::ui
