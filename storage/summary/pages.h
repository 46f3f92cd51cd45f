/// The queries of lists and figures over session_summaries. Each text is one of a fixed set: a filter chooses which
/// conditions stand in it, and binds their values. Within storage/summary only.
#pragma once

#include <optional>
#include <vector>

#include "storage/summary/figures.h"
#include "storage/summary/history.h"

namespace cusp::storage {

/// Keys of the listed sessions that fit, newest first: at most `limit` of those after `after`.
/// A cohort and a search are answered student by student, so that a page costs as much as there are students, not sessions.
Stored<std::vector<HistoryKey>> keys_of_page(Database& db, const HistoryFilter& filter,
                                             const std::optional<HistoryKey>& after, int limit);

/// The rows of these sessions, in this order, listed or not. A session that has no summary, student or version is left out.
Stored<std::vector<HistoryRow>> rows_of(Database& db, const std::vector<SessionId>& sessions);

/// Accounts of instructors and administrators.
Stored<std::vector<UserId>> staff_of(Database& db);

/// Every student whom the filter admits, each once; nullopt: it names none.
Stored<std::optional<std::vector<UserId>>> students_of(Database& db, const HistoryFilter& filter);

/// The filter, narrowed to what the actor may read.
Stored<HistoryFilter> readable(const Actor& actor, const HistoryFilter& filter);

/// Of the graded, listed attempts that fit.
Stored<Figures> read_figures(Database& db, const HistoryFilter& filter);

}  // namespace cusp::storage
