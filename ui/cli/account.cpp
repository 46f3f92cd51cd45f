#include "ui/cli/account.h"

#include <cstdlib>

#include "ui/cli/terminal.h"
#include "ui/cli/verb.h"
#include "ui/cli/words.h"

namespace cusp {

void AccountOption::add_to(CLI::App& verb) {
  verb.add_option("--as", number,
                  help(CliWords::tr("Number of the account to act as; its password comes from CUSP_PASSWORD or stdin. "
                                    "Without it: the student demo")))
      ->type_name("NAME");
}

std::expected<std::unique_ptr<Store>, Told> open_records(const std::filesystem::path& file) {
  StoreOptions options;
  options.database.access = DatabaseOptions::Access::existing;
  auto store = Store::open(file, options);
  // A disk that takes nothing more can still be read; where it cannot, that failure is the one to show.
  const StorageError code = store ? StorageError{} : store.error().code;
  if (!store && (code == StorageError::read_only || code == StorageError::disk_full || code == StorageError::io)) {
    options.database.access = DatabaseOptions::Access::read_only;
    store = Store::open(file, options);
  }
  if (!store) return std::unexpected(tell(store.error()));
  return std::move(*store);
}

std::expected<Account, Told> sign_in(Store& store, const AccountOption& option, bool may_make) {
  if (option.number.empty()) {
    auto demo = may_make ? store.people.demo_student() : store.people.find_number("demo");
    if (demo) return std::move(*demo);
    const bool missing = demo.error().code == StorageError::not_allowed || demo.error().code == StorageError::not_found;
    if (!missing) return std::unexpected(tell(demo.error()));
    return std::unexpected(Told{CliWords::tr("This database has accounts: say with --as which one to act as."), {}});
  }
  std::string password;
  // An account without a password asks for none: a script need not close its stdin.
  const auto known = store.people.find_number(option.number);
  if (!known || known->has_password) {
    const char* given = std::getenv("CUSP_PASSWORD");
    password = given ? given : read_secret(help(CliWords::tr("Password: ")));
  }
  auto account = store.people.sign_in(option.number, password);
  if (!account) return std::unexpected(tell(account.error()));
  return std::move(*account);
}

}  // namespace cusp
