#include "ui/text/exchange_text.h"

#include <algorithm>

#include "ui/text/text.h"
#include "ui/widgets/format.h"

namespace cusp::ui {
namespace {

int shown(std::uint64_t count) { return static_cast<int>(count); }

}  // namespace

QString counts_text(const ExchangeCounts& c) {
  QStringList parts;
  if (c.sessions > 0) parts += Text::tr("%n attempt(s)", nullptr, shown(c.sessions));
  if (c.statements > 0) parts += Text::tr("%n statement(s) about attempts", nullptr, shown(c.statements));
  if (c.accounts > 0) parts += Text::tr("%n people", nullptr, shown(c.accounts));
  if (c.versions > 0) parts += Text::tr("%n exercise(s)", nullptr, shown(c.versions));
  if (c.assignments > 0) parts += Text::tr("%n assignment(s)", nullptr, shown(c.assignments));
  return parts.isEmpty() ? Text::tr("nothing") : installed_locale().createSeparatedList(parts);
}

QString exchange_kind_name(ExchangeKind kind) {
  return kind == ExchangeKind::office ? Text::tr("People, cohorts, assignments and exercises") : Text::tr("Results");
}

QString key_role_name(KeyRole role) {
  switch (role) {
    case KeyRole::station: return Text::tr("station");
    case KeyRole::office: return Text::tr("office");
    case KeyRole::former: return Text::tr("former key");
    case KeyRole::revoked: return Text::tr("revoked");
  }
  return {};
}

QString outcome_text(ReadOutcome outcome) {
  switch (outcome) {
    case ReadOutcome::read: return Text::tr("The file is read.");
    case ReadOutcome::again: return Text::tr("The file was read before.");
    case ReadOutcome::late: return Text::tr("The file was made before one that was already read: it adds what is new and changes nothing.");
  }
  return {};
}

QStringList read_in_text(const ReadIn& read) {
  ExchangeCounts fresh = read.counts;
  fresh.sessions -= read.grown;
  QStringList out{Text::tr("New here: %1.").arg(counts_text(fresh))};
  if (read.grown > 0) out += Text::tr("%n attempt(s) that were here have gone on.", nullptr, shown(read.grown));
  if (read.waiting > 0) {
    out += Text::tr("%n statement(s) wait for their attempt; read the file again after that of the other station.", nullptr, shown(read.waiting));
  }
  if (!read.apart.empty()) {
    out += Text::tr("%n attempt(s) went on from an old copy at the station, and stay here as they were.", nullptr, shown(read.apart.size()));
  }
  if (!read.gave_way.empty()) {
    out += Text::tr("%n account(s) made here gave the number to the office’s account of the same name; People shows both.", nullptr, shown(read.gave_way.size()));
  }
  for (const std::string& number : read.conflicts) {
    out += Text::tr("%1 was changed here too; the office’s account counts.").arg(isolate(text(number)));
  }
  return out;
}

QString departed_elsewhere_text(const std::vector<OtherKey>& known) {
  const auto knows = [&known](KeyRole role) { return std::ranges::any_of(known, [role](const OtherKey& key) { return key.role == role; }); };
  if (knows(KeyRole::office)) {
    return Text::tr("Erase at the office instead: its next file erases them here, too. Attempts at other stations do not count here, and who is erased here "
                    "stays so, also if the office’s next file brings the account.");
  }
  return knows(KeyRole::station) ? Text::tr("Attempts at other stations count once their files are read in: read the newest ones first.") : QString();
}

Message describe_exchange_failure(const StorageFailure& f, const QString& file) {
  const QString shown_file = isolate(file);
  switch (f.code) {
    case StorageError::not_a_database:
      return {Text::tr("This is no file of a station, or not as its station signed it."),
              Text::tr("%1 was not read. Ask for it once more; nothing was changed.").arg(shown_file)};
    case StorageError::newer_schema:
      return {Text::tr("A newer version of Cusp made this file."),
              Text::tr("Update Cusp on this station, then read %1 again. Nothing was changed.").arg(shown_file)};
    case StorageError::not_found:
      if (f.detail == "folder") return {Text::tr("There is no such folder."), Text::tr("%1 was not written. Choose another place.").arg(shown_file)};
      return {Text::tr("This file is not there."), Text::tr("%1 was not found. Nothing was changed.").arg(shown_file)};
    case StorageError::read_only:
      if (f.where != file.toStdString()) return describe(f);
      return {Text::tr("This file cannot be opened."), Text::tr("%1, its folder or its drive does not admit it. Nothing was changed.").arg(shown_file)};
    case StorageError::last_administrator:
      return {Text::tr("After this file nobody could administer this station."),
              Text::tr("It switches off the last administrator here. Make another one first; nothing was changed.")};
    case StorageError::duplicate:
      if (f.detail == "number") {
        return {Text::tr("%1 belongs to somebody else here.").arg(isolate(text(f.where))),
                Text::tr("Change it here or in the office, and ask the office for a new file. Nothing was changed.")};
      }
      if (f.detail == "finished") {
        return {Text::tr("An earlier file of this name was interrupted."),
                Text::tr("%1 is now finished. Choose another name for a newer one.").arg(shown_file)};
      }
      if (!f.detail.empty()) return describe(f);
      return {Text::tr("A file of this name is there already."), Text::tr("%1 stayed as it was. Choose another name.").arg(shown_file)};
    default: return describe(f);
  }
}

Message describe_key_failure(const StorageFailure& f, const QString& file) {
  const QString shown_file = isolate(file);
  if (f.code == StorageError::not_found) return {Text::tr("%1 is not there.").arg(shown_file), {}};
  if (f.code == StorageError::bad_value) return {Text::tr("%1 is no station’s key.").arg(shown_file), Text::tr("Ask for the key once more. Nothing was changed.")};
  return describe(f);
}

}  // namespace cusp::ui
