#include "ui/admin/exchange_cards.h"

#include <QBoxLayout>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QShortcut>

#include "ui/admin/stations_model.h"
#include "ui/text/exchange_text.h"
#include "ui/text/incident_text.h"
#include "ui/widgets/format.h"

namespace cusp::ui {
namespace {

constexpr int kFormWidth = 520;  // px at 100 %: a name is short

/// The act and the way back, side by side; Escape goes back too.
template <class Step>
QWidget* make_step_buttons(Step* step, QPushButton* act) {
  auto* bar = new QWidget;
  auto* row = new QHBoxLayout(bar);
  row->setContentsMargins(0, px(8), 0, 0);
  row->setSpacing(px(8));
  QPushButton* back = make_button(FileCard::tr("Back"));
  row->addWidget(act);
  row->addWidget(back);
  row->addStretch();
  QObject::connect(back, &QPushButton::clicked, step, &Step::left);
  QObject::connect(new QShortcut(QKeySequence(Qt::Key_Escape), step), &QShortcut::activated, step, &Step::left);
  return bar;
}

}  // namespace

QLabel* make_note(const QString& text, const char* ink) {
  QLabel* label = make_label(text, TextRole::body, Weight::regular, ink);
  label->setWordWrap(true);
  return label;
}

TrustCard::TrustCard(const KeyToTrust& asked) : Card(asked.known ? tr("A known station") : tr("Make a station known")) {
  const Hash256 id = key_id(asked.key.bytes);
  body()->addWidget(make_note(asked.known ? tr("Fingerprint of its key") : tr("Fingerprint of the key in this file")));
  QLabel* shown = make_label(fingerprint(id), TextRole::page_title, Weight::bold);
  shown->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  shown->setAccessibleName(tr("Fingerprint %1").arg(fingerprint(id)));
  body()->addWidget(shown);
  if (!asked.known) {
    body()->addWidget(make_note(tr("Call the other station’s administrator, who sees its fingerprint on the page Other stations and reads it to you. "
                                 "Only if every sign is the same, the file is truly from there.")));
  } else if (*asked.known == KeyRole::revoked) {
    body()->addWidget(make_note(tr("This key was revoked: none of its files is read. Made known again, they are.")));
  } else if (*asked.known == KeyRole::former) {
    body()->addWidget(make_note(tr("A former key: it signed older records of this station. Made known again, its files are read too.")));
  }
  body()->addWidget(make_choices(asked));
  brings_ = make_note({});
  body()->addWidget(brings_);
  show_role();
  body()->addWidget(make_acts(asked));
  body()->addStretch();
  setFocusProxy(name_);
}

QWidget* TrustCard::make_choices(const KeyToTrust& asked) {
  auto* choices = new QWidget;
  choices->setMaximumWidth(px(kFormWidth));
  QFormLayout* form = make_form();
  choices->setLayout(form);
  name_ = new QLineEdit(asked.name);
  name_->setMaxLength(60);
  name_->setPlaceholderText(tr("Clinic, room 2"));
  add_field(*form, tr("What you call it here"), name_);
  role_ = new Segments({tr("A station"), tr("The office")});
  role_->choose(asked.offered == KeyRole::office ? 1 : 0);
  add_field(*form, tr("It is"), role_, 12);
  connect(role_, &Segments::changed, this, &TrustCard::show_role);
  return choices;
}

void TrustCard::show_role() {
  brings_->setText(role_->chosen() == 1 ? tr("Its files bring people, cohorts, assignments and exercises, and its results.")
                                        : tr("Its files bring its results alone."));
}

QWidget* TrustCard::make_acts(const KeyToTrust& asked) {
  const bool counts = asked.known && *asked.known != KeyRole::revoked && *asked.known != KeyRole::former;
  QPushButton* act = make_button(counts ? tr("Save") : tr("It is the same: make it known"), ButtonKind::primary, u"check"_qs);
  connect(act, &QPushButton::clicked, this,
          [this] { Q_EMIT agreed(role_->chosen() == 1 ? KeyRole::office : KeyRole::station, name_->text().trimmed()); });
  return make_step_buttons(this, act);
}

FileCard::FileCard(const Shown& shown) : Card(tr("What is in the file"), QFileInfo(shown.file).fileName()) {
  elide_aside();  // the file's name
  const ExchangeLook& look = shown.look;
  const ExchangeDescription& d = look.description;
  auto* facts = new QFormLayout;
  facts->setHorizontalSpacing(px(16));
  facts->setVerticalSpacing(px(8));
  const auto fact = [&](const QString& name, const QString& value) {
    QLabel* text = make_note(value, "");
    text->setTextInteractionFlags(Qt::TextSelectableByMouse);
    facts->addRow(make_label(name, TextRole::body, Weight::regular, "text2"), text);
  };
  fact(tr("From"), tr("%1, key %2").arg(isolate(shown.from), fingerprint(key_id(look.signer.bytes))));
  fact(tr("Made"), tr("%1, file %2 of this station").arg(date_text(d.made_utc_us)).arg(d.number()));
  fact(tr("Kind"), exchange_kind_name(d.kind));
  fact(tr("Carries"), counts_text(look.counts));
  body()->addLayout(facts);
  body()->addWidget(make_note(follows(look)));
  QPushButton* act = make_button(tr("Read it in"), ButtonKind::primary, u"import"_qs);
  connect(act, &QPushButton::clicked, this, &FileCard::agreed);
  body()->addWidget(make_step_buttons(this, act));
  body()->addStretch();
  setFocusProxy(act);
}

QString FileCard::follows(const ExchangeLook& look) const {
  const auto number = look.description.number();
  if (look.newest_read > number) {
    return tr("File %1 of this station was read in already, and this one is older: it adds what is new and changes nothing. "
              "For what has changed since, ask for a new file.").arg(look.newest_read);
  }
  if (look.newest_read == number) return tr("This file was read in already. Read again, it adds only what still waited for another file.");
  if (look.description.kind == ExchangeKind::office) {
    return tr("Accounts that the office has changed take the place of those here. Nothing is changed until you read it in; it is read whole or not at all.");
  }
  return tr("It adds what is not here yet. Nothing is changed until you read it in; it is read whole or not at all.");
}

}  // namespace cusp::ui
