/// The audit log as a table, newest first, fetched by pages: who did what to whom, and what verification found. No widget.
#pragma once

#include <QAbstractTableModel>
#include <functional>
#include <map>
#include <optional>
#include <vector>

#include "storage/records/audit_writer.h"
#include "ui/modules.h"

namespace cusp::ui {

/// Names of what the log names by id: people, cohorts, this station.
using LogNames = std::map<Uuid, QString>;

/// What a verification said about the entries that were there.
struct LogProof {
  std::int64_t entries = 0;             // numbers below were there
  std::int64_t holding = 0;             // numbers below hold
  std::optional<std::int64_t> broken{};  // the entry that breaks the chain
};

class LogModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { kNumber, kWhen, kWho, kWhat, kAbout, kProof, kColumns };
  /// Entries below a number, newest first; empty: there is none. nullopt: it failed, and no further page is asked for before
  /// fetch_again().
  using Fetch = std::function<std::optional<std::vector<AuditEntry>>(std::int64_t before_number)>;
  explicit LogModel(QObject* parent = nullptr) : QAbstractTableModel(parent) {}
  void set_names(LogNames names) { names_ = std::move(names); }
  /// Reads the first page.
  void begin(Fetch fetch);
  /// The page that was asked for last could not be read: entries are missing after the last one.
  bool failed() const { return failed_; }
  /// Asks for the page that failed.
  void fetch_again();
  void set_proof(const LogProof& proof);
  bool canFetchMore(const QModelIndex& parent = {}) const override;
  void fetchMore(const QModelIndex& parent = {}) override;
  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  const AuditEntry& entry(int row) const { return entries_[static_cast<std::size_t>(row)]; }

 private:
  std::vector<AuditEntry> entries_;
  LogNames names_;
  LogProof proof_;
  Fetch fetch_;
  bool more_ = false, failed_ = false;
};

/// Who acted: a name, "Cusp", or an account whose name is gone.
QString actor_text(const AuditEntry& entry, const LogNames& names);
/// Whom or what it concerns; an id's last digits where there is no name.
QString about_text(const AuditEntry& entry, const LogNames& names);

}  // namespace cusp::ui
