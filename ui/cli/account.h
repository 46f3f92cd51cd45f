/// The database of a verb, and the account that it acts as.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

#include "engine/base/result.h"
#include "storage/store.h"
#include "ui/modules.h"
#include "ui/text/failure_text.h"

namespace cusp::ui {

struct AccountOption {
  std::string number;  // empty: the student "demo"
  void add_to(CLI::App& verb);
};

/// Opens a database that is there; read-only where it cannot be written, and a write then fails with the cause.
Result<std::unique_ptr<Store>, Message> open_records(const std::filesystem::path& file);

/// What sign_in() does in a database without accounts.
enum class WithoutAccounts : std::uint8_t { refuse, make_demo };

/// Signs in with the password or PIN of CUSP_PASSWORD or one line of stdin. Without a number: the student "demo".
Result<Account, Message> sign_in(Store& store, const AccountOption& option, WithoutAccounts without);

}  // namespace cusp::ui
