// How the desktop opens the records: for writing, or where the disk takes nothing more for reading.

#include <QPointer>

#include "storage/retention/clock_doubt.h"
#include "ui/admin/way_back.h"
#include "ui/app/desktop.h"
#include "ui/app/quick_start.h"
#include "ui/render/opengl_allowed.h"
#include "ui/signin/sign_in.h"
#include "ui/text/incident_text.h"
#include "ui/widgets/empty_state.h"
#include "ui/widgets/parts.h"

namespace cusp::ui {
namespace {

constexpr int kBackupLookMs = 60'000;  // between two looks at whether a backup is due

/// A backup of all would take the place of records that are whole.
bool is_key(const StorageFailure& failure) { return failure.code == StorageError::corrupt && failure.detail == "key"; }

/// Whether the records themselves are damaged: only a backup helps. A file that is no database, and has no key, was never theirs.
bool is_damage(const StorageFailure& failure, const std::filesystem::path& database) {
  std::error_code ignored;
  const bool theirs = std::filesystem::exists(station_key_file(database), ignored);
  return (failure.code == StorageError::corrupt && !is_key(failure)) || failure.code == StorageError::bad_statement ||
         (failure.code == StorageError::not_a_database && theirs);
}

/// A disk that takes nothing more can still be read, and so can records without their key, and what is whole of damaged ones.
bool may_be_read(const StorageFailure& failure, const std::filesystem::path& database) {
  return failure.code == StorageError::read_only || out_of_space(failure.code) || failure.code == StorageError::io || is_key(failure) || is_damage(failure, database);
}

}  // namespace

Stored<std::unique_ptr<Store>> Desktop::open_records(StoreOptions options) const {
  if (reading_only_) options.database.access = DatabaseOptions::Access::read_only;
  return open_(database_, options);
}

void Desktop::start() {
  store_.reset();
  reading_only_.reset();
  auto store = open_records();
  if (!store && may_be_read(store.error(), database_)) {
    const StorageFailure cause = store.error();
    reading_only_ = cause;
    auto reading = open_records();
    if (reading) {
      store = std::move(reading);
    } else {
      reading_only_.reset();
    }
  }
  if (!store) {
    if (is_damage(store.error(), database_)) return show_way_back(describe(store.error()));
    return show_refusal(describe(store.error()));
  }
  store_ = std::move(*store);
  if (!reading_only_) backup_timer_.start(kBackupLookMs);
  show_sign_in(new SignIn(*store_));
}

void Desktop::offer_safe_start() {
  const Question question{.what = tr("Cusp ended unexpectedly last time. Start without 3D pictures?"),
                          .more = tr("Without them this station can grade, replay and administer, and nobody can drill."),
                          .act = tr("Start without 3D pictures"),
                          .stay = tr("Start as usual")};
  ports_.ask(this, question, [self = QPointer(this)](bool without) {
    if (!self) return;
    if (without) forbid_opengl();
    self->start();
  });
}

void Desktop::show_refusal(const Message& message) {
  auto* state = new EmptyState(u"warning"_qs, message.what, message.more, tr("Try again"), Ink::bad);
  connect(state, &EmptyState::acted, this, &Desktop::start);
  QWidget* page = make_page(state);
  page->setFocusProxy(state->button());
  replace_root(page);
}

bool Desktop::records_damaged() const { return reading_only_ && is_damage(*reading_only_, database_); }

void Desktop::show_way_back(const Message& why) {
  auto* page = new WayBack(database_, settings_.backup_folder(database_), why, ports_);
  replace_root(page);
  store_.reset();  // the page before may hold it
  connect(page, &WayBack::try_again, this, &Desktop::start);
  connect(page, &WayBack::went_back, this, [this](const Message& done) {
    start();
    if (sign_in_) sign_in_->show_note(done);
  });
}

Message Desktop::why_going_back() const {
  if (reading_only_) return describe(*reading_only_);
  return {tr("Nobody manages these records yet."), tr("If this computer takes the place of another one, go back to a backup of that one.")};
}

std::optional<Message> Desktop::incident() {
  if (const auto& met = store_->context().incident) return describe_incident(*met, database_);
  const auto newest = clock_behind(store_->context());
  if (newest && *newest) return describe_clock_behind(**newest, store_->context().clock());
  return std::nullopt;
}

std::optional<Message> Desktop::why_reading_only() const {
  if (!reading_only_) return std::nullopt;
  return records_damaged() ? describe_damaged() : describe_reading_only(*reading_only_, database_);
}

void Desktop::show_quick_start() {
  auto* page = new QuickStart;
  connect(page, &QuickStart::back_wanted, this, &Desktop::back);
  push(page);
}

}  // namespace cusp::ui
