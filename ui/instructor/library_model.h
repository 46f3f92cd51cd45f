/// Rows of the instructor's library: built-in exercises, published ones, and the actor's drafts. No widget.
#pragma once

#include <QAbstractTableModel>
#include <optional>
#include <vector>

#include "storage/store.h"
#include "ui/modules.h"
#include "ui/student/exercises.h"

namespace cusp::ui {

struct LibraryRow {
  std::optional<Exercise> exercise;  // nullopt: a draft that was never published
  std::optional<Scenario> draft;     // of the actor
  std::int64_t saved_utc_us = 0;     // of the draft; 0 without one
  std::string draft_json = {};       // in the records
  std::optional<int> withdrawn = {};  // newest version, if it is withdrawn; without an exercise all versions are
  bool withdrawable = false;          // the version shown was published by a person
  const Scenario& shown() const { return draft ? *draft : exercise->scenario; }
};

/// What a row is to its instructor.
enum class LibraryState : std::uint8_t { delivered, published, draft, withdrawn };
LibraryState state_of(const LibraryRow& row);
QString state_name(LibraryState state);

struct Library {
  std::vector<LibraryRow> rows;               // own drafts, the newest first; published here; built-in ones
  std::vector<StorageFailure> unreadable;
};
Stored<Library> load_library(Store& store, const Actor& actor);

class LibraryModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { kExercise, kGroup, kTooth, kVersion, kState, kSaved, kColumns };
  using QAbstractTableModel::QAbstractTableModel;
  void set_rows(std::vector<LibraryRow> rows);
  bool has_drafts() const;
  const LibraryRow& row(int index) const { return rows_[static_cast<std::size_t>(index)]; }
  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  std::vector<LibraryRow> rows_;
};

}  // namespace cusp::ui
