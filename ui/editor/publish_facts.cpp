#include "ui/editor/publish_facts.h"

#include <map>

#include "scenarios/format/read.h"
#include "ui/editor/change_messages.h"
#include "ui/editor/editor_records.h"
#include "ui/modules.h"

namespace cusp::ui {
namespace {

/// The newest version that is not withdrawn; nullptr without one.
Stored<const ScenarioVersion*> newest_of(Store& store, const std::vector<ScenarioVersion>& versions) {
  for (auto at = versions.rbegin(); at != versions.rend(); ++at) {
    const auto withdrawn = store.scenarios.withdrawn(at->id);
    if (!withdrawn) return std::unexpected(withdrawn.error());
    if (!*withdrawn) return &*at;
  }
  return nullptr;
}

}  // namespace

Stored<std::vector<OlderUse>> open_uses(Store& store, const std::vector<ScenarioVersion>& versions, std::int64_t now_utc_us) {
  std::map<VersionId, int> numbers;
  for (const ScenarioVersion& version : versions) numbers[version.id] = version.number;
  std::vector<OlderUse> out;
  const auto cohorts = store.cohorts.list();
  if (!cohorts) return std::unexpected(cohorts.error());
  for (const Cohort& cohort : *cohorts) {
    const auto assigned = store.assignments.for_cohort(cohort.id);
    if (!assigned) return std::unexpected(assigned.error());
    for (const Assignment& a : *assigned) {
      const auto number = numbers.find(a.version);
      if (number == numbers.end() || a.withdrawn || (a.due_utc_us && *a.due_utc_us < now_utc_us)) continue;
      out.push_back({cohort.name, number->second, a.kind, a.due_utc_us});
    }
  }
  return out;
}

Stored<PublishFacts> publish_facts(Store& store, const EditorModel& model, std::int64_t now_utc_us) {
  const auto number = next_version(store, model);
  if (!number) return std::unexpected(number.error());
  const auto versions = store.scenarios.versions(model.scenario().id);
  if (!versions) return std::unexpected(versions.error());
  const auto newest = newest_of(store, *versions);
  if (!newest) return std::unexpected(newest.error());
  auto uses = open_uses(store, *versions, now_utc_us);
  if (!uses) return std::unexpected(uses.error());
  PublishFacts out;
  out.number = *number;
  out.uses = std::move(*uses);
  out.tried = model.tried();
  // An exercise of the program that was never used here stands in no record.
  std::optional<Scenario> base = model.published();
  const int opened = base ? base->version : 0;
  if (*newest != nullptr && (*newest)->number != opened) {
    out.elsewhere = (*newest)->number > opened;
    auto read = read_scenario((*newest)->json);
    if (!read) return fail(StorageError::bad_value, read.error().where, (*newest)->id.text());
    base = std::move(*read);
    base->version = (*newest)->number;
  }
  if (base) {
    out.since = base->version;
    out.changes = change_messages(*base, model.scenario(), model.tissue_names());
  }
  return out;
}

}  // namespace cusp::ui
