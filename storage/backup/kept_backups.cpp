#include "storage/backup/kept_backups.h"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>
#include <tuple>
#include <utility>

#include "storage/base/files.h"
#include "storage/base/left_folders.h"

namespace cusp::storage {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr int kBackupFormat = 1;
constexpr const char *kDaily = "daily", *kManual = "manual";  // "kind" of a description

/// A backup without a description, or with the beginning of one: write_private_file() adds to its name.
bool is_abandoned(const fs::path& folder) {
  const auto is_content = [](std::string_view name) {
    return name.starts_with(kBackupDatabase) || name.starts_with(std::string(kBackupDescription) + '.');
  };
  std::error_code error;
  return folder.filename().string().starts_with("cusp-") && is_left_folder(folder, is_content) && !fs::is_empty(folder, error) && !error;
}

bool is_newer_by_date(const Backup& a, const Backup& b) { return std::tie(b.made_utc_us, b.folder) < std::tie(a.made_utc_us, a.folder); }

/// By date. Those of one station change places among themselves, so that its own stand in their order.
void sort_newest_first(std::vector<Backup>& all) {
  std::ranges::sort(all, is_newer_by_date);
  std::map<Uuid, std::vector<Backup>> of;
  for (const Backup& one : all) of[one.station].push_back(one);
  for (auto& [station, own] : of) std::ranges::stable_sort(own, [](const Backup& a, const Backup& b) { return a.order > b.order; });
  std::map<Uuid, std::size_t> next;
  for (Backup& place : all) {
    const Uuid station = place.station;
    place = of[station][next[station]++];
  }
}

/// Beyond the newest `keep`. A clock without a battery starts at the same date each day: of the daily ones within half a day by their dates
/// at most half of `keep` stay, so that those from before stay, too.
std::vector<fs::path> superfluous(const std::vector<Backup>& newest_first, std::size_t keep) {
  constexpr std::int64_t kSameDate_us = 43'200'000'000;
  const auto most_of_a_date = static_cast<std::ptrdiff_t>(std::max<std::size_t>(1, keep / 2));
  std::vector<std::int64_t> kept;  // their dates
  std::vector<fs::path> out;
  for (const Backup& one : newest_first) {
    const auto of_this_date = std::ranges::count_if(kept, [&one](std::int64_t date) { return std::abs(date - one.made_utc_us) < kSameDate_us; });
    if (kept.size() >= keep || (one.kind == BackupKind::daily && of_this_date >= most_of_a_date)) {
      out.push_back(one.folder);
    } else {
      kept.push_back(one.made_utc_us);
    }
  }
  return out;
}

}  // namespace

Stored<void> write_description(const Backup& backup) {
  const json description = {{"cusp_backup", kBackupFormat}, {"station", backup.station.text()}, {"made_at", backup.made_utc_us},
                            {"sessions", backup.sessions}, {"bytes", backup.bytes}, {"kind", backup.kind == BackupKind::daily ? kDaily : kManual},
                            {"order", backup.order}};
  return write_private_file(backup.folder / kBackupDescription, description.dump());
}

std::uint64_t next_order(StorageContext& context, const fs::path& into) {
  const auto entries = context.db.first("SELECT entries FROM audit_head", [](Row row) { return row.u64(0); });
  std::uint64_t order = std::max<std::uint64_t>(1, entries ? entries->value_or(0) : 0);
  const auto all = backups_in(into, context.station);
  for (const Backup& one : all ? *all : std::vector<Backup>{}) order = std::max(order, one.order + 1);
  return order;
}

std::error_code remove_copy(const fs::path& folder) {
  std::error_code error;
  fs::remove(folder / kBackupDescription, error);
  if (!error) fs::remove_all(folder, error);
  return error;
}

std::vector<fs::path> abandoned_in(const fs::path& into) {
  std::vector<fs::path> out;
  std::error_code error;
  for (fs::directory_iterator it(into, error), end; !error && it != end; it.increment(error))
    if (is_abandoned(it->path())) out.push_back(it->path());
  return out;
}

Stored<Backup> read_backup(const fs::path& folder) {
  std::error_code error;
  if (!fs::is_directory(folder, error) && error != std::errc::permission_denied) return fail(StorageError::not_found, folder.string());
  const auto content = read_private_file(folder / kBackupDescription);
  if (!content) return std::unexpected(content.error());
  if (!*content || !fs::is_regular_file(folder / kBackupDatabase, error)) return fail(StorageError::not_found, folder.string());
  const json description = json::parse(**content, nullptr, false);
  const auto number = [&](const char* key) {
    const auto it = description.find(key);
    return it != description.end() && it->is_number_integer() ? it->get<std::int64_t>() : -1;
  };
  const auto named = description.find("station");
  const auto station = named != description.end() && named->is_string() ? Uuid::parse(named->get<std::string>()) : std::nullopt;
  if (!station || number("cusp_backup") != kBackupFormat || number("made_at") < 0 || number("sessions") < 0 ||
      number("bytes") < 0) {
    return fail(StorageError::not_found, folder.string());
  }
  const auto kind = description.find("kind");
  const bool manual = kind != description.end() && *kind == kManual;
  return Backup{folder, *station, number("made_at"), static_cast<std::uint64_t>(number("sessions")), static_cast<std::uint64_t>(number("bytes")),
                manual ? BackupKind::manual : BackupKind::daily, static_cast<std::uint64_t>(std::max<std::int64_t>(0, number("order")))};
}

Stored<std::vector<Backup>> backups_in(const fs::path& into, const std::optional<Uuid>& station) {
  std::vector<Backup> out;
  std::error_code error;
  if (!fs::exists(into, error) && !error) return out;
  if (error) return std::unexpected(failure_from(error, into));
  for (fs::directory_iterator it(into, error), end; !error && it != end; it.increment(error)) {
    if (auto backup = read_backup(it->path()); backup && (!station || backup->station == *station)) out.push_back(std::move(*backup));
  }
  if (error) return std::unexpected(failure_from(error, into));
  sort_newest_first(out);
  return out;
}

Stored<void> thin_backups(const fs::path& into, const Uuid& station, BackupKind kind, std::size_t keep, std::int64_t now_utc_us) {
  std::vector<fs::path> going = abandoned_in(into);
  std::error_code ignored;
  auto all = backups_in(into, station);
  if (!all) return std::unexpected(all.error());
  // Removing would begin with the description behind the link.
  std::erase_if(*all, [&](const Backup& one) { return one.kind != kind || fs::is_symlink(one.folder, ignored); });
  std::ranges::stable_partition(*all, [&](const Backup& one) { return one.order > 0 || one.made_utc_us <= now_utc_us; });
  for (fs::path& folder : superfluous(*all, keep)) going.push_back(std::move(folder));
  Stored<void> out;
  for (const fs::path& folder : going) {
    const std::error_code error = remove_copy(folder);
    if (error && out) out = std::unexpected(failure_from(error, folder));
  }
  return out;
}

}  // namespace cusp::storage
