/// The rows that many_sessions copies are those that the product's calls write, and verify.
#include "tests/storage/many_sessions.h"

#include <gtest/gtest.h>

#include <cstdio>

#include "storage/records/session_tables.h"

namespace cusp::test {
namespace {

/// Every column of the session's rows in a table but those that each session has of its own.
std::vector<std::string> content(Database& db, const std::string& table, const std::string& key, SessionId session) {
  const auto columns = must(db.first(
      "SELECT group_concat('quote(' || name || ')', '||'' ''||') FROM pragma_table_info(?1) WHERE name NOT IN "
      "('id', 'session', 'subject', 'number', 'sequence', 'content', 'link', 'signature', 'attempt', 'detail')",
      [](Row row) { return row.text(0); }, table));
  const std::string order = key == "subject" ? " ORDER BY number" : " ORDER BY 1";
  return must(db.all("SELECT " + columns.value() + " FROM " + table + " WHERE " + key + " = ?1" + order,
                     [](Row row) { return row.text(0); }, session));
}

/// Event and number of links; without the link.
std::vector<std::string> seals(Database& db, SessionId session) {
  return must(db.all("SELECT detail FROM audit_log WHERE subject = ?1 ORDER BY number",
                     [](Row row) { return row.text(0).substr(0, row.text(0).rfind(' ')); }, session));
}

std::vector<std::int64_t> sequences(Database& db, SessionId session) {
  auto all = must(db.all("SELECT sequence FROM sessions WHERE id = ?1 UNION ALL SELECT sequence FROM session_events WHERE session = ?1 "
                         "UNION ALL SELECT sequence FROM grades WHERE session = ?1 UNION ALL "
                         "SELECT * FROM (SELECT sequence FROM audit_log WHERE subject = ?1 ORDER BY number)",
                         [](Row row) { return row.integer(0); }, session));
  const std::int64_t first = all.front();
  for (std::int64_t& sequence : all) sequence -= first;
  return all;
}

/// Of whole pages, without recordings and final volumes.
double bytes_of(int sessions) {
  const Folder folder;
  const auto store = open(folder / "a.db");
  write_many(*store, sessions, CopiedRows::all);
  return must(store->database().first("SELECT sum(pgsize) FROM dbstat WHERE aggregate = 1 AND name NOT IN ('trace_chunks', 'final_volumes')",
                                      [](Row row) { return row.real(0); })).value();
}

/// Four of five are graded by ten criteria. The people and what else the file holds once are in both files. Measured: 3,917; with
/// the indexes of schema 14, 4,227.
TEST(ManySessions, take_at_most_4096_bytes_each_besides_recording_and_final_volume) {
  const double bytes = (bytes_of(6000) - bytes_of(1000)) / 5000;
  std::printf("%.0f bytes a session\n", bytes);
  EXPECT_LE(bytes, 4096);
  EXPECT_GE(bytes, 3500) << "a copy lacks chain, seals or criteria";
}

TEST(ManySessions, verify_and_are_such_as_the_products_calls_write) {
  const Folder folder;
  const auto now = std::make_shared<std::int64_t>(kNow);
  const auto store = open(folder / "a.db", quick(now));
  constexpr int kCopies = 300;
  const ManySessions m = write_many(*store, kCopies, CopiedRows::all);
  Database& db = store->database();
  for (const int i : {0, 3, 8, 11, 57, 298}) {
    ASSERT_TRUE(is_graded(i));
    const SessionId copy = m.copies[static_cast<std::size_t>(i)];
    *now = *must(db.first("SELECT started_at FROM sessions WHERE id = ?1", [](Row row) { return row.integer(0); }, copy));
    const SessionId drilled = drill(*store, as_copy(m, i));
    for (const SessionTable table : kSessionTables) {
      const std::string key = table == SessionTable::sessions ? "id" : "session";
      const auto rows = content(db, std::string(name_of(table)), key, drilled);
      EXPECT_EQ(content(db, std::string(name_of(table)), key, copy), rows) << i;
      EXPECT_EQ(rows.empty(), table == SessionTable::key_states || table == SessionTable::criteria) << name_of(table);
    }
    for (const char* table : {"session_chain", "session_heads", "session_summaries"}) {
      EXPECT_EQ(content(db, table, "session", copy), content(db, table, "session", drilled)) << i;
    }
    EXPECT_EQ(content(db, "audit_log", "subject", copy), content(db, "audit_log", "subject", drilled)) << i;
    EXPECT_EQ(seals(db, copy), seals(db, drilled)) << i;
    EXPECT_EQ(sequences(db, copy), sequences(db, drilled)) << i;
  }
  const auto proof = must(verify_store(store->context()));
  EXPECT_TRUE(proof.intact()) << proof.findings.front().table << ' ' << key_of(proof.findings.front().code);
  EXPECT_EQ(proof.sessions, static_cast<std::uint64_t>(m.listed) + 6);
}

}  // namespace
}  // namespace cusp::test
