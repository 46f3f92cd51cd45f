#include "ui/instructor/library_model.h"

#include <QDateTime>
#include <algorithm>
#include <tuple>

#include "scenarios/format/read.h"
#include "ui/editor/specimen_form.h"
#include "ui/modules.h"
#include "ui/student/exercise_groups.h"
#include "ui/text/names.h"
#include "ui/widgets/chip.h"
#include "ui/widgets/format.h"
#include "ui/widgets/table.h"

namespace cusp::ui {

namespace {

/// What the records say of the versions of a row.
Stored<void> see_versions(Store& store, LibraryRow& row) {
  const auto versions = store.scenarios.versions(row.shown().id);
  if (!versions) return std::unexpected(versions.error());
  if (versions->empty()) return {};
  const auto withdrawn = store.scenarios.withdrawn(versions->back().id);
  if (!withdrawn) return std::unexpected(withdrawn.error());
  if (*withdrawn) row.withdrawn = versions->back().number;
  for (const ScenarioVersion& version : *versions)
    if (row.exercise && version.id == row.exercise->version) row.withdrawable = !version.author.is_nil();
  return {};
}

QString state_text(const LibraryRow& r) {
  const LibraryState state = state_of(r);
  if (r.exercise && state == LibraryState::draft) return LibraryModel::tr("Draft of the next");
  if (r.exercise && state == LibraryState::withdrawn) return LibraryModel::tr("Version %1 withdrawn").arg(*r.withdrawn);
  return state_name(state);
}

Chip::Kind chip_of(LibraryState state) {
  switch (state) {
    case LibraryState::delivered: return Chip::Kind::plain;
    case LibraryState::published: return Chip::Kind::good;
    case LibraryState::draft: return Chip::Kind::accent;
    case LibraryState::withdrawn: return Chip::Kind::look;
  }
  return Chip::Kind::plain;
}

}  // namespace

LibraryState state_of(const LibraryRow& r) {
  if (!r.exercise) return r.withdrawn ? LibraryState::withdrawn : LibraryState::draft;
  if (r.draft) return LibraryState::draft;
  if (r.withdrawn) return LibraryState::withdrawn;
  // A delivered version has any number. withdrawable is set if a person published the version shown.
  const bool as_delivered = !r.withdrawable && !r.exercise->scenario.key.empty();
  return as_delivered ? LibraryState::delivered : LibraryState::published;
}

QString state_name(LibraryState state) {
  switch (state) {
    case LibraryState::delivered: return LibraryModel::tr("Comes with Cusp");
    case LibraryState::published: return LibraryModel::tr("Published");
    case LibraryState::draft: return LibraryModel::tr("Draft");
    case LibraryState::withdrawn: return LibraryModel::tr("Withdrawn");
  }
  return {};
}

Stored<Library> load_library(Store& store, const Actor& actor) {
  auto list = load_exercises(store);
  if (!list) return std::unexpected(list.error());
  const auto drafts = store.scenarios.drafts(actor);
  if (!drafts) return std::unexpected(drafts.error());
  Library out;
  out.unreadable = std::move(list->unreadable);
  for (Exercise& e : list->exercises) out.rows.push_back({std::move(e), std::nullopt, 0});
  for (const ScenarioDraft& draft : *drafts) {
    auto scenario = read_scenario(draft.json);
    if (!scenario) {
      out.unreadable.push_back({StorageError::bad_value, scenario.error().where, draft.scenario.text()});
      continue;
    }
    bool published = false;
    for (LibraryRow& row : out.rows) {
      if (!row.exercise || row.exercise->scenario.id != draft.scenario) continue;
      row.draft = *scenario;
      row.saved_utc_us = draft.saved_utc_us;
      row.draft_json = draft.json;
      published = true;
    }
    if (!published) out.rows.push_back({std::nullopt, std::move(*scenario), draft.saved_utc_us, draft.json});
  }
  for (LibraryRow& row : out.rows)
    if (auto seen = see_versions(store, row); !seen) return std::unexpected(seen.error());
  std::ranges::stable_sort(out.rows, {}, [](const LibraryRow& row) {
    const bool comes_with_program = row.exercise && !row.exercise->scenario.key.empty();
    return std::tuple(!row.draft, -row.saved_utc_us, comes_with_program, group_of(row.shown()));
  });
  return out;
}

void LibraryModel::set_rows(std::vector<LibraryRow> rows) {
  beginResetModel();
  rows_ = std::move(rows);
  endResetModel();
}

bool LibraryModel::has_drafts() const {
  return std::ranges::any_of(rows_, [](const LibraryRow& row) { return row.saved_utc_us > 0; });
}

int LibraryModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int LibraryModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kColumns; }

QVariant LibraryModel::data(const QModelIndex& index, int role) const {
  const LibraryRow& r = row(index.row());
  if (role == Qt::DisplayRole) {
    switch (index.column()) {
      case kExercise: return local(r.shown().title);
      case kGroup: return group_name(group_of(r.shown()));
      case kTooth: return specimen_name(r.shown().specimen);
      case kVersion:
        if (r.exercise) return QLocale().toString(r.exercise->version_number);
        return r.withdrawn ? QLocale().toString(*r.withdrawn) : QString();
      case kState: return state_text(r);
      case kSaved:
        return r.saved_utc_us > 0 ? format_day_time(local_time(r.saved_utc_us))
                                  : QString();
      default: return {};
    }
  }
  if (role == ChipRole && index.column() == kState) return static_cast<int>(chip_of(state_of(r)));
  if (role == BoldRole && index.column() == kExercise) return true;
  if (role == Qt::TextAlignmentRole && index.column() == kVersion) return int(Qt::AlignRight | Qt::AlignVCenter);
  return {};
}

QVariant LibraryModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  if (role == Qt::TextAlignmentRole) {
    return int((section == kVersion ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
  }
  if (role != Qt::DisplayRole) return {};
  switch (section) {
    case kExercise: return tr("Exercise");
    case kGroup: return tr("Group");
    case kTooth: return tr("Tooth");
    case kVersion: return tr("Version");
    case kState: return tr("State");
    case kSaved: return tr("Draft saved");
    default: return {};
  }
}

}  // namespace cusp::ui
