// Giving a file out and reading one in, in the background.

#include <QFile>
#include <QPushButton>
#include <utility>

#include "storage/base/hash.h"
#include "ui/admin/exchange_cards.h"
#include "ui/admin/exchange_page.h"
#include "ui/admin/on_window.h"
#include "ui/text/exchange_text.h"
#include "ui/widgets/format.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/table.h"

namespace cusp::ui {
namespace {

/// The failure that read_in() would end with, before the file is shown.
std::optional<StorageFailure> refusal_of(const ExchangeLook& look) {
  if (look.role != KeyRole::revoked) return std::nullopt;
  return StorageFailure{StorageError::revoked_key, look.description.station.text(), hex(key_id(look.signer.bytes))};
}

template <class Outcome>
bool was_stopped(const Stored<Outcome>& outcome) {
  return !outcome && outcome.error().code == StorageError::stopped;
}

/// Whether an administrator has to compare the key before the file can be read.
bool asks_for_key(const ExchangeLook& look) {
  if (!look.role || look.role == KeyRole::former) return true;
  return look.description.kind == ExchangeKind::office && look.role == KeyRole::station;
}

}  // namespace

ExchangeWork ExchangePage::begin(const QString& what, const QString& file, WorkRun::Counted counted) {
  band_->clear();
  auto progress = run_->start(what, std::move(counted));
  for (QWidget* part : {static_cast<QWidget*>(read_), static_cast<QWidget*>(main_), static_cast<QWidget*>(results_), static_cast<QWidget*>(office_)}) {
    part->setEnabled(false);
  }
  return {records_of(store_), file.toStdString(), actor_, std::move(progress)};
}

void ExchangePage::end() {
  for (QWidget* part : {static_cast<QWidget*>(main_), static_cast<QWidget*>(results_), static_cast<QWidget*>(office_)}) part->setEnabled(true);
  read_->setEnabled(step_ == Step::stations);
  run_->finish();
}

void ExchangePage::give_out_results() { give_out_to(ExchangeKind::results); }
void ExchangePage::give_out_office() { give_out_to(ExchangeKind::office); }

void ExchangePage::give_out_to(ExchangeKind kind) {
  if (working()) return;
  FileWish wish;
  wish.title = kind == ExchangeKind::office ? tr("Give out people and assignments") : tr("Give out results");
  wish.name = u"cusp-%1-%2-%3.cuspexchange"_qs.arg(kind == ExchangeKind::office ? u"office"_qs : u"results"_qs,
                                                   name_in_file(),
                                                   ports_.now().toString(u"yyyy-MM-dd-HHmm"_qs));
  wish.filter = tr("File of a station (*.cuspexchange)");
  wish.what = FileWish::What::new_file;
  ports_.pick_file(this, wish, [this, kind](const QString& path) {
    if (QFile::exists(path)) {
      const StorageFailure taken{StorageError::duplicate, path.toStdString(), {}};
      return show_failure({}, describe_exchange_failure(taken, path));
    }
    given_ = path;
    ExchangeWork work = begin(tr("Writing the file"), given_, [kind](std::size_t done, std::size_t all) {
      return (kind == ExchangeKind::office ? tr("Copied %1 of %2 people") : tr("Copied %1 of %2 attempts")).arg(count_text(done), count_text(all));
    });
    task_ = give_out_file(std::move(work), kind, on_window<Stored<GivenOut>>(this, &ExchangePage::show_given_out));
  });
}

void ExchangePage::show_given_out(const Stored<GivenOut>& given) {
  end();
  if (was_stopped(given)) return show_stopped(tr("No file was given out."));
  if (!given) return show_failure(tr("No file was given out."), describe_exchange_failure(given.error(), given_));
  band_->show_message(Band::Kind::good, tr("File %1 of this station is written: %2.").arg(given->description.number()).arg(counts_text(given->counts)),
                      given->description.kind == ExchangeKind::office ? tr("%1. Read it in at each station.").arg(isolate(given_))
                                                                      : tr("%1. Read it in at the office.").arg(isolate(given_)));
}

void ExchangePage::choose_file() {
  if (working()) return;
  FileWish wish;
  wish.title = tr("Choose a file of another station");
  wish.filter = tr("File of a station (*.cuspexchange)") + u";;"_qs + tr("All files (*)");
  wish.saving = false;
  ports_.pick_file(this, wish, [this](const QString& path) { look_into(path); });
}

void ExchangePage::look_into(const QString& path) {
  file_ = path;
  // Attempts of a results file, or people of an office file: the outcome shows which it is.
  ExchangeWork work = begin(tr("Checking the file"), file_, [](std::size_t done, std::size_t all) {
    return tr("Checked %1 of %2").arg(count_text(done), count_text(all));
  });
  task_ = look_into_file(std::move(work), on_window<Stored<ExchangeLook>>(this, &ExchangePage::show_look));
}

void ExchangePage::show_look(const Stored<ExchangeLook>& look) {
  end();
  if (was_stopped(look)) return show_stopped(tr("The file was not checked."));
  if (!look) return show_failure({}, describe_exchange_failure(look.error(), file_));
  if (const auto refused = refusal_of(*look)) return show_failure({}, describe(*refused));
  if (!asks_for_key(*look)) return show_file(*look);
  waiting_ = *look;
  const bool office = look->description.kind == ExchangeKind::office;
  if (look->role == KeyRole::station) {
    band_->show_message(Band::Kind::look, tr("This station is not known as the office here."),
                        tr("Only the office’s files bring people and assignments. Make it known as the office, or go back. Nothing was changed."));
  } else {
    band_->show_message(Band::Kind::look, tr("The file is of a station that is not known here."),
                        tr("Compare the fingerprint before you make it known. Nothing was changed."));
  }
  ask_for_key({.key = look->signer, .offered = office ? KeyRole::office : KeyRole::station});
}

void ExchangePage::show_file(const ExchangeLook& look) {
  kind_ = look.description.kind;
  auto* card = new FileCard({look, name_of(look.description.station), file_});
  connect(card, &FileCard::left, this, &ExchangePage::back_to_stations);
  connect(card, &FileCard::agreed, this, &ExchangePage::read_in);
  show_step(Step::file, card);
}

void ExchangePage::read_in() {
  if (working()) return;
  ExchangeWork work = begin(tr("Reading the file in"), file_, [kind = kind_](std::size_t done, std::size_t all) {
    return (kind == ExchangeKind::office ? tr("Read %1 of %2 people") : tr("Read %1 of %2 attempts")).arg(count_text(done), count_text(all));
  });
  task_ = read_file_in(std::move(work), on_window<Stored<ReadIn>>(this, &ExchangePage::show_read_in));
}

void ExchangePage::show_read_in(const Stored<ReadIn>& read) {
  end();
  if (was_stopped(read)) {
    main_->currentWidget()->setFocus();
    return show_stopped(tr("The file was not read."));
  }
  back_to_stations();
  if (!read) return show_failure({}, describe_exchange_failure(read.error(), file_));
  read_stations();
  table_->choose_row(model_->row_of(read->key));
  const bool all_well = read->outcome != ReadOutcome::late && read->conflicts.empty() && read->gave_way.empty() && read->apart.empty() && read->waiting == 0;
  QStringList more = read_in_text(*read);
  if (read->outcome == ReadOutcome::late) more += tr("For what has changed since, ask that station for a new file.");
  band_->show_message(all_well ? Band::Kind::good : Band::Kind::look, outcome_text(read->outcome), more.join(u' '));
}

}  // namespace cusp::ui
