// cusp history DB list|show|verify|rebuild

#include <algorithm>
#include <nlohmann/json.hpp>

#include "scenarios/grading/maxima.h"
#include "storage/base/clock.h"
#include "storage/records/session_summary.h"
#include "storage/records/verify.h"
#include "ui/cli/account.h"
#include "ui/cli/interrupt.h"
#include "ui/cli/outputs.h"
#include "ui/cli/report_files.h"
#include "ui/cli/row_json.h"
#include "ui/cli/verb.h"
#include "ui/cli/text.h"
#include "ui/session/specimen_blob.h"
#include "ui/text/names.h"
#include "ui/modules.h"
#include "ui/widgets/format.h"

namespace cusp::ui {

namespace {

struct HistoryOptions {
  std::string db, session, student;
  int limit = -1;
  AccountOption account;
  JsonOption json;
};

/// "passed", "not passed", "not released", or the state of a session without a grade.
QString result_text(const HistoryRow& row) {
  if (!row.released && row.state == SessionState::finished) return CliText::tr("not released");  // as ui/student/course.cpp
  if (!row.passed) return state_name(row.state);
  return *row.passed ? CliText::tr("passed") : CliText::tr("not passed");
}

std::string row_line(const HistoryRow& row) {
  const QString score = row.score ? format_number(shown_points(*row.score), 1).rightJustified(5) : QStringLiteral("    –");
  return plain(QString::fromStdString(row.session.text()) + QStringLiteral("  ") +
               QString::fromStdString(iso_utc(row.started_utc_us)) + QStringLiteral("  ") +
               QString::fromStdString(row.student_number) + QStringLiteral("  ") + local(row.title) + QStringLiteral("  ") +
               score + QStringLiteral("  ") + result_text(row));
}

int list(const HistoryOptions& o) {
  if (const auto no = refuse_outputs({o.json.file}, o.db)) return failed(*no);
  auto store = open_records(o.db);
  if (!store) return failed(store.error());
  auto account = sign_in(**store, o.account, WithoutAccounts::refuse);
  if (!account) return failed(account.error());
  HistoryFilter filter;
  filter.limit = o.limit;
  filter.search = o.student;
  auto rows = (*store)->history.list(account->actor(), filter);
  if (!rows) return failed(describe(rows.error()));
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const HistoryRow& row : *rows) {
    json.push_back(row_json(row));
    if (!o.json.on_stdout()) print_line(row_line(row));
  }
  return o.json.write(json) ? kDone : kFailed;
}

nlohmann::ordered_json details_json(const SessionDetails& details) {
  nlohmann::ordered_json json = row_json(details.row);
  json["engine"] = details.session.header.engine_version;
  json["events"] = nlohmann::ordered_json::array();
  for (const SessionEvent& e : details.events) {
    json["events"].push_back({{"kind", std::string(key_of(e.kind))},
                              {"at", iso_utc(e.at_utc_us)},
                              {"tick", e.tick},
                              {"reason", e.reason}});
  }
  json["removed"] = nlohmann::ordered_json::array();
  for (const RemovedTissue& r : details.removed) {
    const auto code = index_of(r.tissue);
    json["removed"].push_back({{"tissue", code < kTissueKeys.size() ? std::string(kTissueKeys[code]) : std::to_string(code)},
                               {"voxels", r.voxels},
                               {"mm3", r.mm3}});
  }
  json["criteria"] = nlohmann::ordered_json::array();
  if (!details.grade) return json;
  const Grade& grade = details.grade->grade;
  const std::vector<ScaledPoints> scaled = scaled_points(grade);
  for (std::size_t i = 0; i < grade.criteria.size(); ++i) {
    const CriterionGrade& c = grade.criteria[i];
    json["criteria"].push_back({{"id", c.id},
                                {"value", c.measure.measured ? nlohmann::ordered_json(c.measure.value) : nullptr},
                                {"unit", c.measure.unit},
                                {"band", c.band},
                                {"points", scaled[i].points},
                                {"points_max", scaled[i].points_max},
                                {"reason_code", c.reason_code}});
  }
  return json;
}

/// The names that the volume gives its own tissues; empty where none of them was removed and no tissue's removal is graded. Reading the
/// volume takes tenths of a second.
TissueNames names_of(Store& store, const SessionDetails& details) {
  const auto is_own = [](const RemovedTissue& r) { return index_of(r.tissue) >= kTissueKeys.size(); };
  const auto is_graded = [&details](std::string_view key) {
    return details.grade && std::ranges::any_of(details.grade->grade.criteria, [key](const CriterionGrade& c) { return c.id.starts_with(key); });
  };
  if (std::ranges::none_of(details.removed, is_own) && !is_graded("removed_")) return {};
  const auto bytes = store.blobs.get(details.session.header.specimen_blob);
  const auto volume = bytes ? specimen_from_bytes(*bytes) : std::nullopt;
  return volume ? volume->names : TissueNames{};
}

void print_details(const SessionDetails& details, const TissueNames& names) {
  print_line(row_line(details.row));
  for (const SessionEvent& e : details.events) {
    print_line("  " + iso_utc(e.at_utc_us) + "  " + std::string(key_of(e.kind)) + (e.reason.empty() ? "" : "  " + plain(QString::fromStdString(e.reason))));
  }
  for (const RemovedTissue& r : details.removed) {
    print_line(plain(QStringLiteral("  %1: %2 mm³").arg(tissue_name(r.tissue, names), format_number(r.mm3, 2))));
  }
  if (details.grade) print_criteria(details.grade->grade, "  ", nullptr, names);
}

int show(const HistoryOptions& o) {
  if (const auto no = refuse_outputs({o.json.file}, o.db)) return failed(*no);
  const auto id = SessionId::parse(o.session);
  if (!id) return wrong_usage(CliText::tr("%1 is not a session’s id.").arg(QString::fromStdString(o.session)));
  auto store = open_records(o.db);
  if (!store) return failed(store.error());
  auto account = sign_in(**store, o.account, WithoutAccounts::refuse);
  if (!account) return failed(account.error());
  const auto details = (*store)->history.details(account->actor(), *id);
  if (!details) return failed(describe(details.error()));
  if (!o.json.write(details_json(*details))) return kFailed;
  if (!o.json.on_stdout()) print_details(*details, names_of(**store, *details));
  return kDone;
}

/// Whose or what record a finding is of, for a line and for JSON.
struct FindingOwner {
  std::string key = "session", id, number;
};
/// The number of an account is for those who see all results, and for its own.
FindingOwner owner_of(Store& store, const Account& reader, const ChainFinding& f) {
  FindingOwner owner;
  if (!f.owner.is_nil()) owner.id = f.owner.text();
  if (f.table == "people") {
    owner.key = "person";
    const bool seen = reader.id == UserId{f.owner} || may(reader.role, Action::see_all_results);
    if (const auto person = store.accounts.find(UserId{f.owner}); seen && person) owner.number = person->number;
  }
  for (const char* table : {"station", "cohorts", "cohort_students", "assignments", "scenario_versions", "blobs"}) {
    if (f.table == table) owner.key = "subject";
  }
  return owner;
}

QString finding_line(const FindingOwner& owner, const ChainFinding& f) {
  if (owner.id.empty()) return finding_text(f);
  QString who = QString::fromStdString(owner.id);
  if (!owner.number.empty()) who = QStringLiteral("%1 (%2)").arg(QString::fromStdString(owner.number), who);
  return who + QStringLiteral(": ") + finding_text(f);
}

nlohmann::ordered_json finding_json(const FindingOwner& owner, const ChainFinding& f) {
  nlohmann::ordered_json json;
  json["session"] = owner.key == "session" ? owner.id : std::string();
  if (owner.key != "session") json[owner.key] = owner.id;
  if (!owner.number.empty()) json["number"] = owner.number;
  json["code"] = std::string(key_of(f.code));
  json["table"] = f.table;
  json["row"] = f.row;
  json["second"] = f.second;
  json["what"] = f.what;
  json["logged"] = f.at_utc_us > 0 ? nlohmann::ordered_json(iso_utc(f.at_utc_us)) : nullptr;
  return json;
}

/// Since when the log holds seals, and how far the counter is behind it. Stopped, it may not have read the log.
void print_since(const StoreVerification& v) {
  if (v.stopped) return print_line(plain(CliText::tr("The verification was stopped.")));
  if (!v.sealed_since_utc_us) {
    print_line(plain(CliText::tr("Nothing is sealed yet: that begins when the database is next opened for writing.")));
  } else if (v.sealed_later > 0) {
    print_line(plain(CliText::tr("Sealed since %1; what was there before is held against what it was then.")
                  .arg(QString::fromStdString(iso_utc(*v.sealed_since_utc_us)))));
  }
  if (v.uncounted > 0) {
    print_line(plain(CliText::tr("%n entry/entries of the audit log are not yet in the counter beside the key.", nullptr,
                           static_cast<int>(v.uncounted))));
  }
}

/// What SQLite finds wrong with the file, or that nobody waited for it.
std::optional<StorageFailure> damage_of(Store& store, const std::string& db) {
  const StatementWatch watch(store.database(), [] { return !interrupted(); });
  const auto sound = store.database().integrity_check();
  if (interrupted()) return StorageFailure{StorageError::stopped, db};
  if (!sound) return sound.error();
  if (!sound->empty()) return StorageFailure{StorageError::corrupt, db, *sound};
  return std::nullopt;
}

/// Pre: nothing was found.
Message whole_until_stopped(const StoreVerification& v) {
  return {CliText::tr("The verification was stopped."),
          CliText::tr("Attempts verified and whole: %1. The others were not verified.").arg(static_cast<qulonglong>(v.sessions))};
}

int verify(const HistoryOptions& o) {
  if (const auto no = refuse_outputs({o.json.file}, o.db)) return failed(*no);
  auto store = open_records(o.db);
  if (!store) return failed(store.error());
  auto account = sign_in(**store, o.account, WithoutAccounts::refuse);
  if (!account) return failed(account.error());
  catch_interrupt();
  if (const auto damage = damage_of(**store, o.db)) return failed(describe(*damage));
  const auto verified = verify_store((*store)->context(), goes_on_until_interrupt);
  if (!verified) return failed(describe(verified.error()));

  nlohmann::ordered_json json;
  json["sessions"] = verified->sessions;
  json["log_entries"] = verified->entries;
  json["sealed_since"] = verified->sealed_since_utc_us
                             ? nlohmann::ordered_json(iso_utc(*verified->sealed_since_utc_us))
                             : nullptr;
  json["sealed_later"] = verified->sealed_later;
  json["uncounted"] = verified->uncounted;
  json["findings"] = nlohmann::ordered_json::array();
  std::optional<QString> first;
  for (const ChainFinding& f : verified->findings) {
    const FindingOwner owner = owner_of(**store, *account, f);
    const QString line = finding_line(owner, f);
    json["findings"].push_back(finding_json(owner, f));
    if (!o.json.on_stdout()) print_line(plain(line));
    if (!first) first = line;
  }
  json["stopped"] = verified->stopped;
  json["intact"] = verified->intact();
  if (!o.json.write(json)) return kFailed;
  if (!o.json.on_stdout()) print_since(*verified);
  if (first) return failed(*first);
  if (verified->stopped) return failed(whole_until_stopped(*verified));
  if (!o.json.on_stdout()) {
    print_line(plain(CliText::tr("%n session(s) and the audit log are whole.", nullptr, static_cast<int>(verified->sessions))));
  }
  return kDone;
}

int rebuild(const HistoryOptions& o) {
  if (const auto no = refuse_outputs({o.json.file}, o.db)) return failed(*no);
  auto store = open_records(o.db);
  if (!store) return failed(store.error());
  auto account = sign_in(**store, o.account, WithoutAccounts::refuse);
  if (!account) return failed(account.error());
  const auto differences = rebuild_summaries((*store)->context(), account->actor());
  if (!differences) return failed(describe(differences.error()));
  if (!o.json.write({{"differences", *differences}})) return kFailed;
  if (!o.json.on_stdout()) {
    print_line(plain(CliText::tr("The lists are made anew from the records; %n value(s) differed.", nullptr,
                                 static_cast<int>(*differences))));
  }
  return kDone;
}

}  // namespace

void add_history(CLI::App& program, Job& job) {
  auto o = std::make_shared<HistoryOptions>();
  CLI::App* verb = program.add_subcommand("history", help(CliText::tr("What is kept: sessions, one of them, or proof of all")));
  verb->add_option("DB", o->db, help(CliText::tr("Database")))->required()->check(check_not_empty);
  verb->require_subcommand(1);
  o->account.add_to(*verb);
  o->json.add_to(*verb);
  verb->fallthrough();

  CLI::App* list_of = verb->add_subcommand("list", help(CliText::tr("Sessions, newest first")));
  list_of->add_option("--student", o->student, help(CliText::tr("Part of a name or number")))->type_name("TEXT");
  list_of->add_option("--limit", o->limit, help(CliText::tr("At most so many")))->type_name("N")->transform(decimal)->check(check_counting);
  CLI::App* show_one = verb->add_subcommand("show", help(CliText::tr("One session: events, removed tissue, grade")));
  show_one->add_option("SESSION", o->session, help(CliText::tr("The session's id")))->required();
  CLI::App* verify_all = verb->add_subcommand("verify", help(CliText::tr("The file, each session's chain, and the audit log")));
  CLI::App* rebuild_all =
      verb->add_subcommand("rebuild", help(CliText::tr("Makes what lists and charts show anew from the records")));
  list_of->fallthrough();
  show_one->fallthrough();
  verify_all->fallthrough();
  rebuild_all->fallthrough();
  list_of->callback([&job, o] { job = [o] { return list(*o); }; });
  show_one->callback([&job, o] { job = [o] { return show(*o); }; });
  verify_all->callback([&job, o] { job = [o] { return verify(*o); }; });
  rebuild_all->callback([&job, o] { job = [o] { return rebuild(*o); }; });
}

}  // namespace cusp::ui
