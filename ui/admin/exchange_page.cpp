#include "ui/admin/exchange_page.h"

#include <QBoxLayout>
#include <QClipboard>
#include <QGuiApplication>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QStackedWidget>

#include "ui/admin/exchange_cards.h"
#include "ui/admin/on_window.h"
#include "ui/text/exchange_text.h"
#include "ui/text/incident_text.h"
#include "ui/widgets/busy.h"
#include "ui/widgets/empty_state.h"
#include "ui/widgets/format.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/table.h"
#include "ui/widgets/save_bytes.h"

namespace cusp::ui {
namespace {

QString id_text(const Uuid& station) { return QString::fromStdString(station.text()); }

bool counts(KeyRole role) { return role == KeyRole::station || role == KeyRole::office; }

QString name_not_kept(const Settings& settings) {
  return ExchangePage::tr("%1 cannot be written, so the next start does not know the name.").arg(isolate(settings.file()));
}

}  // namespace

ExchangePage::ExchangePage(Store& store, const Actor& actor, Settings& settings, const Ports& ports, QWidget* parent)
    : QWidget(parent), store_(store), actor_(actor), settings_(settings), ports_(ports), model_(new StationsModel(this)), run_(new WorkRun(this)) {
  auto* whole = new QVBoxLayout(this);
  whole->setContentsMargins(0, 0, 0, 0);
  QVBoxLayout* outer = nullptr;
  whole->addWidget(make_scroll_page(&outer));
  outer->addWidget(make_head());
  band_ = new Band;
  outer->addWidget(band_);
  outer->addWidget(run_->busy());
  main_ = new QStackedWidget;
  main_->addWidget(make_stations());
  outer->addWidget(main_, 1);
  columns_ = new QHBoxLayout;
  columns_->setSpacing(px(16));
  columns_->addWidget(make_own_key(), 1);
  columns_->addWidget(make_giving_out(), 1);
  outer->addLayout(columns_);
  read_stations();
  setFocusProxy(read_);
}

QString ExchangePage::message() const { return band_->isVisibleTo(this) ? band_->text() : QString(); }
QString ExchangePage::own_name() const { return settings_.station_name(id_text(store_.context().station)); }
QString ExchangePage::name_of(const Uuid& station) const { return station_text(settings_.station_name(id_text(station)), station); }


QString ExchangePage::name_in_file() const {
  QString out;
  for (const QChar c : name_of(store_.context().station)) out += c.isLetterOrNumber() ? c : u'-';
  return out;
}

QWidget* ExchangePage::make_head() {
  auto* head = new PageHead(tr("Other stations"));
  read_ = make_button(tr("Read a file in"), ButtonKind::primary, u"import"_qs, QKeySequence::Open);
  head->buttons()->addWidget(read_);
  connect(read_, &QPushButton::clicked, this, &ExchangePage::choose_file);
  return head;
}

QWidget* ExchangePage::make_stations() {
  auto* card = new Card(tr("Whose files are read here"));
  list_ = new QStackedWidget;
  table_ = new Table;
  table_->setAccessibleName(tr("Known stations"));
  table_->setModel(model_);
  table_->set_stretch_column(StationsModel::kName);
  list_->addWidget(table_);
  auto* none = new EmptyState(u"monitor"_qs, tr("No other station is known yet"),
                              tr("Records go from station to station as files, without a server. A station reads the files of those alone whose keys an administrator has compared and made known."),
                              tr("Choose a station’s key"));
  connect(none, &EmptyState::acted, this, &ExchangePage::choose_key);
  list_->addWidget(none);
  card->body()->addWidget(list_, 1);
  acts_ = new QHBoxLayout;
  acts_->setSpacing(px(8));
  add_ = make_button(tr("Make a station known"), ButtonKind::standard, u"plus"_qs);
  open_ = make_button(tr("Change"), ButtonKind::standard, u"edit"_qs);
  revoke_ = make_button(tr("Revoke the key"), ButtonKind::erase);
  for (QPushButton* button : {add_, open_}) acts_->addWidget(button);
  acts_->addStretch();
  acts_->addWidget(revoke_);
  card->body()->addLayout(acts_);
  connect(add_, &QPushButton::clicked, this, &ExchangePage::choose_key);
  connect(open_, &QPushButton::clicked, this, &ExchangePage::open_station);
  connect(revoke_, &QPushButton::clicked, this, &ExchangePage::revoke_station);
  connect(table_, &Table::row_opened, this, &ExchangePage::open_station);
  connect(table_->selectionModel(), &QItemSelectionModel::selectionChanged, this, &ExchangePage::show_chosen);
  return card;
}

QWidget* ExchangePage::make_own_key() {
  auto* card = new Card(tr("This station"));
  name_ = new QLineEdit(own_name());
  name_->setMaxLength(60);
  name_->setPlaceholderText(tr("Clinic, room 1"));
  card->body()->addWidget(labelled(tr("What you call it; files are named after it"), name_));
  connect(name_, &QLineEdit::editingFinished, this, [this] {
    // Also whenever the focus leaves the field: what was reported once is not reported again.
    if (name_->text().trimmed() == own_name() || settings_.set_station_name(id_text(store_.context().station), name_->text())) return;
    band_->show_message(Band::Kind::bad, tr("The name holds until Cusp is closed."), name_not_kept(settings_));
  });
  const auto& key = store_.context().key;
  if (!key) {
    card->body()->addWidget(make_note(tr("The records were opened for reading: their key is not there.")));
    return card;
  }
  card->body()->addWidget(make_note(tr("Fingerprint of its key, to be read aloud and compared at the other station")));
  QLabel* shown = make_label(fingerprint(key->id()), TextRole::live, Weight::bold);
  shown->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  shown->setAccessibleName(tr("Fingerprint %1").arg(fingerprint(key->id())));
  card->body()->addWidget(shown);
  auto* row = new QHBoxLayout;
  row->setSpacing(px(8));
  QPushButton* save = make_button(tr("Save the key as a file"), ButtonKind::standard, u"key"_qs);
  QPushButton* copy = make_button(tr("Copy"), ButtonKind::standard, u"copy"_qs);
  copy->setAccessibleName(tr("Copy the fingerprint"));
  row->addWidget(save);
  row->addWidget(copy);
  row->addStretch();
  card->body()->addLayout(row);
  connect(save, &QPushButton::clicked, this, &ExchangePage::save_key);
  card->body()->addStretch();
  connect(copy, &QPushButton::clicked, this, &ExchangePage::copy_fingerprint);
  return card;
}

QWidget* ExchangePage::make_giving_out() {
  auto* card = new Card(tr("Give out a file"));
  results_ = make_button(tr("Results for the office"), ButtonKind::standard, u"export"_qs);
  office_ = make_button(tr("People and assignments"), ButtonKind::standard, u"export"_qs);
  card->body()->addWidget(results_, 0, Qt::AlignLeading);
  card->body()->addWidget(make_note(tr("Every ended attempt of this station, its grades and what examiners said.")));
  card->body()->addSpacing(px(8));
  card->body()->addWidget(office_, 0, Qt::AlignLeading);
  card->body()->addWidget(make_note(tr("From the office to the stations: people, cohorts, assignments and exercises. It holds passwords and PINs in scrambled form: "
                                     "keep it as safe as the records.")));
  connect(results_, &QPushButton::clicked, this, &ExchangePage::give_out_results);
  card->body()->addStretch();
  connect(office_, &QPushButton::clicked, this, &ExchangePage::give_out_office);
  return card;
}

void ExchangePage::read_stations() {
  const auto keys = other_keys(store_.context(), actor_);
  const auto files = files_read_in(store_.context(), actor_);
  if (!keys || !files) return show_failure(tr("The other stations cannot be listed."), describe(keys ? files.error() : keys.error()));
  std::vector<KnownStation> stations;
  for (const OtherKey& key : *keys) {
    KnownStation known{key, settings_.station_name(id_text(key.station)), {}};
    for (const FileReadIn& file : *files) {
      if (file.key == key.key) known.newest = file;
    }
    stations.push_back(std::move(known));
  }
  model_->set_stations(std::move(stations));
  list_->setCurrentIndex(model_->rowCount() == 0 ? 1 : 0);
  for (QPushButton* button : {add_, open_, revoke_}) button->setVisible(model_->rowCount() > 0);
  for (const int column : {StationsModel::kKey, StationsModel::kRole, StationsModel::kSince, StationsModel::kNewest}) {
    table_->resizeColumnToContents(column);
  }
  table_->choose_row(0);
  show_chosen();
}

void ExchangePage::show_chosen() {
  const int row = table_->chosen_row();
  open_->setEnabled(row >= 0);
  revoke_->setEnabled(row >= 0 && counts(model_->station(row).key.role));
}

void ExchangePage::show_step(Step step, Card* card) {
  back_to_stations();
  step_ = step;
  main_->addWidget(card);
  main_->setCurrentWidget(card);
  read_->setEnabled(false);
  card->setFocus();
}

void ExchangePage::back_to_stations() {
  step_ = Step::stations;
  read_->setEnabled(!working());
  if (main_->count() < 2) return;
  QWidget* old = main_->widget(1);
  main_->removeWidget(old);
  old->deleteLater();
  (model_->rowCount() > 0 ? static_cast<QWidget*>(table_) : read_)->setFocus();
}

void ExchangePage::show_failure(const QString& what, const Message& message) {
  band_->show_message(Band::Kind::bad, what.isEmpty() ? message.what : what, what.isEmpty() ? message.more : message.line());
}

/// It is no failure: somebody wanted it.
void ExchangePage::show_stopped(const QString& what) { band_->show_message(Band::Kind::look, what, tr("You stopped it. Nothing was changed.")); }

void ExchangePage::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  const auto direction = [this](int from) { return width() < px(from) ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight; };
  columns_->setDirection(direction(kStackBelow));
  acts_->setDirection(direction(kActsBelow));
}

void ExchangePage::save_key() {
  const auto key = own_key(store_.context(), actor_);
  if (!key) return show_failure({}, describe(key.error()));
  FileWish wish;
  wish.title = tr("Save this station’s key");
  wish.name = u"cusp-key-%1.cuspkey"_qs.arg(name_in_file());
  wish.filter = tr("Key of a station (*.cuspkey)");
  ports_.pick_file(this, wish, [this, bytes = QByteArray::fromStdString(key_file_of(*key))](const QString& path) {
    if (const auto written = save_bytes(path, bytes)) {
      band_->show_message(Band::Kind::good, tr("The key is saved."), tr("Take %1 to the other station, and tell its administrator the fingerprint.").arg(isolate(path)));
    } else {
      band_->show_message(Band::Kind::bad, tr("The key was not saved."), tr("%1: %2.").arg(isolate(path), written.error()));
    }
  });
}

void ExchangePage::copy_fingerprint() {
  QGuiApplication::clipboard()->setText(fingerprint(store_.context().key->id()));
  band_->show_message(Band::Kind::good, tr("The fingerprint is copied."), {});
}

void ExchangePage::choose_key() {
  if (working()) return;
  FileWish wish;
  wish.title = tr("Choose a station’s key");
  wish.filter = tr("Key of a station (*.cuspkey)") + u";;"_qs + tr("All files (*)");
  wish.saving = false;
  ports_.pick_file(this, wish, [this](const QString& path) {
    const auto key = public_key_in(path.toStdString());
    if (!key) return show_failure({}, describe_key_failure(key.error(), path));
    band_->clear();
    waiting_.reset();
    ask_for_key({.key = *key});
  });
}

void ExchangePage::open_station() {
  const int row = table_->chosen_row();
  if (working() || row < 0) return;
  const OtherKey& known = model_->station(row).key;
  band_->clear();
  waiting_.reset();
  ask_for_key({.key = {known.station, known.public_key}});
}

void ExchangePage::ask_for_key(const KeyToTrust& asked) {
  KeyToTrust shown = asked;
  read_stations();
  table_->choose_row(model_->row_of(key_id(asked.key.bytes)));
  shown.known = role_of(asked.key);
  if (shown.known == KeyRole::office) shown.offered = KeyRole::office;
  shown.name = settings_.station_name(id_text(asked.key.station));
  auto* card = new TrustCard(shown);
  connect(card, &TrustCard::left, this, &ExchangePage::back_to_stations);
  connect(card, &TrustCard::agreed, this, [this, key = asked.key, known = shown.known](KeyRole role, const QString& name) {
    trust_key(key, known, role, name);
  });
  show_step(Step::key, card);
}

std::optional<KeyRole> ExchangePage::role_of(const PublicKey& key) const {
  const int row = model_->row_of(key_id(key.bytes));
  return row >= 0 ? std::optional(model_->station(row).key.role) : std::nullopt;
}

void ExchangePage::trust_key(const PublicKey& key, std::optional<KeyRole> known, KeyRole role, const QString& name) {
  read_stations();
  if (role_of(key) != known) {
    back_to_stations();
    table_->choose_row(model_->row_of(key_id(key.bytes)));
    band_->show_message(Band::Kind::look, tr("The key of %1 was changed in another window meanwhile.").arg(isolate(name_of(key.station))),
                        tr("The list shows it as it is now. Nothing was changed here."));
    return;
  }
  const bool as_it_is = known == role;
  if (const auto done = as_it_is ? Stored<void>() : trust(store_.context(), actor_, key, role); !done) {
    return show_failure({}, describe(done.error()));
  }
  const bool kept = settings_.set_station_name(id_text(key.station), name);
  read_stations();
  table_->choose_row(model_->row_of(key_id(key.bytes)));
  const QString who = isolate(name_of(key.station)), known_now = tr("%1 is known: its files are read from now on.").arg(who);
  if (kept) {
    band_->show_message(Band::Kind::good, as_it_is ? tr("%1 is saved.").arg(who) : known_now);
  } else {
    band_->show_message(Band::Kind::bad, as_it_is ? tr("The name holds until Cusp is closed.") : known_now, name_not_kept(settings_));
  }
  if (waiting_) return show_file(*std::exchange(waiting_, std::nullopt));
  back_to_stations();
}

void ExchangePage::revoke_station() {
  const int row = table_->chosen_row();
  if (working() || row < 0) return;
  const KnownStation known = model_->station(row);
  const QString who = station_text(known.name, known.key.station);
  ports_.ask(this, {tr("Revoke the key of %1?").arg(isolate(who)),
                    tr("Files under key %1 are no longer read. All that was read before stays.").arg(fingerprint(known.key.key)),
                    tr("Revoke the key"), true},
             [this, known, who](bool yes) {
               if (!yes) return;
               if (const auto done = revoke(store_.context(), actor_, known.key.key); !done) return show_failure({}, describe(done.error()));
               read_stations();
               table_->choose_row(model_->row_of(known.key.key));
               band_->show_message(Band::Kind::look, tr("The key of %1 is revoked.").arg(isolate(who)), tr("All that was read before stays."));
             });
}

}  // namespace cusp::ui
