#include "ui/text/incident_text.h"

#include "storage/records/audit_writer.h"
#include "ui/text/text.h"
#include "ui/widgets/format.h"

namespace cusp::ui {
namespace {

Message what_it_means(std::string_view incident) {
  if (incident == "rolled_back") {
    return {Text::tr("The records are older than they were."),
            Text::tr("An earlier copy was put in their place, or entries were taken out: results may be missing.")};
  }
  if (incident == "counter_missing") {
    return {Text::tr("The counter beside the records’ key is missing."),
            Text::tr("An earlier copy of the records put in their place would not have been noticed.")};
  }
  if (incident == "counter_broken") {
    return {Text::tr("The counter beside the records’ key is not theirs."),
            Text::tr("It was changed or comes from other records: an earlier copy would not have been noticed.")};
  }
  return {Text::tr("The records’ audit log was changed."),
          Text::tr("Its last entries were changed or taken out: results or accounts may have been too.")};
}

}  // namespace

Message describe_incident(std::string_view incident, const std::filesystem::path& database) {
  Message message = what_it_means(incident);
  message.more += u' ' + Text::tr("Before you rely on them, look at what this command names: cusp history %1 verify")
                          .arg(isolate(QString::fromStdString(database.string())));
  return message;
}

Message describe_clock_behind(std::int64_t newest_attempt_utc_us, std::int64_t now_utc_us) {
  const auto day = [](std::int64_t utc_us) { return installed_locale().toString(local_time(utc_us), date_pattern()); };
  return {Text::tr("This computer’s clock is behind."),
          Text::tr("It shows %1, and the newest attempt is of %2. Set it before anybody drills: the order of attempts and what is assigned follow it.")
              .arg(day(now_utc_us), day(newest_attempt_utc_us))};
}

Message describe_reading_only(const StorageFailure& cause, const std::filesystem::path& database) {
  return {describe(cause).what, Text::tr("Results and reports can be read. Nothing can be drilled or changed until %1 can be "
                                      "written again.")
                                .arg(isolate(QString::fromStdString(database.filename().string())))};
}

Message describe_damaged() {
  return {Text::tr("The records are damaged."),
          Text::tr("What is whole can be read and exported. Nothing can be drilled or changed until a backup takes their place.")};
}

QString finding_text(const ChainFinding& f) {
  const std::int64_t row = f.table == "audit_log" ? shown_number(f.row) : f.row;
  QString where = f.row >= 0 ? Text::tr("%1, row %2").arg(QString::fromStdString(f.table)).arg(row) : QString::fromStdString(f.table);
  if (!f.what.empty()) where += QStringLiteral(", ") + QString::fromStdString(f.what);
  QString when = f.second >= 0 ? Text::tr(", second %1 of the session").arg(f.second) : QString();
  if (f.at_utc_us > 0) when += Text::tr(", in the audit log since %1").arg(format_date_time_zone(local_time(f.at_utc_us)));
  switch (f.code) {
    case FindingCode::row_changed: return Text::tr("The record was changed: %1%2.").arg(where, when);
    case FindingCode::row_missing: return Text::tr("A part of the record is missing: %1%2.").arg(where, when);
    case FindingCode::row_added: return Text::tr("Something was added to the record: %1%2.").arg(where, when);
    case FindingCode::link_broken: return Text::tr("The record’s chain is broken: %1%2.").arg(where, when);
    case FindingCode::head_broken:
      return Text::tr("The signature over the record does not hold: %1%2.").arg(where, when);
    case FindingCode::key_changed:
      return Text::tr("The station’s key is not the one that signed: %1%2.").arg(where, when);
    case FindingCode::unreadable: return Text::tr("The record cannot be read: %1%2.").arg(where, when);
    case FindingCode::count_wrong: return Text::tr("The record does not add up: %1%2.").arg(where, when);
    case FindingCode::seal_broken: return Text::tr("The record is not the one that was sealed: %1%2.").arg(where, when);
    case FindingCode::rolled_back:
      return Text::tr("The database is older than the counter beside its key, or its audit log was cut: %1%2.").arg(where, when);
    case FindingCode::counter_missing:
      return Text::tr("The counter beside the station’s key is missing: %1%2.").arg(where, when);
    case FindingCode::counter_broken:
      return Text::tr("The counter beside the station’s key is not the one of this database: %1%2.").arg(where, when);
    case FindingCode::log_damaged:
      return Text::tr("The audit log’s end was changed or taken out: %1%2.").arg(where, when);
    case FindingCode::summary_differs:
      return Text::tr("The lists show something else than the record: %1%2.").arg(where, when);
  }
  return where;
}

QString proof_text(const ReplayProof& proof) {
  if (!proof.chain.intact()) return finding_text(proof.chain.findings.front());
  if (proof.differs_at_tick) return Text::tr("The replay comes to another state at tick %1.").arg(*proof.differs_at_tick);
  if (proof.has_final_volume && !proof.volume_equal) return Text::tr("The replay comes to another tooth than the one that is stored.");
  if (proof.has_grade && !proof.grade_equal) {
    return Text::tr("The replay comes to another grade than the one that is stored (%1).").arg(QString::fromStdString(proof.grade_differs));
  }
  return {};
}

QString fingerprint(const Hash256& key) {
  const QString hex = QString::fromStdString(storage::hex(key));
  return QStringList{hex.mid(0, 4), hex.mid(4, 4), hex.mid(8, 4), hex.mid(12, 4)}.join(u' ');
}

}  // namespace cusp::ui
