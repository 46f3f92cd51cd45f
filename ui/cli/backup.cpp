// cusp backup DB FOLDER, cusp restore BACKUP DB

#include "storage/backup/backup.h"

#include <nlohmann/json.hpp>

#include "storage/base/clock.h"
#include "ui/cli/account.h"
#include "ui/cli/interrupt.h"
#include "ui/cli/outputs.h"
#include "ui/cli/text.h"
#include "ui/cli/verb.h"
#include "ui/modules.h"

namespace cusp::ui {
namespace {

struct BackupOptions {
  std::string from, to;
  AccountOption account;
  JsonOption json;
};

nlohmann::ordered_json backup_json(const Backup& backup) {
  nlohmann::ordered_json json;
  json["folder"] = backup.folder.string();
  json["made"] = iso_utc(backup.made_utc_us);
  json["sessions"] = backup.sessions;
  json["bytes"] = backup.bytes;
  return json;
}

/// A folder that takes no backup is no fault of the database.
Message describe_backup(const StorageFailure& failure, const std::filesystem::path& into) {
  const std::filesystem::path where = failure.where, folder = into.has_filename() ? into : into.parent_path();
  const bool of_folder = where == into || where.parent_path() == folder;
  const bool unwritable = failure.code == StorageError::read_only || failure.code == StorageError::io;
  return of_folder && unwritable && !failure.detail.empty() ? cannot_write(where, failure.detail) : describe(failure);
}

int back_up(const BackupOptions& o) {
  // A folder of the records, as that of the key states, may be deleted.
  if (const auto no = refuse_outputs({o.json.file, o.to}, o.from)) return failed(*no);
  auto store = open_records(o.from);
  if (!store) return failed(store.error());
  auto account = sign_in(**store, o.account, WithoutAccounts::refuse);
  if (!account) return failed(account.error());
  // A program that ended at Ctrl+C would leave half a backup, with a secret key.
  catch_interrupt();
  const auto backup = make_backup((*store)->context(), account->actor(), o.to, goes_on_until_interrupt);
  if (!backup) return failed(describe_backup(backup.error(), o.to));
  if (!o.json.write(backup_json(*backup))) return kFailed;
  if (!o.json.on_stdout()) print_line(backup->folder.string());
  return kDone;
}

/// The store is closed before the database gets its name.
Stored<void> finish_restored(const Backup& backup, const std::filesystem::path& database) {
  StoreOptions options;
  options.database.access = DatabaseOptions::Access::existing;
  const auto store = Store::open(database, options);
  if (!store) return std::unexpected(store.error());
  return log_restored((*store)->context(), backup);
}

int restore(const BackupOptions& o) {
  if (const auto no = refuse_outputs({o.json.file}, o.to, {std::filesystem::path(o.from) / kBackupDescription})) return failed(*no);
  // A database in the place of another one's log or journal is lost with the next start of that one.
  std::error_code ignored;
  if (!std::filesystem::exists(o.to, ignored)) {
    if (const auto no = refuse_outputs({o.to})) return failed(*no);
  }
  const auto backup = read_backup(o.from);
  if (!backup) {
    if (const auto refused = unreadable(backup.error(), o.from)) return failed(*refused);
    if (backup.error().code != StorageError::not_found) return failed(describe(backup.error()));
    return failed(CliText::tr("%1 is no whole backup.").arg(QString::fromStdString(o.from)));
  }
  const auto done = restore_backup(*backup, o.to, [&backup](const std::filesystem::path& database) { return finish_restored(*backup, database); });
  if (!done && done.error().code == StorageError::duplicate) {
    const QString name = QString::fromStdString(done.error().where);
    if (done.error().detail == "finished") {
      return failed(CliText::tr("An earlier restore to %1 was interrupted. It is now finished; this backup was not restored.").arg(name));
    }
    return failed(CliText::tr("%1 is there already. Restore to a new name; nothing was changed.").arg(name));
  }
  if (!done) {
    // The new database may lie in the backup's folder.
    const auto refused = done.error().where == o.to ? std::nullopt : unreadable(done.error(), o.from);
    return failed(refused ? *refused : describe(done.error()));
  }
  if (!o.json.write(backup_json(*backup))) return kFailed;
  if (!o.json.on_stdout()) {
    print_line(plain(CliText::tr("%n session(s) are restored as of %1.", nullptr, static_cast<int>(backup->sessions))
                         .arg(QString::fromStdString(iso_utc(backup->made_utc_us)))));
  }
  return kDone;
}

}  // namespace

void add_backup(CLI::App& program, Job& job) {
  auto o = std::make_shared<BackupOptions>();
  CLI::App* make = program.add_subcommand("backup", help(CliText::tr("Copies all records as of now to a new folder; for administrators")));
  make->add_option("DB", o->from, help(CliText::tr("Database")))->required()->check(check_not_empty);
  make->add_option("FOLDER", o->to, help(CliText::tr("Where the backup’s own folder is made")))->required()->check(check_not_empty);
  o->account.add_to(*make);
  o->json.add_to(*make);
  make->callback([&job, o] { job = [o] { return back_up(*o); }; });

  auto r = std::make_shared<BackupOptions>();
  CLI::App* back = program.add_subcommand("restore", help(CliText::tr("Makes a new database from a backup")));
  back->add_option("BACKUP", r->from, help(CliText::tr("The backup’s folder")))->required()->check(check_not_empty);
  back->add_option("DB", r->to, help(CliText::tr("Database that does not exist yet")))->required()->check(check_file_name);
  r->json.add_to(*back);
  back->callback([&job, r] { job = [r] { return restore(*r); }; });
}

}  // namespace cusp::ui
