#include "storage/exchange/logged_files.h"

#include <system_error>

#include "storage/base/files.h"
#include "storage/exchange/unnamed_copies.h"

namespace cusp::storage {
namespace {

namespace fs = std::filesystem;

bool is_given_out(StorageContext& context, const fs::path& copy) {
  auto file = open_exchange(copy);
  if (!file) return false;
  const auto checked = read_description(*file);
  if (!checked || checked->description.station != context.station) return false;
  const auto entry = context.db.first(
      "SELECT 1 FROM audit_log INDEXED BY audit_by_subject WHERE subject = ?1 AND action = 'exchange_given_out' "
      "AND action <> 'session_sealed' AND detail = ?2",
      [](Row) { return true; }, context.station, given_out_detail(key_id(checked->public_key), checked->description.kind, checked->hash));
  return entry && *entry;
}

bool is_packed(StorageContext& context, const fs::path& copy) {
  const auto hash = hash_of_file(copy);
  if (!hash) return false;
  const auto entry = context.db.first(
      "SELECT 1 FROM audit_log INDEXED BY audit_by_action WHERE action = 'packed' AND action <> 'session_sealed' AND detail = ?1",
      [](Row) { return true; }, packed_detail(*hash));
  return entry && *entry;
}

}  // namespace

std::string given_out_detail(const Hash256& key, ExchangeKind kind, const Hash256& description) {
  return hex(key) + ' ' + std::string(key_of(kind)) + ' ' + hex(description);
}

std::string packed_detail(const Hash256& file) { return hex(file); }

bool name_earlier_files(StorageContext& context, const fs::path& file) {
  std::error_code ignored;
  const fs::path real = fs::absolute(behind_links(file), ignored);
  bool named = false;
  for (const UnnamedCopy& one : unnamed_copies(real.parent_path())) {
    if (!is_given_out(context, one.made) && !is_packed(context, one.made)) continue;
    // Of two programs that start at once, one names it.
    if (!rename_new(one.made, one.file)) continue;
    fs::remove_all(one.made.parent_path(), ignored);
    named = named || one.file == real;
  }
  return named;
}

}  // namespace cusp::storage
