// Messages for failures of storage.

#include <QDateTime>
#include <QLocale>
#include <optional>

#include "ui/text/failure_text.h"
#include "ui/text/incident_text.h"
#include "ui/text/names.h"
#include "ui/text/text.h"
#include "ui/widgets/format.h"

namespace cusp::ui {
namespace {

QString quoted_place(const std::string& where) { return isolate(text(where)); }

QString nothing_changed() { return Text::tr("Nothing was changed."); }

/// "/data/cusp.db", and where a library gave a reason "/data/cusp.db (disk I/O error)".
QString with_reason(const StorageFailure& f) {
  return f.detail.empty() ? quoted_place(f.where) : Text::tr("%1 (%2)").arg(quoted_place(f.where), isolate(text(f.detail)));
}

/// The file, its folder, or the disk under it.
std::optional<Message> describe_file(const StorageFailure& f) {
  const QString where = quoted_place(f.where);
  switch (f.code) {
    case StorageError::not_a_database:
      if (f.detail == "empty") {
        return Message{Text::tr("This file holds no records yet."),
                    Text::tr("%1 is empty: Cusp ended before it wrote to it, or it is another file. It was left as it is.").arg(where)};
      }
      return Message{Text::tr("This file is not a Cusp database."),
                  Text::tr("%1 was left as it is. Choose another file with --db.").arg(where)};
    case StorageError::newer_schema:
      return Message{Text::tr("This database was written by a newer version of Cusp."),
                  Text::tr("%1 was left as it is. Install the newer version to open it.").arg(where)};
    case StorageError::network_drive:
      return Message{Text::tr("The database lies on a network drive."),
                  Text::tr("%1 would not be safe there. Move it to this computer’s own disk.").arg(where)};
    case StorageError::read_only:
      if (f.detail == "new file") {
        return Message{Text::tr("The database cannot be made there."),
                    Text::tr("No file can be made at %1. Choose another place with --db.").arg(where)};
      }
      return Message{Text::tr("The database cannot be written."),
                  Text::tr("%1 or its folder is read-only. Nothing was changed.").arg(where)};
    case StorageError::disk_full:
      return Message{Text::tr("The disk is full."),
                  Text::tr("Nothing of the last step was written to %1; all before it is kept. Free some space and try "
                            "again.")
                      .arg(where)};
    case StorageError::file_too_large:
      return Message{Text::tr("The file is too large."),
                  Text::tr("Nothing of the last step was written to %1; all before it is kept. A drive formatted as FAT32 takes no file above 4 GB.").arg(where)};
    case StorageError::quota_exceeded:
    case StorageError::out_of_memory:
    case StorageError::io:
      if (f.where == "memory") {
        return Message{Text::tr("This computer has too little free memory to check a password."),
                    Text::tr("Nothing was changed. Close other programs and try again.")};
      }
      return Message{Text::tr("A file could not be read or written."),
                  Text::tr("Nothing of the last step was written to %1; all before it is kept.").arg(with_reason(f))};
    case StorageError::busy:
      return Message{Text::tr("Another program holds the database."),
                  Text::tr("%1 stayed as it was. Another window of Cusp holds it while it reads in a file of another station"
                           ": wait until that is done, or close the other program, and try again.")
                      .arg(where)};
    case StorageError::corrupt:
      if (f.detail == "sessions") {
        return Message{Text::tr("The backup is damaged."),
                    Text::tr("%1 holds another number of attempts than its description. Nothing was changed; restore another backup.").arg(where)};
      }
      if (f.detail == "key") {
        return Message{Text::tr("The station’s key is damaged: put its file back from a backup."),
                    Text::tr("%1 cannot be read; the records are as they were. Without a backup move it away: Cusp then makes a new key, which other stations have to trust anew.").arg(where)};
      }
      [[fallthrough]];
    case StorageError::bad_statement:
      return Message{Text::tr("The database is damaged."),
                  Text::tr("%1 cannot be read whole. Nothing was changed; restore it from a backup.").arg(with_reason(f))};
    default: return std::nullopt;
  }
}

Message describe_locked(const StorageFailure& f, const QString& what) {
  const qint64 until_us = QString::fromStdString(f.detail).toLongLong();
  if (until_us <= 0) return {what, Text::tr("Wait a little and try again.")};
  const QDateTime until = local_time(until_us + 999'999);  // the seconds shown are cut off, not rounded
  return {what, Text::tr("Signing in is open again at %1.").arg(installed_locale().toString(until.time(), u"HH:mm:ss"_qs))};
}

Message describe_weak(const StorageFailure& f) {
  if (f.where == "pin") return {Text::tr("A PIN has exactly six digits."), nothing_changed()};
  return {Text::tr("This password is too short."), Text::tr("A password has at least 8 characters. Nothing was changed.")};
}

Message describe_missing(const StorageFailure& f) {
  const QString which = f.detail.empty() ? QString() : isolate(text(f.detail));
  if (f.detail == "folder") {
    return {Text::tr("The database’s folder is not there."),
            Text::tr("There is no folder %1. Make it, or choose another place with --db.").arg(quoted_place(f.where))};
  }
  const auto none = [&](const QString& what) {
    return Message{what, which.isEmpty() ? nothing_changed() : Text::tr("%1 was not found. Nothing was changed.").arg(which)};
  };
  if (f.where == "people") return none(Text::tr("This account is not there."));
  if (f.where == "sessions") return none(Text::tr("This attempt is not there."));
  if (f.where == "statements") return none(Text::tr("This remark is withdrawn already."));
  if (f.where == "scenario_versions") return none(Text::tr("This exercise is not there."));
  if (f.where == "blobs" || f.where == "trace_chunks" || f.where == "cohort_students") {
    return none(Text::tr("A part of the records is not there."));
  }
  return {Text::tr("The record is not there."), Text::tr("%1 was not found. Nothing was changed.").arg(quoted_place(f.where))};
}

Message describe_bad_value(const StorageFailure& f) {
  if (f.where == "number") return {Text::tr("A number has 1 to 64 characters."), nothing_changed()};
  if (f.where == "name") return {Text::tr("A name has 1 to 200 characters."), nothing_changed()};
  if (f.where == "pin") return {Text::tr("Only students have a PIN."), nothing_changed()};
  if (f.where == "text") return {Text::tr("A comment or reason has 1 to 10,000 characters."), nothing_changed()};
  if (f.where == "extra_time") return {Text::tr("Extra time is 0 to 400 % of the time limit."), nothing_changed()};
  if (f.where == "start_code") return {Text::tr("A start code has 4 to 32 characters."), nothing_changed()};
  if (f.where == "days") return {Text::tr("Recordings are thinned after 1 to 36,500 days."), nothing_changed()};
  if (f.where == "years") return {Text::tr("Accounts are kept for 1 to 100 years."), nothing_changed()};
  if (f.where == "device_classes") return {Text::tr("A device has no such name."), nothing_changed()};
  if (f.where == "self_test_days") return {Text::tr("A self-test is 1 to 365 days old."), nothing_changed()};
  if (f.where == "drawn_tooth") return {Text::tr("Only an assessment draws a tooth for each candidate."), nothing_changed()};
  if (f.where == "due") return {Text::tr("The due date lies before the first day."), nothing_changed()};
  return {Text::tr("A value is missing or outside its range."),
          Text::tr("Look at %1. Nothing was changed.").arg(with_reason(f))};
}

Message describe_not_allowed(const StorageFailure& f) {
  if (f.where == "start_code") return {Text::tr("This is not the start code."), Text::tr("Ask the invigilator and type it again.")};
  if (f.where == "assignment") {
    return {Text::tr("This exercise is not assigned to you."), Text::tr("Ask your instructor. Nothing was changed.")};
  }
  if (f.where == "own_key" || f.where == "own_file") return {Text::tr("This is this station’s own."), nothing_changed()};
  if (f.where == "office_file") {
    return {Text::tr("Only the office’s files bring accounts and assignments."),
            Text::tr("This station is not trusted as the office here. Nothing was changed.")};
  }
  if (f.where == "own_account") {
    return {Text::tr("This is your own account."), Text::tr("Another administrator erases it. Nothing was changed.")};
  }
  if (f.where == "own_attempt") {
    return {Text::tr("This is your own attempt."), Text::tr("Another examiner marks and releases it. Nothing was changed.")};
  }
  if (f.where == "withheld") {
    return {Text::tr("This result is not released yet."), Text::tr("It is shown here when your examiner releases it.")};
  }
  return {Text::tr("Your role may not do this."), nothing_changed()};
}

/// Of UTC µs, with its year: it may be long ago.
QString day_text(const QString& utc_us) {
  const QLocale locale = installed_locale();
  const QString form = locale.language() == QLocale::German ? QStringLiteral("d. MMMM yyyy") : QStringLiteral("d MMMM yyyy");
  return locale.toString(local_time(utc_us.toLongLong()).date(), form);
}

/// Of clock_ahead.
QString clock_text(const StorageFailure& f) {
  const QString times = text(f.detail);
  if (f.where == "pause") {
    return Text::tr("This computer’s clock says %1. Nothing was recorded from %2 to %3. If the clock is wrong now, or was before, attempts and accounts are younger than their dates.")
        .arg(day_text(times.section(u' ', 1, 1)), day_text(times.section(u' ', 0, 0)), day_text(times.section(u' ', 2, 2)));
  }
  return Text::tr("This computer’s clock says %1. The newest attempt or account is of %2.").arg(day_text(times.section(u' ', 1)), day_text(times.section(u' ', 0, 0)));
}

Message describe_thinned(const StorageFailure& f) {
  return {Text::tr("The recording was thinned on %1.").arg(day_text(text(f.detail))),
          Text::tr("Grade, report and final tooth are kept. The attempt can no longer be replayed, graded again or packed for an appeal.")};
}

Message describe_wrong_state(const StorageFailure& f) {
  if (f.where == "not_open") return {Text::tr("This assignment is not open yet."), Text::tr("The start page shows when it opens.")};
  if (f.where == "version_withdrawn") return {Text::tr("This version of the exercise was withdrawn."), nothing_changed()};
  if (f.where == "withdrawn") return {Text::tr("This assignment was withdrawn."), Text::tr("Ask your instructor. Nothing was changed.")};
  if (f.where == "past_due") return {Text::tr("The time for this assignment is over."), Text::tr("Ask your instructor. Nothing was changed.")};
  if (f.where == "attempts_used") return {Text::tr("Every attempt of this assignment is used."), Text::tr("Ask your instructor. Nothing was changed.")};
  if (f.where == "other_station") return {Text::tr("This attempt belongs to another station."), nothing_changed()};
  if (f.where == "thinned") return describe_thinned(f);
  if (f.where == "session") return {Text::tr("This attempt is being drilled in another window."), Text::tr("It opens as soon as it has ended.")};
  if (f.where == "volume_kept") {
    return {Text::tr("An older version of Cusp ended this attempt without a grade, so it cannot be continued."), Text::tr("It can be graded as it stands.")};
  }
  if (f.where == "running") return {Text::tr("An attempt of this person still runs."), nothing_changed()};
  if (f.where == "grade") return {Text::tr("This attempt has no grade yet."), nothing_changed()};
  if (f.where == "changed") return {Text::tr("The result was changed at another desk meanwhile."), nothing_changed()};
  if (f.where == "released") return {Text::tr("This result is released already."), nothing_changed()};
  if (f.where == "confirmation") {
    return {Text::tr("A failed result is released only after an examiner has confirmed it."), nothing_changed()};
  }
  return {Text::tr("This attempt is not in a state that allows it."), nothing_changed()};
}

Message describe_other_device(const StorageFailure& f) {
  std::vector<std::string> admitted;
  for (const QString& one : text(f.detail).split(u' ', Qt::SkipEmptyParts)) admitted.push_back(one.toStdString());
  return {Text::tr("This assignment needs another device."),
          Text::tr("Admitted: %1. In use: %2. Ask the staff to choose another one on the page Device.").arg(device_names(admitted), device_name(f.where))};
}

Message describe_self_test_due(const StorageFailure& f) {
  const int days = QString::fromStdString(f.detail).toInt();
  return {Text::tr("This assignment needs a newer self-test of the device."),
          Text::tr("It asks for a %1.").arg(self_test_age(days)) + u' ' + self_test_advice(f.where)};
}

/// The fingerprint of a key that a failure names.
QString key_in(const StorageFailure& f) {
  const auto key = storage::hash_from_hex(f.detail);
  return key ? fingerprint(*key) : QString();
}

/// A file of another station, or its key.
std::optional<Message> describe_exchange(const StorageFailure& f) {
  const QString where = quoted_place(f.where), which = isolate(text(f.detail));
  switch (f.code) {
    case StorageError::not_exchange:
      return Message{Text::tr("This is no file of a station, or not as its station signed it."),
                     Text::tr("%1 was not read. Ask for it once more; nothing was changed.").arg(where)};
    case StorageError::cut_short: {
      const auto bytes = [&f](int at) { return installed_locale().toString(text(f.detail).section(u' ', at, at).toULongLong()); };
      return Message{Text::tr("This file is cut short."),
                     Text::tr("%1 of the %2 bytes of %3 are there. Copy it here once more; a drive formatted as FAT32 takes no file above 4 GB. Nothing was changed.")
                         .arg(bytes(0), bytes(1), where)};
    }
    case StorageError::older_schema:
      return Message{Text::tr("An older version of Cusp made this file."),
                     Text::tr("Update Cusp on the station that made %1, and ask for a new file. Nothing was changed.").arg(where)};
    case StorageError::unknown_key:
      return Message{Text::tr("Nobody has made this station’s key known here."),
                     Text::tr("Compare key %1 with that on the other station’s page, then make it known here. Station %2; nothing was changed.").arg(key_in(f), where)};
    case StorageError::revoked_key:
      return Message{Text::tr("This station’s key was revoked here."), Text::tr("Key %1, station %2. Nothing was changed.").arg(key_in(f), where)};
    case StorageError::put_back:
      return Message{Text::tr("This station was put back to an old copy."),
                     Text::tr("Station %1 has given out another file under number %2 before. Close Cusp there, move its file that ends in .key away, "
                              "and start Cusp: it makes a new key. Make that known here; nothing was changed.").arg(where, which)};
    case StorageError::differs:
      return Message{Text::tr("The file says otherwise of something that is here already."), Text::tr("Look at %1, %2. Nothing was changed.").arg(where, which)};
    default: return std::nullopt;
  }
}

/// A path, as SQLite names what it refused: it does not name the account or exercise that was meant.
bool names_file(const StorageFailure& f) { return f.where.find('/') != std::string::npos; }

}  // namespace

Message describe(const StorageFailure& f) {
  if (auto message = describe_file(f)) return *message;
  if (auto message = describe_exchange(f)) return *message;
  const QString where = quoted_place(f.where);
  switch (f.code) {
    case StorageError::not_found: return describe_missing(f);
    case StorageError::wrong_password:
      return {Text::tr("Number and password do not match."), Text::tr("Check both and try again.")};
    case StorageError::other_secret:
      if (f.detail == "pin") return {Text::tr("%1 signs in with a PIN of six digits.").arg(where), {}};
      return {Text::tr("%1 signs in with a password.").arg(where), {}};
    case StorageError::locked: return describe_locked(f, Text::tr("Too many wrong tries."));
    case StorageError::disabled:
      return {f.where == "actor" ? Text::tr("Your account is switched off.") : Text::tr("This account is switched off."),
              Text::tr("Ask an administrator to switch it on again.")};
    case StorageError::not_allowed: return describe_not_allowed(f);
    case StorageError::weak_password: return describe_weak(f);
    case StorageError::last_administrator:
      return {Text::tr("This is the last administrator."),
              Text::tr("Somebody has to manage people. Make another administrator first.")};
    case StorageError::duplicate:
      if (f.detail == "log") {
        return {Text::tr("The log of other records lies there."),
                Text::tr("%1 belongs to records that were moved away. Move it beside them, or choose another place with --db.").arg(where)};
      }
      if (names_file(f)) return {Text::tr("This number or name is taken."), nothing_changed()};
      return {Text::tr("This is there already."), Text::tr("%1 is taken. Nothing was changed.").arg(where)};
    case StorageError::bad_value: return describe_bad_value(f);
    case StorageError::wrong_state: return describe_wrong_state(f);
    case StorageError::other_device: return describe_other_device(f);
    case StorageError::self_test_due: return describe_self_test_due(f);
    case StorageError::stopped: return {Text::tr("Stopped."), nothing_changed()};
    case StorageError::clock_ahead: return {Text::tr("The clock may be wrong."), clock_text(f) + u' ' + nothing_changed()};
    case StorageError::bad_trace:
      return {Text::tr("The recording cannot be read."),
              Text::tr("%1 is damaged; the grade and all other attempts are kept.").arg(where)};
    default: break;
  }
  return {Text::tr("The database failed."), where};
}

QString clock_question_text(const StorageFailure& doubt) {
  const QString way_out = doubt.where == "pause" ? Text::tr("If one of these dates is wrong, cancel.") : Text::tr("If that date is wrong, cancel and set the clock.");
  return clock_text(doubt) + u' ' + way_out;
}

Message describe_account(const StorageFailure& f, const QString& number, Secret asked) {
  const QString who = isolate(number);
  switch (f.code) {
    case StorageError::wrong_password:
      if (asked == Secret::pin) return {Text::tr("Number and PIN do not match."), Text::tr("Check both and try again.")};
      return describe(f);
    case StorageError::locked: return describe_locked(f, Text::tr("Too many wrong tries for %1.").arg(who));
    case StorageError::disabled:
      if (f.where == "actor") return describe(f);
      return {Text::tr("The account %1 is switched off.").arg(who), Text::tr("Ask an administrator to switch it on again.")};
    case StorageError::not_found:
      if (f.where != "people" && !names_file(f)) return describe(f);
      return {Text::tr("There is no account %1.").arg(who), nothing_changed()};
    case StorageError::duplicate:
      return {Text::tr("The number %1 is taken.").arg(who), Text::tr("Nothing was changed. Choose another number.")};
    case StorageError::weak_password:
      if (asked == Secret::pin) return describe_weak({f.code, "pin", f.detail});
      return describe_weak(f);
    default: return describe(f);
  }
}

Message describe_backup_failure(const StorageFailure& f, const std::filesystem::path& folder) {
  const std::filesystem::path within = std::filesystem::path(f.where).lexically_relative(folder);
  const bool of_folder = within == "." || (!within.empty() && within.begin()->string().starts_with("cusp-"));
  if (!of_folder) return describe(f);
  const QString where = quoted_place(folder.string());
  switch (f.code) {
    case StorageError::not_found:
    case StorageError::read_only:
    case StorageError::io:
      return {Text::tr("The folder for backups cannot be written."),
              Text::tr("%1: %2. Connect its drive, or choose another folder. The records are as they were.").arg(where, isolate(QString::fromLocal8Bit(f.detail.c_str())))};
    case StorageError::disk_full:
    case StorageError::quota_exceeded:
      return {Text::tr("The drive for backups is full."), Text::tr("%1 has no room for a copy of the records. Free some space there, or choose another folder.").arg(where)};
    default: return describe(f);
  }
}

}  // namespace cusp::ui
