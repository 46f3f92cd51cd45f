// cusp retain DB --years N

#include <nlohmann/json.hpp>

#include "storage/base/clock.h"
#include "storage/retention/departed.h"
#include "ui/cli/account.h"
#include "ui/cli/interrupt.h"
#include "ui/cli/outputs.h"
#include "ui/cli/text.h"
#include "ui/cli/verb.h"
#include "ui/modules.h"
#include "ui/text/exchange_text.h"

namespace cusp::ui {
namespace {

struct RetainOptions {
  std::string db;
  int years = 0;
  bool dry_run = false;
  ClockOption clock;
  AccountOption account;
  JsonOption json;
};

nlohmann::ordered_json json_of(const std::vector<DepartedStudent>& students) {
  auto list = nlohmann::ordered_json::array();
  for (const DepartedStudent& s : students) {
    list.push_back({{"id", s.account.id.text()}, {"number", s.account.number}, {"last", iso_utc(s.last_utc_us)}});
  }
  return list;
}

void print_departed(const DepartedStudents& departed, const RetainOptions& o) {
  for (const DepartedStudent& s : departed.erasable) print_line(plain(QString::fromStdString(s.account.number)) + "  " + iso_utc(s.last_utc_us));
  const int erased = static_cast<int>(departed.erasable.size()), waiting = static_cast<int>(departed.waiting.size());
  print_line(plain(o.dry_run ? CliText::tr("%n student(s) would be erased.", nullptr, erased) : CliText::tr("%n student(s) are erased.", nullptr, erased)));
  if (waiting > 0) print_line(plain(CliText::tr("%n student(s) stay: an assessment of theirs is not released.", nullptr, waiting)));
}

/// Of a dry run: who reads it has erased nobody yet.
void print_elsewhere(StorageContext& context, const Actor& actor) {
  const auto known = other_keys(context, actor);
  const QString text = known ? departed_elsewhere_text(*known) : describe(known.error()).line();
  if (!text.isEmpty()) print_line(plain(text));
}

int retain(const RetainOptions& o) {
  if (const auto no = refuse_outputs({o.json.file}, o.db)) return failed(*no);
  auto store = open_records(o.db);
  if (!store) return failed(store.error());
  auto account = sign_in(**store, o.account, WithoutAccounts::refuse);
  if (!account) return failed(account.error());
  StorageContext& context = (*store)->context();
  // A program that ended at Ctrl+C would name nobody whom it has erased.
  catch_interrupt();
  const auto departed = o.dry_run ? departed_students(context, account->actor(), o.years)
                                  : erase_departed(context, account->actor(), o.years, o.clock.trust(), [] { return !interrupted(); });
  if (!departed) return failed_by_age(departed.error());
  if (departed->doubt && !o.clock.is_right) return failed_by_age(*departed->doubt);
  const nlohmann::ordered_json json = {
      {"years", o.years}, {"dry_run", o.dry_run}, {"erased", json_of(departed->erasable)}, {"waiting", json_of(departed->waiting)}, {"stopped", departed->stopped}};
  const bool written = o.json.write(json);
  // Also if the file cannot be written: nothing else names who is erased.
  if (!o.json.on_stdout()) print_departed(*departed, o);
  if (!o.json.on_stdout() && o.dry_run) print_elsewhere(context, account->actor());
  if (departed->failed) return failed(describe(*departed->failed));
  if (departed->stopped) return failed(CliText::tr("Stopped before the last student. Those who are named are erased."));
  return written ? kDone : kFailed;
}

}  // namespace

void add_retain(CLI::App& program, Job& job) {
  auto o = std::make_shared<RetainOptions>();
  CLI::App* verb = program.add_subcommand(
      "retain", help(CliText::tr("Erases students who have made no attempt for years; for administrators")));
  verb->add_option("DB", o->db, help(CliText::tr("Database")))->required()->check(check_not_empty);
  verb->add_option("--years", o->years, help(CliText::tr("Years without an attempt, as the school has decided")))
      ->type_name("N")
      ->required()
      ->transform(decimal)
      ->check(CLI::Range(1, kMostRetainedYears));
  verb->add_flag("--dry-run", o->dry_run, help(CliText::tr("Only say who would be erased")));
  o->clock.add_to(*verb);
  o->account.add_to(*verb);
  o->json.add_to(*verb);
  verb->callback([&job, o] { job = [o] { return retain(*o); }; });
}

}  // namespace cusp::ui
