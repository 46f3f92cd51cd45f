#include "storage/repositories/comments.h"

#include "storage/records/sealing.h"

namespace cusp::storage {

Stored<Comment> Comments::add(const Actor& actor, SessionId session, std::optional<std::uint64_t> tick,
                              const std::string& text) {
  if (auto allowed = require(actor, Action::comment); !allowed) return std::unexpected(allowed.error());
  if (text.empty() || text.size() > 10'000) return fail(StorageError::bad_value, "text");
  const Comment comment{Uuid::v7(), session, actor.id, c_.clock(), tick, text};
  Transaction transaction(c_.db);
  const std::int64_t sequence = c_.next_sequence(transaction);
  transaction.run(
      "INSERT INTO comments (id, session, author, at, sequence, tick, text) VALUES (?1, ?2, ?3, ?4, ?5, ?6, ?7)",
      comment.id, session, actor.id, comment.at_utc_us, sequence, tick, text);
  log_row(c_, transaction, actor.id, "commented", SealedTable::comments, comment.id);
  if (auto done = commit_sealed(c_, transaction); !done) return std::unexpected(done.error());
  return comment;
}

Stored<std::vector<Comment>> Comments::of(SessionId session) {
  return c_.db.all(
      "SELECT id, session, author, at, tick, text FROM comments WHERE session = ?1 ORDER BY at, sequence",
      [](Row row) {
        Comment comment{row.uuid(0),    row.id<SessionId>(1), row.id<UserId>(2),
                        row.integer(3), std::nullopt,         row.text(5)};
        if (!row.is_null(4)) comment.tick = row.u64(4);
        return comment;
      },
      session);
}

}  // namespace cusp::storage
