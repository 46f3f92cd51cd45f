#include "ui/admin/log_model.h"

#include <QLocale>
#include <iterator>

#include "ui/text/audit_log_text.h"
#include "ui/widgets/format.h"
#include "ui/widgets/table.h"

namespace cusp::ui {
namespace {

constexpr std::size_t kDigitsShown = 8;  // of an id: its last ones, the first are a time

QString name_in(const LogNames& names, const Uuid& id) {
  const auto it = names.find(id);
  return it == names.end() ? QString() : it->second;
}

QString short_id(const Uuid& id) {
  const std::string text = id.text();
  return QString::fromStdString(text.substr(text.size() - kDigitsShown));
}

QString when_text(std::int64_t at_utc_us) { return QLocale().toString(local_time(at_utc_us), date_pattern() + u", HH:mm:ss"_qs); }

QString proof_text_of(const LogProof& proof, std::int64_t number) {
  if (proof.broken == number) return LogModel::tr("breaks the chain");
  if (number >= proof.entries) return {};
  return number < proof.holding ? LogModel::tr("holds") : LogModel::tr("not proven");
}

Chip::Kind proof_chip(const LogProof& proof, std::int64_t number) {
  if (proof.broken == number) return Chip::Kind::bad;
  return number < proof.holding ? Chip::Kind::good : Chip::Kind::look;
}

}  // namespace

QString actor_text(const AuditEntry& entry, const LogNames& names) {
  if (entry.actor == UserId{}) return u"Cusp"_qs;
  const QString name = name_in(names, entry.actor.uuid);
  return name.isEmpty() ? LogModel::tr("erased account") : name;
}

QString about_text(const AuditEntry& entry, const LogNames& names) {
  if (entry.subject == Uuid{}) return {};
  QString about = name_in(names, entry.subject);
  if (about.isEmpty()) about = short_id(entry.subject);
  // A student who joins or leaves a cohort: the detail is the cohort's id.
  const auto second = Uuid::parse(entry.detail);
  const QString cohort = second ? name_in(names, *second) : QString();
  return cohort.isEmpty() ? about : LogModel::tr("%1, %2").arg(about, cohort);
}

void LogModel::begin(Fetch fetch) {
  beginResetModel();
  fetch_ = std::move(fetch);
  auto first = fetch_(INT64_MAX);
  failed_ = !first;
  entries_ = first ? std::move(*first) : std::vector<AuditEntry>();
  more_ = failed_ || !entries_.empty();
  endResetModel();
}

void LogModel::set_proof(const LogProof& proof) {
  proof_ = proof;
  if (rowCount() > 0) Q_EMIT dataChanged(index(0, kProof), index(rowCount() - 1, kProof));
}

bool LogModel::canFetchMore(const QModelIndex& parent) const { return !parent.isValid() && more_ && !failed_; }

void LogModel::fetchMore(const QModelIndex& parent) {
  if (!canFetchMore(parent)) return;
  auto page = fetch_(entries_.empty() ? INT64_MAX : entries_.back().number);
  failed_ = !page;
  if (failed_) return;
  more_ = !page->empty();
  if (!more_) return;
  beginInsertRows({}, rowCount(), rowCount() + static_cast<int>(page->size()) - 1);
  entries_.insert(entries_.end(), std::make_move_iterator(page->begin()), std::make_move_iterator(page->end()));
  endInsertRows();
}

void LogModel::fetch_again() {
  failed_ = false;
  fetchMore();
}

int LogModel::rowCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : static_cast<int>(entries_.size()); }
int LogModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kColumns; }

QVariant LogModel::data(const QModelIndex& index, int role) const {
  const AuditEntry& e = entry(index.row());
  const int column = index.column();
  if (role == Qt::TextAlignmentRole && column == kNumber) return static_cast<int>(Qt::AlignTrailing | Qt::AlignVCenter);
  if (role == BoldRole) return column == kWhat;
  if (role == ChipRole && column == kProof && !proof_text_of(proof_, e.number).isEmpty()) {
    return static_cast<int>(proof_chip(proof_, e.number));
  }
  if (role == Qt::ToolTipRole && column == kWho) return tool_tip_text(actor_text(e, names_));
  if (role == Qt::ToolTipRole && column == kAbout && e.subject != Uuid{})
    return tool_tip_text(about_text(e, names_) + u" · "_qs + QString::fromStdString(e.subject.text()));
  if (role != Qt::DisplayRole) return {};
  switch (column) {
    case kNumber: return QLocale().toString(static_cast<qlonglong>(shown_number(e.number)));
    case kWhen: return when_text(e.at_utc_us);
    case kWho: return actor_text(e, names_);
    case kWhat: return entry_text(e);
    case kAbout: return about_text(e, names_);
    case kProof: return proof_text_of(proof_, e.number);
    default: return {};
  }
}

QVariant LogModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  switch (section) {
    case kNumber: return tr("Entry");
    case kWhen: return tr("When");
    case kWho: return tr("Who");
    case kWhat: return tr("What");
    case kAbout: return tr("Concerns");
    case kProof: return tr("Verification");
    default: return {};
  }
}

}  // namespace cusp::ui
