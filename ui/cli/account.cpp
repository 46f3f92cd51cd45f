#include "ui/cli/account.h"

#include <cstdlib>

#include "storage/records/verify.h"
#include "ui/cli/terminal.h"
#include "ui/cli/verb.h"
#include "ui/cli/text.h"
#include "ui/modules.h"

namespace cusp::ui {

void AccountOption::add_to(CLI::App& verb) {
  verb.add_option("--as", number,
                  help(CliText::tr("Number or user name of the account to act as; its password or PIN comes from CUSP_PASSWORD or stdin. "
                                    "Without it: the student demo")))
      ->type_name("NAME")
      ->check(check_not_empty);
}

Result<std::unique_ptr<Store>, Message> open_records(const std::filesystem::path& file) {
  StoreOptions options;
  options.database.access = DatabaseOptions::Access::existing;
  auto store = Store::open(file, options);
  // A disk that takes nothing more can still be read; where it cannot, that failure is the one to show.
  const StorageError code = store ? StorageError{} : store.error().code;
  if (!store && (code == StorageError::read_only || out_of_space(code) || code == StorageError::io)) {
    const StorageFailure why = store.error();
    options.database.access = DatabaseOptions::Access::read_only;
    store = Store::open(file, options);
    if (store) (*store)->database().set_unwritable(why);
  }
  if (store) return std::move(*store);
  // What refuses writing has been tried for reading, too.
  const StorageFailure& failure = store.error();
  if (auto refused = unreadable(failure, failure.where)) return std::unexpected(std::move(*refused));
  return std::unexpected(describe(failure));
}

namespace {

/// Prints what opening met, or why the counter lags, once on stderr; the verb continues. A full disk is named by the write that it
/// fails: a verb that fails prints one line.
void warn_of(const StorageContext& context) {
  for (const FindingCode code : {FindingCode::rolled_back, FindingCode::counter_missing, FindingCode::counter_broken,
                                 FindingCode::log_damaged}) {
    if (context.incident != key_of(code)) continue;
    warn(finding_text(ChainFinding{code, "audit_log"}) + u' ' + CliText::tr("Look at: history DB verify."));
  }
  if (context.counter_failure && !out_of_space(context.counter_failure->code)) {
    warn(CliText::tr("The counter beside the station’s key lags behind: %1. What was recorded is kept; the counter catches up later.")
             .arg(QString::fromStdString(context.counter_failure->where)));
  }
}

/// One account's number and the secret that was tried; the same for a number that nobody has.
Message no_match(const QString& number, Secret tried) {
  return {tried == Secret::pin ? CliText::tr("Number %1 and PIN do not match.").arg(number)
                               : CliText::tr("Number %1 and password do not match.").arg(number),
          {}};
}

/// PIN or password, as the account has them; what was given decides where it has both or nobody has the number.
Result<Account, Message> sign_in_by_secret(Store& store, const std::string& typed) {
  const QString number = QString::fromStdString(typed);
  const auto known = store.accounts.find_number(typed);
  if (!known && known.error().code != StorageError::not_found) return std::unexpected(describe(known.error()));
  const bool pin = known && known->has_pin, password = !known || known->has_password;
  std::string secret;
  // An account without a secret asks for none: a script need not close its stdin.
  if (pin || password) {
    const char* given = std::getenv("CUSP_PASSWORD");
    secret = given                ? given
             : pin && password    ? read_secret(help(CliText::tr("Password or PIN: ")))
             : pin                ? read_secret(help(CliText::tr("PIN: ")))
                                  : read_secret(help(CliText::tr("Password: ")));
  }
  const bool by_pin = known ? pin && (!password || acceptable_pin(secret)) : acceptable_pin(secret);
  const Secret tried = by_pin ? Secret::pin : Secret::password;
  auto account = by_pin ? store.accounts.sign_in_with_pin(typed, secret) : store.accounts.sign_in(typed, secret);
  if (account) return std::move(*account);
  if (account.error().code == StorageError::wrong_password) return std::unexpected(no_match(number, tried));
  return std::unexpected(describe_account(account.error(), number, tried));
}

}  // namespace

Result<Account, Message> sign_in(Store& store, const AccountOption& option, WithoutAccounts without) {
  if (option.number.empty()) {
    auto demo = without == WithoutAccounts::make_demo ? store.accounts.demo_student() : store.accounts.find_number("demo");
    // An administrator may have switched it off, or given it a secret: it then signs in as any other.
    const bool open = demo && !demo->disabled && !demo->has_password && !demo->has_pin;
    if (open) {
      warn_of(store.context());
      return std::move(*demo);
    }
    const StorageError code = demo ? StorageError{} : demo.error().code;
    if (!demo && code != StorageError::not_allowed && code != StorageError::not_found) return std::unexpected(describe(demo.error()));
    if (!demo) return std::unexpected(Message{CliText::tr("This database has no account “demo”: --as names the account to act as."), {}});
  }
  auto account = sign_in_by_secret(store, option.number.empty() ? "demo" : option.number);
  if (account) warn_of(store.context());
  return account;
}

}  // namespace cusp::ui
