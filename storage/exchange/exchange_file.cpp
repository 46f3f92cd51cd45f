#include "storage/exchange/exchange_file.h"

#include <algorithm>

#include "storage/exchange/json_read.h"
#include "storage/records/statement_rows.h"
#include "storage/records/trace_codec.h"

namespace cusp::storage {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;

constexpr std::string_view kExchangeLabel = "cusp exchange 1";
constexpr int kExchangeFormat = 1;
/// 67 bytes for each earlier file: 125,000 of them, a file an hour for fourteen years.
constexpr std::size_t kMostExchangeText = 8 * 1024 * 1024;
/// Of containers: the description, then `log`, `earlier` and `tables`. Deeper ones would take 100 bytes for each of theirs.
constexpr int kDeepestExchange = 2;
constexpr std::array<std::string_view, 2> kExchangeKinds = {"results", "office"};

std::string exchange_text(const ExchangeDescription& d) {
  ordered_json earlier = ordered_json::array();
  for (const Hash256& hash : d.earlier) earlier.push_back(hex(hash));
  ordered_json out;
  out["cusp_exchange"] = kExchangeFormat;
  out["station"] = d.station.text();
  out["kind"] = key_of(d.kind);
  out["made_by"] = d.maker.text();
  out["made_at"] = d.made_utc_us;
  out["log"] = json_of(d.log);
  out["earlier"] = earlier;
  out["tables"] = json_of(d.tables);
  return out.dump();
}

std::optional<std::vector<Hash256>> earlier_from(const json& read) {
  const auto list = read.find("earlier");
  if (list == read.end() || !list->is_array()) return std::nullopt;
  std::vector<Hash256> out;
  for (const json& item : *list) {
    const auto hash = item.is_string() ? hash_from_hex(item.get<std::string>()) : std::nullopt;
    if (!hash) return std::nullopt;
    out.push_back(*hash);
  }
  return out;
}

std::optional<ExchangeDescription> exchange_from(std::string_view text) {
  if (text.size() > kMostExchangeText) return std::nullopt;
  const json read = json::parse(text, [](int depth, json::parse_event_t, const json&) { return depth <= kDeepestExchange; }, false);
  const auto station = uuid_at(read, "station"), maker = uuid_at(read, "made_by");
  const auto made = number_at(read, "made_at");
  const auto kind = std::ranges::find(kExchangeKinds, text_at(read, "kind").value_or(""));
  const auto log = head_at(read, "log");
  auto tables = files_at(read, "tables");
  if (number_at(read, "cusp_exchange") != kExchangeFormat || !station || !maker || !made || kind == kExchangeKinds.end() || !log || !tables) return std::nullopt;
  auto earlier = earlier_from(read);
  if (!earlier) return std::nullopt;
  return ExchangeDescription{*station, static_cast<ExchangeKind>(kind - kExchangeKinds.begin()), UserId{*maker}, *made, *log, std::move(*earlier), std::move(*tables)};
}

Stored<Hash256> content_of(Database& file, const std::string& schema, const std::string& table, WorkSteps& steps) {
  const auto keys = file.all("SELECT name FROM pragma_table_info(?1, ?2) WHERE pk > 0 ORDER BY pk", [](Row row) { return row.text(0); }, table, schema);
  if (!keys) return std::unexpected(keys.error());
  std::string order;
  for (const std::string& key : *keys) order += (order.empty() ? " ORDER BY " : ", ") + key;
  Blake2b hash;
  hash.add_text(table);
  std::optional<Uuid> session;
  const auto rows = file.all("SELECT * FROM " + schema + ".\"" + table + '"' + order, [&](Row row) {
    hash.add_hash(row.content_hash());
    if (table == "trace_chunks" && session != row.uuid(0)) {
      session = row.uuid(0);
      steps.add_done();
    }
    return true;
  });
  if (!rows) return std::unexpected(rows.error());
  return hash.finish();
}

StorageFailure no_exchange(const Database& file) { return {StorageError::not_exchange, file.file().string()}; }

bool same_tables(const std::vector<PackFile>& a, const std::vector<PackFile>& b) {
  return std::ranges::equal(a, b, [](const PackFile& x, const PackFile& y) { return x.name == y.name && x.hash == y.hash; });
}

/// What the file's schema has and the records' lacks: a table, a column, an index, or an index by another text. SQLite's versions write
/// an ALTER TABLE differently into a table's text; a virtual table has no root page.
constexpr std::string_view kSelectForeign =
    "SELECT s.name FROM source.sqlite_schema s WHERE s.name <> 'exchange_description' AND ("
    "NOT EXISTS (SELECT 1 FROM main.sqlite_schema m WHERE m.type = s.type AND m.name = s.name AND (s.type = 'table' OR m.sql IS s.sql)) "
    "OR s.type = 'table' AND (s.rootpage = 0 OR EXISTS (SELECT cid, name, type, pk, hidden FROM pragma_table_xinfo(s.name, 'source') "
    "EXCEPT SELECT cid, name, type, pk, hidden FROM pragma_table_xinfo(s.name, 'main')))) LIMIT 1";

/// Rows of a file that an office alone may send: what a results file names without reference, members, start codes, withdrawals.
constexpr std::string_view kSelectOfficeRow =
    "SELECT 1 FROM (SELECT id FROM people UNION ALL SELECT id FROM scenario_versions UNION ALL SELECT id FROM assignments) "
    "WHERE id NOT IN (SELECT id FROM referred) UNION ALL SELECT 1 FROM cohort_students UNION ALL SELECT 1 FROM assessments "
    "UNION ALL SELECT 1 FROM version_withdrawals UNION ALL SELECT 1 FROM assignment_withdrawals LIMIT 1";

Stored<void> check_kind(Database& file, ExchangeKind kind) {
  if (kind == ExchangeKind::office) return {};
  const auto of_office = file.first(kSelectOfficeRow, [](Row) { return true; });
  if (!of_office) return std::unexpected(of_office.error());
  if (*of_office) return fail(StorageError::not_allowed, "office_file");
  return {};
}

}  // namespace

std::string_view key_of(ExchangeKind kind) noexcept { return kExchangeKinds[static_cast<std::size_t>(kind)]; }

Stored<ExchangeCounts> counts_of(Database& file) {
  const auto counts = file.first(
      "SELECT (SELECT count(*) FROM sessions), (SELECT count(*) FROM statements), "
      "(SELECT count(*) FROM people WHERE id NOT IN (SELECT id FROM referred)), "
      "(SELECT count(*) FROM scenario_versions WHERE id NOT IN (SELECT id FROM referred)), (SELECT count(*) FROM assignments)",
      [](Row row) { return ExchangeCounts{row.u64(0), row.u64(1), row.u64(2), row.u64(3), row.u64(4)}; });
  if (!counts) return std::unexpected(counts.error());
  return counts->value_or(ExchangeCounts{});
}

Hash256 description_hash(const SignedText& text) { return blake2b_256(std::string_view(text.description)); }

SignedText sign_exchange(const StationKey& key, const ExchangeDescription& description) {
  return sign_text(key, kExchangeLabel, exchange_text(description));
}

Stored<void> add_description(Database& file, const SignedText& text) {
  Transaction transaction(file);
  transaction.run("CREATE TABLE exchange_description (description TEXT NOT NULL, signature TEXT NOT NULL) STRICT");
  transaction.run("INSERT INTO exchange_description VALUES (?1, ?2)", text.description, text.signature);
  return transaction.commit();
}

Stored<Database> open_exchange(const std::filesystem::path& file) {
  auto opened = Database::open(file, {.access = DatabaseOptions::Access::read_only, .on_network_drive = admits_network_drive, .kind = DatabaseOptions::Kind::travelling});
  if (!opened) return std::unexpected(failure_in_file(opened.error(), file));
  return opened;
}

Stored<CheckedExchange> read_description(Database& file) {
  const auto there = file.first("SELECT count(*) FROM sqlite_schema WHERE type = 'table' AND name = 'exchange_description'", [](Row row) { return row.flag(0); });
  if (!there) return std::unexpected(there.error());
  if (!there->value_or(false)) return std::unexpected(no_exchange(file));
  const auto text = file.first("SELECT description, signature FROM exchange_description", [](Row row) { return SignedText{row.text(0), row.text(1)}; });
  if (!text) return std::unexpected(text.error());
  const auto description = *text ? exchange_from((*text)->description) : std::nullopt;
  const auto by = *text ? check_text(**text, kExchangeLabel) : std::nullopt;
  if (!description || !by || !by->holds) return std::unexpected(no_exchange(file));
  return CheckedExchange{*description, description_hash(**text), by->public_key};
}

StorageFailure failure_in_file(StorageFailure failure, const std::filesystem::path& file) {
  if (failure.code == StorageError::corrupt) return {StorageError::not_exchange, file.string()};
  return failure;
}

namespace {

Stored<void> check_attached_schema(Database& records, const std::filesystem::path& file) {
  const auto schema = records.first("PRAGMA source.user_version", [](Row row) { return row.integer(0); });
  const auto foreign = records.first(kSelectForeign, [](Row row) { return row.text(0); });
  if (!schema) return std::unexpected(schema.error());
  const std::int64_t version = schema->value_or(0);
  if (version != static_cast<std::int64_t>(built_in_migrations().size())) {
    return fail(StorageError::older_schema, file.string(), std::to_string(version));
  }
  if (!foreign) return std::unexpected(foreign.error());
  if (*foreign) return fail(StorageError::not_exchange, file.string(), **foreign);
  return {};
}

/// Of the database that is open as `schema`.
Stored<std::vector<PackFile>> table_hashes_in(Database& db, const std::string& schema, const std::filesystem::path& file, WorkSteps& steps) {
  const auto found = db.all("SELECT type, name FROM " + schema + ".sqlite_schema WHERE type <> 'index' ORDER BY name",
                            [](Row row) { return std::pair{row.text(0), row.text(1)}; });
  if (!found) return std::unexpected(found.error());
  std::vector<PackFile> out;
  for (const auto& [type, name] : *found) {
    if (type != "table") return fail(StorageError::not_exchange, file.string());
    if (name == "exchange_description" || name.starts_with("sqlite_")) continue;
    const auto content = content_of(db, schema, name, steps);
    if (!content) return std::unexpected(content.error());
    if (!steps.go_on()) return fail(StorageError::stopped, file.string());
    out.push_back({name, *content});
  }
  return out;
}

}  // namespace

Stored<void> check_schema(Database& records, const std::filesystem::path& file) {
  if (auto done = records.attach_source(file); !done) return done;
  auto same = check_attached_schema(records, file);
  records.detach_source();
  return same;
}

Stored<void> check_attached(Database& records, const std::filesystem::path& file, const ExchangeDescription& description, WorkSteps& steps) {
  if (auto same = check_attached_schema(records, file); !same) return same;
  const StatementWatch watch(records, [&steps] { return steps.go_on(); });
  const auto tables = table_hashes_in(records, "source", file, steps);
  if (!tables) return std::unexpected(tables.error());
  if (!same_tables(*tables, description.tables)) return fail(StorageError::not_exchange, file.string());
  return {};
}

Stored<std::vector<PackFile>> table_hashes(Database& file, WorkSteps& steps) { return table_hashes_in(file, "main", file.file(), steps); }

Stored<void> check_content(Database& file, const ExchangeDescription& description, WorkSteps& steps) {
  const StatementWatch watch(file, [&steps] { return steps.go_on(); });
  const auto damage = file.integrity_check();
  if (!damage) return std::unexpected(damage.error());
  const auto tables = table_hashes(file, steps);
  if (!tables) return std::unexpected(tables.error());
  if (!damage->empty() || !same_tables(*tables, description.tables)) return std::unexpected(no_exchange(file));
  if (auto good = check_kind(file, description.kind); !good) return good;
  const auto blobs = file.all("SELECT hash, packed FROM blobs", [](Row row) {
    const auto bytes = unpack(row.bytes(1));
    return bytes && blake2b_256(*bytes) == row.hash(0);
  });
  if (!blobs) return std::unexpected(blobs.error());
  if (std::ranges::count(*blobs, false) > 0) return std::unexpected(no_exchange(file));
  const auto findings = check_statements(file);
  if (!findings) return std::unexpected(findings.error());
  for (const ChainFinding& finding : *findings) {
    // A text that its station has erased is missing there too.
    const bool erased = finding.code == FindingCode::row_missing && finding.table == "statement_texts";
    if (!erased) return fail(StorageError::differs, finding.table, finding.what);
  }
  return {};
}

}  // namespace cusp::storage
