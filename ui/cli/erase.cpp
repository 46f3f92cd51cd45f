// cusp erase DB NUMBER

#include <nlohmann/json.hpp>

#include "ui/cli/account.h"
#include "ui/cli/outputs.h"
#include "ui/cli/text.h"
#include "ui/cli/verb.h"
#include "ui/modules.h"

namespace cusp::ui {
namespace {

struct EraseOptions {
  std::string db, number;
  AccountOption account;
  JsonOption json;
};

int erase(const EraseOptions& o) {
  if (const auto no = refuse_outputs({o.json.file}, o.db)) return failed(*no);
  auto store = open_records(o.db);
  if (!store) return failed(store.error());
  auto account = sign_in(**store, o.account, WithoutAccounts::refuse);
  if (!account) return failed(account.error());
  // Whoever may not erase does not learn here which numbers exist.
  if (auto may = require(account->actor(), Action::manage_accounts); !may) return failed(describe(may.error()));
  const auto person = (*store)->accounts.find_number(o.number);
  if (!person) return failed(describe_account(person.error(), QString::fromStdString(o.number), Secret::password));
  if (auto done = (*store)->accounts.erase(account->actor(), person->id); !done) return failed(describe(done.error()));
  const bool written = o.json.write({{"erased", person->id.text()}});
  // Also if the file cannot be written: nothing else names the pseudonym.
  if (!o.json.on_stdout()) {
    print_line(plain(CliText::tr("The person is erased. The attempts stay under the pseudonym %1.").arg(QString::fromStdString(person->id.text()))));
  }
  return written ? kDone : kFailed;
}

}  // namespace

void add_erase(CLI::App& program, Job& job) {
  auto o = std::make_shared<EraseOptions>();
  CLI::App* verb = program.add_subcommand(
      "erase", help(CliText::tr("Takes a person’s name, number and texts out for good; for administrators")));
  verb->add_option("DB", o->db, help(CliText::tr("Database")))->required()->check(check_not_empty);
  verb->add_option("NUMBER", o->number, help(CliText::tr("The person’s number")))->required()->check(check_not_empty);
  o->account.add_to(*verb);
  o->json.add_to(*verb);
  verb->callback([&job, o] { job = [o] { return erase(*o); }; });
}

}  // namespace cusp::ui
