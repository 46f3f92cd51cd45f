#include "ui/instructor/withdrawal.h"

#include <algorithm>

#include "scenarios/format/write.h"
#include "ui/editor/editor_records.h"
#include "ui/editor/publish_facts.h"
#include "ui/modules.h"

namespace cusp::ui {

Stored<Withdrawal> plan_withdrawal(Store& store, const LibraryRow& row, std::int64_t now_utc_us) {
  const auto versions = store.scenarios.versions(row.exercise->scenario.id);
  if (!versions) return std::unexpected(versions.error());
  const auto uses = open_uses(store, *versions, now_utc_us);
  if (!uses) return std::unexpected(uses.error());
  Withdrawal out;
  out.number = row.exercise->version_number;
  out.assignments = static_cast<int>(std::ranges::count(*uses, out.number, &OlderUse::version));
  for (const ScenarioVersion& version : *versions) {
    const auto withdrawn = store.scenarios.withdrawn(version.id);
    if (!withdrawn) return std::unexpected(withdrawn.error());
    if (*withdrawn || version.number == out.number) continue;
    if (version.number < out.number) out.before = version.number;
    else out.newest = false;
  }
  return out;
}

Stored<void> withdraw(Store& store, const Actor& actor, const LibraryRow& row, const Withdrawal& plan,
                      const std::filesystem::path& database, const std::filesystem::path& cache) {
  if (!plan.before) {
    const auto start = open_for_editing(store, actor, *row.exercise, database, cache);
    if (!start) return std::unexpected(start.error());
    if (!start->kept) {
      const auto saved = store.scenarios.save_draft(actor, start->draft.id, canonical_json(start->draft), std::nullopt);
      if (!saved) return std::unexpected(saved.error());
    }
  }
  return store.scenarios.withdraw(actor, row.exercise->version);
}

}  // namespace cusp::ui
