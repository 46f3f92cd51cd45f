#include "storage/repositories/comments.h"

#include <algorithm>

#include "storage/records/statement_rows.h"

namespace cusp::storage {

Stored<std::vector<Comment>> Comments::of(SessionId session) {
  auto comments = c_.db.all(
      "SELECT id, session, author, at, tick, text FROM comments WHERE session = ?1 ORDER BY at, sequence",
      [](Row row) {
        Comment comment{row.uuid(0),    row.id<SessionId>(1), row.id<UserId>(2),
                        row.integer(3), std::nullopt,         row.text(5)};
        if (!row.is_null(4)) comment.tick = row.u64(4);
        return comment;
      },
      session);
  if (!comments) return comments;
  const auto statements = statements_of(c_.db, session);
  if (!statements) return std::unexpected(statements.error());
  for (const SignedStatement& s : in_force(*statements)) {
    if (s.kind != StatementKind::comment || s.text.empty()) continue;
    comments->push_back({s.id, s.session, s.author, s.at_utc_us, s.tick, s.text, s.place_mm});
  }
  return comments;
}

}  // namespace cusp::storage
