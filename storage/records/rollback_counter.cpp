#include "storage/records/rollback_counter.h"

#include <charconv>
#include <sstream>
#include <utility>

#include "storage/base/files.h"

namespace cusp::storage {
namespace {

constexpr std::string_view kCounterFormat = "cusp-counter-1";

Hash256 message_of(const Uuid& station, const ChainHead& log) {
  return Blake2b{}.add_text("cusp counter 1").add_uuid(station).add_u64(log.links).add_hash(log.link).finish();
}

std::optional<RollbackCounter> counter_from(const std::string& text) {
  std::istringstream in(text);
  std::string format, station, key, entries, link, low, high;
  in >> format >> station >> key >> entries >> link >> low >> high;
  const auto id = Uuid::parse(station);
  const auto of_key = hash_from_hex(key), of_link = hash_from_hex(link);
  const auto first = hash_from_hex(low), second = hash_from_hex(high);
  if (!in || format != kCounterFormat || !id || !of_key || !of_link || !first || !second) return std::nullopt;
  RollbackCounter counter{*id, *of_key, {0, *of_link}, {}};
  const auto [end, error] = std::from_chars(entries.data(), entries.data() + entries.size(), counter.log.links);
  if (error != std::errc{} || end != entries.data() + entries.size()) return std::nullopt;
  std::copy(first->begin(), first->end(), counter.signature.begin());
  std::copy(second->begin(), second->end(), counter.signature.begin() + 32);
  return counter;
}

std::string hex_half(const Signature& signature, std::size_t from) {
  Hash256 half{};
  std::copy_n(signature.begin() + static_cast<std::ptrdiff_t>(from), half.size(), half.begin());
  return hex(half);
}

/// The counter is of this station, and one of its keys signed it. A key added by SQL is a finding of its own.
bool holds(StorageContext& context, const RollbackCounter& counter) {
  if (counter.station != context.station) return false;
  const auto key = context.db.first(
      kSelectOwnKey, [](Row row) { return row.hash(0); }, counter.key);
  return key && *key && key_id(**key) == counter.key &&
         signature_holds(**key, message_of(counter.station, counter.log), counter.signature);
}

}  // namespace

std::filesystem::path counter_file_of(const std::filesystem::path& key_file) { return key_file.string() + "-counter"; }

Stored<std::optional<RollbackCounter>> read_counter(const std::filesystem::path& file) {
  const auto text = read_private_file(file);
  if (!text) return std::unexpected(text.error());
  if (!*text) return std::optional<RollbackCounter>{};
  auto counter = counter_from(**text);
  if (!counter) return fail(StorageError::corrupt, file.string());
  return counter;
}

Stored<void> write_counter(const std::filesystem::path& file, const StationKey& key, const Uuid& station,
                           const ChainHead& log) {
  const Signature signature = key.sign(message_of(station, log));
  std::string text(kCounterFormat);
  for (const std::string& line : {station.text(), hex(key.id()), std::to_string(log.links), hex(log.link),
                                  hex_half(signature, 0), hex_half(signature, 32)}) {
    text += '\n' + line;
  }
  return replace_private_file(file, text + '\n');
}

Stored<CounterCheck> check_counter(StorageContext& context) {
  CounterCheck check;
  // Reads the file before the log: another process may add an entry in between.
  const auto counter = read_counter(context.counter_file);
  const auto last =
      context.db.first("SELECT number + 1, link FROM audit_log WHERE number = (SELECT max(number) FROM audit_log)", [](Row row) {
        return ChainHead{row.u64(0), row.hash(1)};
      });
  if (!last) return std::unexpected(last.error());
  if (*last) check.log = **last;
  if (!counter && counter.error().code != StorageError::corrupt) return std::unexpected(counter.error());
  if (counter && !*counter) {
    check.state = CounterState::missing;
    return check;
  }
  if (!counter || !holds(context, **counter)) {
    check.state = CounterState::broken;
    return check;
  }
  check.counted = (*counter)->log.links;
  if (check.counted == 0) return check;
  const auto same = context.db.first(
      "SELECT link = ?2 FROM audit_log WHERE number = ?1", [](Row row) { return row.flag(0); }, check.counted - 1,
      (*counter)->log.link);
  if (!same) return std::unexpected(same.error());
  if (!same->value_or(false)) check.state = CounterState::rolled_back;
  return check;
}

}  // namespace cusp::storage
