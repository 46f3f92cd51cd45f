/// The database of a verb, and the account that it acts as.
#pragma once

#include <CLI/CLI.hpp>
#include <expected>
#include <filesystem>
#include <memory>
#include <string>

#include "storage/store.h"
#include "ui/modules.h"
#include "ui/text/failure_text.h"

namespace cusp::ui {

struct AccountOption {
  std::string number;  // empty: the student "demo"
  void add_to(CLI::App& verb);
};

/// Opens a database that is there; read-only where it cannot be written.
std::expected<std::unique_ptr<Store>, Message> open_records(const std::filesystem::path& file);

/// Signs in with the password or PIN of CUSP_PASSWORD or one line of stdin. Without a number: "demo", made where there are no
/// accounts yet and `may_make`.
std::expected<Account, Message> sign_in(Store& store, const AccountOption& option, bool may_make);

}  // namespace cusp::ui
