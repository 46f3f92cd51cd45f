// How the desktop opens the records: for writing, or where the disk takes nothing more for reading.

#include "ui/app/desktop.h"
#include "ui/signin/sign_in.h"
#include "ui/text/incident_text.h"
#include "ui/widgets/empty_state.h"
#include "ui/widgets/parts.h"

namespace cusp::ui {
namespace {

/// A disk that takes nothing more can still be read.
bool may_be_read(StorageError code) {
  return code == StorageError::read_only || out_of_space(code) || code == StorageError::io;
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
  if (!store && may_be_read(store.error().code)) {
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
    show_refusal(describe(store.error()));
    return;
  }
  store_ = std::move(*store);
  show_sign_in(new SignIn(*store_));
}

void Desktop::show_refusal(const Message& message) {
  auto* state = new EmptyState(u"warning"_qs, message.what, message.more, tr("Try again"), Ink::bad);
  connect(state, &EmptyState::acted, this, &Desktop::start);
  replace_root(make_page(state));
}

std::optional<Message> Desktop::incident() {
  const auto& met = store_->context().incident;
  return met ? std::optional(describe_incident(*met, database_)) : std::nullopt;
}

std::optional<Message> Desktop::why_reading_only() const {
  return reading_only_ ? std::optional(describe_reading_only(*reading_only_, database_)) : std::nullopt;
}

}  // namespace cusp::ui
