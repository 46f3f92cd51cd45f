#include "storage/records/verify.h"

#include <array>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "storage/records/chain_check.h"
#include "storage/records/session_tables.h"
#include "storage/records/thinned_traces.h"
#include "storage/records/trace_codec.h"

namespace cusp::storage {

std::string_view key_of(FindingCode code) noexcept {
  constexpr std::array<std::string_view, 14> keys = {
      "row_changed", "row_missing", "row_added",   "link_broken",     "head_broken",    "key_changed", "unreadable",
      "count_wrong", "seal_broken", "rolled_back", "counter_missing", "counter_broken", "log_damaged",
      "summary_differs"};
  return keys[static_cast<std::size_t>(code)];
}

namespace {

class SessionVerifier {
 public:
  SessionVerifier(StorageContext& context, SessionId session) : db_{context.db}, session_{session} {}

  Stored<Verification> verify() {
    read_chain();
    check_heads();
    check_thinned();
    for (const SessionTable table : kSessionTables) compare(table);
    if (!anything_) return fail(StorageError::not_found, "sessions", session_.text());
    check_trace();
    check_references();
    return std::move(out_);
  }

 private:
  void find(FindingCode code, std::string_view table, std::int64_t row = -1, std::int64_t second = -1) {
    out_.findings.push_back({code, std::string(table), row, second});
  }

  void read_chain() {
    const auto links = db_.all(
        "SELECT position, table_number, row, second, content, link FROM session_chain WHERE session = ?1 ORDER BY "
        "position",
        [](Row row) {
          return StoredLink{{row.u64(0), row.u64(1), row.u64(2), row.integer(3), row.hash(4)}, row.hash(5)};
        },
        session_);
    if (!links) return find(FindingCode::unreadable, "session_chain");
    anything_ = anything_ || !links->empty();
    std::uint64_t expected = 0;
    for (const StoredLink& entry : *links) {
      const auto position = static_cast<std::int64_t>(entry.link.position);
      if (entry.link.position != expected) {
        find(FindingCode::row_missing, "session_chain", static_cast<std::int64_t>(expected));
        whole_ = false;
      }
      expected = entry.link.position + 1;
      const bool good = follower_.follows(entry);
      // After a gap no link can follow; the gap is a finding already.
      if (!good && whole_) find(FindingCode::link_broken, "session_chain", position, entry.link.second);
      entries_[{entry.link.table, entry.link.row}] = {entry.link, good || !whole_};
    }
    out_.links = links->size();
  }

  /// Compares every row of a table with its entry in the chain.
  void compare(SessionTable table) {
    const auto number = static_cast<std::uint64_t>(table);
    std::set<std::uint64_t> seen;
    const auto rows = db_.all(
        select_rows(table),
        [](Row row) {
          return std::pair{row.u64(0), row.content_hash(1)};
        },
        session_);
    if (!rows) return find(FindingCode::unreadable, name_of(table));
    anything_ = anything_ || !rows->empty();
    const bool emptied = thinned_ && is_thinned(table);
    if (emptied && !rows->empty()) find(FindingCode::row_added, "thinned_traces");
    for (const auto& [row, content] : *rows) {
      seen.insert(row);
      const auto entry = entries_.find({number, row});
      if (entry == entries_.end()) {
        // If the chain is broken, the row's entry may be what was changed.
        if (out_.findings.empty()) find(FindingCode::row_added, name_of(table), static_cast<std::int64_t>(row));
      } else if (entry->second.trusted && entry->second.link.content != content) {
        find(FindingCode::row_changed, name_of(table), static_cast<std::int64_t>(row), entry->second.link.second);
      }
    }
    for (const auto& [key, entry] : entries_) {
      if (!emptied && key.first == number && entry.trusted && !seen.contains(key.second)) {
        find(FindingCode::row_missing, name_of(table), static_cast<std::int64_t>(key.second), entry.link.second);
      }
    }
  }

  void check_heads() {
    const auto head = db_.first(
        "SELECT links, link, key, signature FROM session_heads WHERE session = ?1",
        [](Row row) {
          return SignedHead{{row.u64(0), row.hash(1)}, row.hash(2), signature_of(row.bytes(3))};
        },
        session_);
    if (!head) return find(FindingCode::unreadable, "session_heads");
    if (!*head) return find(FindingCode::row_missing, "session_heads");
    anything_ = true;
    const bool chain_holds = out_.findings.empty();
    check_head(db_, session_.uuid, **head, "session_heads", out_.findings);
    if (!chain_holds || !out_.findings.empty()) return;
    const ChainHead& stored = (*head)->head;
    if (stored.links > out_.links) {
      find(FindingCode::row_missing, "session_chain", static_cast<std::int64_t>(out_.links));  // a tail was cut off
    } else if (stored.links < out_.links) {
      find(FindingCode::row_added, "session_chain", static_cast<std::int64_t>(stored.links));
    } else if (!follower_.ends_in(stored.link)) {
      find(FindingCode::head_broken, "session_heads");
    }
  }

  /// A signed row stands for the rows of a thinned recording. If it does not hold, it is the finding, not they.
  void check_thinned() {
    const auto at = thinned_at(db_, session_);
    const auto broken = check_thinned_trace(db_, session_);
    if (!at || !broken) return find(FindingCode::unreadable, "thinned_traces");
    thinned_ = at->has_value();
    anything_ = anything_ || thinned_;
    if (*broken) find(**broken, "thinned_traces");
  }

  /// Beyond hashes: each chunk decodes, holds the inputs that its row counts, and continues the chunk before it.
  void check_trace() {
    struct Chunk {
      std::uint64_t row, first_tick, count, elapsed_us, decoded, decoded_us;
      bool good;
    };
    const auto chunks = db_.all(
        "SELECT row, first_tick, inputs, elapsed_us, trace FROM trace_chunks WHERE session = ?1 ORDER BY row",
        [](Row row) {
          Chunk chunk{row.u64(0), row.u64(1), row.u64(2), row.u64(3), 0, 0, false};
          if (const auto inputs = decode_trace(row.bytes(4))) {
            chunk.good = true;
            chunk.decoded = inputs->size();
            for (const StepInput& input : *inputs) chunk.decoded_us += input.elapsed_us;
          }
          return chunk;
        },
        session_);
    if (!chunks) return;  // compare() reports it
    std::uint64_t tick = 1, elapsed = 0;
    for (const Chunk& chunk : *chunks) {
      const auto row = static_cast<std::int64_t>(chunk.row);
      const auto second = static_cast<std::int64_t>(elapsed / 1'000'000);
      ++out_.chunks;
      out_.inputs += chunk.decoded;
      // A byte that the hashes found gives no second finding.
      if (out_.findings.empty() && !chunk.good) find(FindingCode::unreadable, "trace_chunks", row, second);
      if (out_.findings.empty() && (chunk.first_tick != tick || chunk.count != chunk.decoded ||
                                    chunk.elapsed_us != elapsed + chunk.decoded_us)) {
        find(FindingCode::count_wrong, "trace_chunks", row, second);
      }
      tick = chunk.first_tick + chunk.count;
      elapsed = chunk.elapsed_us;
    }
    check_unpacks("SELECT row, state FROM key_states WHERE session = ?1", "key_states");
    check_unpacks("SELECT row, cuts FROM final_volumes WHERE session = ?1", "final_volumes");
    check_unpacks("SELECT row, packed FROM graded_criteria WHERE session = ?1", "graded_criteria");
  }

  void check_unpacks(const char* sql, const char* table) {
    const auto rows = db_.all(
        sql,
        [](Row row) {
          return std::pair{row.integer(0), unpack(row.bytes(1)).has_value()};
        },
        session_);
    if (!rows || !out_.findings.empty()) return;
    for (const auto& [row, good] : *rows) {
      if (!good) find(FindingCode::unreadable, table, row);
    }
  }

  void check_blob(const Hash256& hash) {
    const auto packed = db_.first("SELECT packed FROM blobs WHERE hash = ?1", [](Row row) { return row.blob(0); }, hash);
    if (!packed) return find(FindingCode::unreadable, "blobs");
    if (!*packed) return find(FindingCode::row_missing, "blobs");
    const auto bytes = unpack(**packed);
    if (!bytes || blake2b_256(*bytes) != hash) find(FindingCode::row_changed, "blobs");
  }

  /// The scenario version, the specimen and the header that the session names are the ones it started with.
  void check_references() {
    struct Names {
      Hash256 version, json, specimen;
      std::optional<Hash256> version_now, json_now, header;
    };
    const auto names = db_.first(
        "SELECT s.version_hash, s.json_hash, s.specimen_blob, v.content_hash, v.json, s.header "
        "FROM sessions s LEFT JOIN scenario_versions v ON v.id = s.version WHERE s.id = ?1",
        [](Row row) {
          Names n{row.hash(0), row.hash(1), row.hash(2), {}, {}, hash_from_hex(row.text(5))};
          if (!row.is_null(3)) n.version_now = row.hash(3);
          if (!row.is_null(4)) n.json_now = blake2b_256(row.bytes(4));
          return n;
        },
        session_);
    if (!names) return find(FindingCode::unreadable, "scenario_versions");
    if (!*names || !out_.findings.empty()) return;
    const Names& n = **names;
    if (!n.version_now) {
      find(FindingCode::row_missing, "scenario_versions");
    } else if (*n.version_now != n.version || *n.json_now != n.json) {
      find(FindingCode::row_changed, "scenario_versions");
    }
    if (n.specimen != Hash256{}) check_blob(n.specimen);
    if (n.header) check_blob(*n.header);
  }

  struct Entry {
    ChainLink link;
    bool trusted = false;  // the entry itself holds
  };
  Database& db_;
  SessionId session_;
  Verification out_;
  ChainFollower follower_{session_.uuid};
  std::map<std::pair<std::uint64_t, std::uint64_t>, Entry> entries_;  // (table, row)
  bool whole_ = true;                                                 // no gap in the chain's positions so far
  bool thinned_ = false;   // a row of thinned_traces stands for the recording
  bool anything_ = false;  // some table holds a row of the session
};

}  // namespace

Stored<Verification> verify_session(StorageContext& context, SessionId session) {
  const Snapshot snapshot(context.db);
  return SessionVerifier(context, session).verify();
}

Stored<std::vector<SessionId>> sessions_to_verify(StorageContext& context) {
  std::string sql =
      "SELECT id FROM sessions UNION SELECT session FROM session_chain UNION SELECT session FROM session_heads";
  for (const SessionTable table : kSessionTables) {
    if (table != SessionTable::sessions) sql.append(" UNION SELECT session FROM ").append(name_of(table));
  }
  return context.db.all(sql, [](Row row) { return row.id<SessionId>(0); });
}

}  // namespace cusp::storage
