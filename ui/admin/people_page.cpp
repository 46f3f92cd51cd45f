#include "ui/admin/people_page.h"

#include <QApplication>
#include <QBoxLayout>
#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPointer>
#include <QPushButton>
#include <algorithm>
#include <utility>

#include "ui/admin/account_change.h"
#include "ui/admin/departed_card.h"
#include "ui/admin/people_model.h"
#include "ui/session/records_task.h"
#include "ui/widgets/choice.h"
#include "ui/widgets/empty_state.h"
#include "ui/widgets/format.h"
#include "ui/widgets/head_row.h"
#include "ui/widgets/parts.h"
#include "ui/text/failure_text.h"
#include "ui/text/names.h"
#include "ui/widgets/table.h"

namespace cusp::ui {
namespace {

// px at 100 %
constexpr int kBesideFrom = 760;  // the form stands beside the list, which then has names, numbers and roles whole
constexpr int kFormWide = 320;    // beside the list
constexpr int kListLeast = 214;   // above the form: a head and five rows

}  // namespace

PeoplePage::PeoplePage(Store& store, const Actor& actor, const Ports& ports, QWidget* parent, const Settings* names)
    : QWidget(parent), store_(store), actor_(actor), ports_(ports), model_(new PeopleModel(this)), names_(names) {
  auto* outer = new QVBoxLayout(this);
  outer->setContentsMargins(px(24), px(16), px(24), px(24));
  outer->setSpacing(px(12));
  auto* head = new PageHead(tr("People"));
  QPushButton* add = make_button(tr("Add a person"), ButtonKind::standard, u"plus"_qs, QKeySequence::New);
  QPushButton* import = make_button(tr("Import a list"), ButtonKind::standard, u"import"_qs);
  head->buttons()->addWidget(import);
  head->buttons()->addWidget(add);
  outer->addWidget(head);
  band_ = new Band;
  outer->addWidget(band_);
  outer->addWidget(make_filters());
  columns_ = new QHBoxLayout;
  columns_->setSpacing(px(16));
  auto* card = new Card;
  card->body()->setContentsMargins(px(8), px(8), px(8), px(8));
  table_ = new Table;
  table_->setAccessibleName(tr("People"));
  table_->setModel(model_);
  table_->setSortingEnabled(true);
  table_->sortByColumn(PeopleModel::kName, Qt::AscendingOrder);
  table_->set_stretch_column(PeopleModel::kName);
  card->body()->addWidget(table_);
  columns_->addWidget(card, 1);
  auto* aside = new QVBoxLayout;
  aside->setSpacing(px(16));
  aside->addWidget(make_form());
  departed_ = new DepartedCard(records_of(store), actor, ports);
  aside->addWidget(departed_);
  aside->addStretch();
  columns_->addLayout(aside);
  outer->addLayout(columns_, 1);

  connect(departed_, &DepartedCard::reported, band_, &Band::show_message);
  connect(departed_, &DepartedCard::erased, this, &PeoplePage::read);
  connect(add, &QPushButton::clicked, this, [this] {
    leave_form([this] {
      band_->clear();
      begin_new();
    });
  });
  connect(import, &QPushButton::clicked, this, &PeoplePage::import_wanted);
  connect(table_, &Table::row_opened, this, [this] { name_->setFocus(); });
  read();
  connect(table_->selectionModel(), &QItemSelectionModel::selectionChanged, this, &PeoplePage::show_chosen);
  if (model_->rowCount() > 0) {
    table_->choose_row(0);
  } else {
    begin_new();
  }
  setFocusProxy(table_);
}

void PeoplePage::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  const bool beside = width() >= px(kBesideFrom);
  columns_->setDirection(beside ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
  for (QWidget* card : std::initializer_list<QWidget*>{form_, departed_}) {
    card->setMinimumWidth(beside ? px(kFormWide) : 0);
    card->setMaximumWidth(beside ? px(kFormWide) : QWIDGETSIZE_MAX);
  }
  table_->setMinimumHeight(beside ? 0 : px(kListLeast));
}

QString PeoplePage::message() const { return band_->isVisibleTo(this) ? band_->text() : QString(); }

QWidget* PeoplePage::make_filters() {
  auto* bar = new QWidget;
  auto* row = new HeadRow(bar);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(px(8));
  search_ = make_search_field(tr("Find somebody"), px(220));
  count_ = make_label({}, TextRole::body, Weight::regular, "text2");
  shown_role_ = make_choice(tr("Shown roles"));
  shown_role_->addItem(tr("All roles"));
  for (const Role role : {Role::student, Role::instructor, Role::administrator}) shown_role_->addItem(role_name(role));
  connect(search_, &QLineEdit::textChanged, this, &PeoplePage::filter);
  connect(shown_role_, &QComboBox::currentIndexChanged, this, &PeoplePage::filter);
  for (QWidget* part : std::initializer_list<QWidget*>{search_, count_, shown_role_}) row->addWidget(part);
  return bar;
}

void PeoplePage::filter() {
  const int role = shown_role_->currentIndex();
  model_->narrow(search_->text(), role > 0 ? std::optional(static_cast<Role>(role - 1)) : std::nullopt);
  count_->setText(tr("%n person(s)", nullptr, model_->rowCount()));
  if (half_filled()) return;  // a search keeps what the form holds
  table_->choose_row(0);
}

QWidget* PeoplePage::make_form() {
  form_ = new Card(tr("Add a person"));
  form_->wrap_title();  // a name
  same_person_ = make_paragraph({});
  same_person_->hide();
  form_->body()->addWidget(same_person_);
  name_ = new QLineEdit;
  number_ = new QLineEdit;
  role_ = new QComboBox;
  for (const Role role : {Role::student, Role::instructor, Role::administrator}) role_->addItem(role_name(role));
  secret_ = new QLineEdit;
  secret_->setEchoMode(QLineEdit::Password);
  constexpr int kBetween = 4;  // px at 100 %, beyond the card's own
  QFormLayout* fields = ui::make_form();
  form_->body()->addLayout(fields);
  add_field(*fields, tr("Name"), name_);
  add_field(*fields, tr("Number or user name"), number_, kBetween);
  add_field(*fields, tr("Role"), role_, kBetween);
  secret_label_ = add_field(*fields, tr("PIN, six digits"), secret_, kBetween);
  secret_note_ = make_label({}, TextRole::caption, Weight::regular, "text2");
  secret_note_->setWordWrap(true);
  form_->body()->addWidget(secret_note_);
  form_->body()->addSpacing(px(8));
  save_ = make_button(tr("Add"), ButtonKind::primary);
  wait_.emplace(save_);
  form_->body()->addWidget(save_);
  switch_ = make_button(tr("Switch account off"), ButtonKind::erase);
  form_->body()->addWidget(switch_);
  connect(role_, &QComboBox::currentIndexChanged, this, &PeoplePage::fit_secret);
  connect(save_, &QPushButton::clicked, this, &PeoplePage::save);
  for (QLineEdit* field : {name_, number_, secret_}) connect(field, &QLineEdit::textChanged, this, &PeoplePage::fit_save);
  connect(role_, &QComboBox::currentIndexChanged, this, &PeoplePage::fit_save);
  connect(secret_, &QLineEdit::returnPressed, this, &PeoplePage::save);
  connect(switch_, &QPushButton::clicked, this, &PeoplePage::switch_account);
  erase_ = make_button(tr("Erase the person"), ButtonKind::erase);
  form_->body()->addWidget(erase_);
  connect(erase_, &QPushButton::clicked, this, &PeoplePage::erase_person);
  return form_;
}

void PeoplePage::fit_secret() {
  const bool student = role_->currentIndex() == 0;
  const QString label = student   ? (edited_ ? tr("New PIN, six digits") : tr("PIN, six digits"))
                        : edited_ ? tr("New password, at least 8 characters")
                                  : tr("Password, at least 8 characters");
  secret_label_->setText(label);
  secret_->setAccessibleName(label);
  const bool own = edited_ && edited_->id == actor_.id;  // it asks for the old password
  secret_->setEnabled(!own);
  secret_note_->setText(own       ? tr("You change your own password under your name at the top.")
                        : edited_ ? tr("Leave it empty to keep the one there is.")
                        : student ? tr("Without a PIN the number alone signs in.")
                                  : tr("Staff change it themselves under their name at the top."));
}

void PeoplePage::begin_new() {
  edited_.reset();
  table_->clearSelection();
  form_->set_title(tr("Add a person"));
  for (QLineEdit* field : {name_, number_, secret_}) field->clear();
  role_->setCurrentIndex(0);
  fit_save();
  switch_->hide();
  erase_->hide();
  fit_secret();
  show_doubles();
  name_->setFocus();
}

void PeoplePage::show_chosen() {
  const int row = table_->chosen_row();
  if (row < 0) return;
  const Account account = model_->account(row);
  if (edited_ && edited_->id == account.id) return show_person(account);
  leave_form([this, account] {
    band_->clear();  // it speaks of another person
    show_person(account);
  });
}

void PeoplePage::leave_form(std::function<void()> then) {
  if (!half_filled() || waiting()) return then();
  ports_.ask(this, leave_form_question(), [self = QPointer(this), then = std::move(then)](bool yes) {
    if (!self) return;
    if (yes) return then();
    const int row = self->edited_ ? self->model_->row_of(self->edited_->id) : -1;  // a search may hide it
    row >= 0 ? self->table_->choose_row(row) : self->table_->clearSelection();
  });
}

void PeoplePage::show_person(const Account& account) {
  // A list that is read anew keeps what is typed, and shows what another desk has changed.
  const std::optional<Account> was = edited_ && edited_->id == account.id ? edited_ : std::nullopt;
  edited_ = account;
  form_->set_title(QString::fromStdString(edited_->name));
  const auto fit = [&](QLineEdit& text, const std::string Account::*what) {
    if (was && text.text().trimmed() != QString::fromStdString((*was).*what)) return;
    const QString fresh = QString::fromStdString((*edited_).*what);
    if (text.text() == fresh) return;
    text.setText(fresh);
    if (!text.hasFocus()) text.setCursorPosition(0);  // of a long text its beginning shows
  };
  fit(*name_, &Account::name);
  fit(*number_, &Account::number);
  if (!was || role_->currentIndex() == static_cast<int>(was->role)) role_->setCurrentIndex(static_cast<int>(edited_->role));
  if (!was) secret_->clear();
  fit_save();
  const QString act = edited_->disabled ? tr("Switch account on") : tr("Switch account off");
  switch_->setText(act);
  switch_->setAccessibleName(act);
  switch_->setVisible(edited_->id != actor_.id);
  erase_->setVisible(edited_->id != actor_.id);
  fit_secret();
  show_doubles();
}

void PeoplePage::read() {
  auto accounts = store_.accounts.list(actor_);
  if (!accounts) {
    const Message message = describe(accounts.error());
    band_->show_message(Band::Kind::bad, message.what, message.more);
    return;
  }
  doubles_ = possible_doubles(store_.context(), actor_).value_or(std::vector<PossibleDouble>{});  // the list without them is better than none
  if (edited_) {
    const auto now = std::ranges::find(*accounts, edited_->id, &Account::id);
    now != accounts->end() ? show_person(*now) : begin_new();
  }
  std::map<UserId, QStringList> cohorts;  // a table without them is better than none
  if (const auto list = store_.cohorts.list())
    for (const Cohort& cohort : *list)
      if (const auto students = store_.cohorts.students(cohort.id))
        for (const UserId student : *students) cohorts[student] << QString::fromStdString(cohort.name);
  model_->set_accounts(std::move(*accounts), std::move(cohorts));
  count_->setText(tr("%n person(s)", nullptr, model_->rowCount()));
  if (edited_) table_->choose_row(model_->row_of(edited_->id));  // a search may hide it
}

bool PeoplePage::read_again() {
  band_->clear();  // it speaks of what was before
  read();
  return true;
}

bool PeoplePage::show_if_failed(const Stored<void>& done, const Account& account) {
  if (done) return false;
  const Message message = describe_account(done.error(), QString::fromStdString(account.number), account.role == Role::student ? Secret::pin : Secret::password);
  read();
  band_->show_message(Band::Kind::bad, message.what, message.more);
  return true;
}

void PeoplePage::save() {
  if (waiting()) return;
  const auto take_marks_out = [this](QLineEdit& field, QString (*without)(QString), const std::string Account::*what) {
    if (!edited_ || field.text().trimmed() != QString::fromStdString((*edited_).*what)) field.setText(without(field.text()));
  };
  take_marks_out(*number_, without_marks, &Account::number);  // a web page or a spreadsheet leaves them in what is pasted
  take_marks_out(*name_, without_marks_but_joiners, &Account::name);
  const AccountChange change{edited_, number_->text().trimmed().toStdString(), name_->text().trimmed().toStdString(),
                             static_cast<Role>(role_->currentIndex()), secret_->text().toStdString()};
  if (change.name.empty() || change.number.empty()) {
    band_->show_message(Band::Kind::bad, tr("Name and number are needed."), {});
    (change.name.empty() ? name_ : number_)->setFocus();
    return;
  }
  wait_->start(tr("Saving…"));
  saving_ = with_own_store(store_, [self = QPointer(this), actor = actor_, change](OwnStore own) {
    const auto done = std::make_shared<Stored<void>>(own ? write_change((*own)->accounts, actor, change) : Stored<void>(std::unexpected(own.error())));
    QMetaObject::invokeMethod(
        qApp,
        [self, change, done] {
          if (self) self->show_saved(change, *done);
        },
        Qt::QueuedConnection);
  });
}

void PeoplePage::show_saved(const AccountChange& change, const Stored<void>& done) {
  wait_->finish();
  if (!done) {
    const Message message = describe_account(done.error(), QString::fromStdString(change.number), change.role == Role::student ? Secret::pin : Secret::password);
    if (change.before) read();  // the role may be written, the name refused; another desk may have erased the person
    fit_save();
    band_->show_message(Band::Kind::bad, message.what, message.more);
    return;
  }
  const QString name = QString::fromStdString(change.name);
  if (change.before) secret_->clear();
  if (save_->hasFocus()) table_->setFocus();  // what is saved cannot be saved again: the button hands the focus on
  read();
  fit_save();
  band_->show_message(Band::Kind::good, change.before ? tr("%1 is saved.").arg(name) : tr("%1 is added.").arg(name), {});
  if (change.before || edited_) return;
  begin_new();
  save_->setEnabled(false);  // until something is typed: a double click presses it twice
}

void PeoplePage::fit_save() {
  const QString text = edited_ ? tr("Save changes") : tr("Add");
  save_->setText(text);
  save_->setAccessibleName(text);
  save_->setEnabled(waiting() || changed());
}

/// A new person counts as one.
bool PeoplePage::changed() const {
  return !edited_ || !secret_->text().isEmpty() || name_->text().trimmed() != QString::fromStdString(edited_->name) ||
         number_->text().trimmed() != QString::fromStdString(edited_->number) || role_->currentIndex() != static_cast<int>(edited_->role);
}

bool PeoplePage::half_filled() const {
  return edited_ ? changed() : !name_->text().isEmpty() || !number_->text().isEmpty() || !secret_->text().isEmpty();
}

void PeoplePage::switch_account() {
  if (!edited_) return;
  const Account account = *edited_;
  const bool off = !account.disabled;
  const QString name = QString::fromStdString(account.name);
  const auto act = [this, account, off, name] {
    if (show_if_failed(off ? store_.accounts.disable(actor_, account.id) : store_.accounts.enable(actor_, account.id), account)) return;
    read();
    band_->show_message(off ? Band::Kind::look : Band::Kind::good,
                        off ? tr("%1 can no longer sign in.").arg(name) : tr("%1 can sign in again.").arg(name),
                        off ? tr("All results are kept.") : QString());
  };
  if (!off) {
    act();
    return;
  }
  ports_.ask(this, {tr("Switch off the account of %1?").arg(name),
                    tr("They can no longer sign in. All results are kept, and you can switch it on again."),
                    tr("Switch account off"), true},
             [act](bool yes) {
               if (yes) act();
             });
}

void PeoplePage::erase_person() {
  if (!edited_) return;
  const Account account = *edited_;
  const QString name = QString::fromStdString(account.name);
  ports_.ask(this, {tr("Erase %1 for good?").arg(name),
                    tr("Name, number and PIN go, and every text about this person's attempts. The attempts stay under a pseudonym. "
                       "It cannot be undone; backups made before still hold the name."),
                    tr("Erase"), true},
             [this, account](bool yes) {
               if (!yes || show_if_failed(store_.accounts.erase(actor_, account.id), account)) return;
               read();
               begin_new();
               band_->show_message(Band::Kind::good, tr("The person is erased."), tr("The attempts stay under a pseudonym."));
             });
}

}  // namespace cusp::ui
