#include "ui/report/criteria_model.h"

#include <algorithm>

#include "ui/text/grade_text.h"
#include "ui/widgets/format.h"

namespace cusp::ui {

CriteriaModel::CriteriaModel(const Grade& grade, const Scenario& scenario, std::vector<PointsChange> changes, QObject* parent)
    : QAbstractTableModel(parent), grade_(grade), points_(scaled_points(grade)), rubric_(scenario.rubric), target_(scenario.target), changes_(std::move(changes)) {
  std::vector<double> points, most;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if (!(grade_.criteria[i].points_max > 0)) continue;
    points.push_back(points_[i].points);
    most.push_back(points_[i].points_max);
  }
  decimals_ = points_decimals(points);
  most_decimals_ = points_decimals(most);
  for (const double one : most) most_size_ = std::max(most_size_, format_points_to(one, most_decimals_).size());
}

int CriteriaModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(grade_.criteria.size());
}
int CriteriaModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kColumns; }

void CriteriaModel::set_detail(Detail detail) {
  if (detail == detail_) return;
  Q_EMIT layoutAboutToBeChanged();
  detail_ = detail;
  Q_EMIT layoutChanged();  // the columns' widths change
}

QString CriteriaModel::most_text(int row) const {
  constexpr QChar kFigureSpace(0x2007);  // as wide as a figure
  return u"/ "_qs + format_points_to(points(row).points_max, most_decimals_).rightJustified(most_size_, kFigureSpace);
}

QString CriteriaModel::change(int row) const {
  const auto found = std::ranges::find(changes_, criterion(row).id, &PointsChange::criterion);
  return found == changes_.end() ? QString() : found->text;
}

std::optional<OwnRating> CriteriaModel::own_rating(int row) const {
  if (!own_) return std::nullopt;
  const auto found = own_->ratings.find(criterion(row).id);
  return found == own_->ratings.end() ? std::nullopt : std::optional(found->second);
}

QVariant CriteriaModel::own_data(int row, int role) const {
  const auto own = own_rating(row);
  const QString against = own_against_measured(row);
  const QString text = own ? own_rating_name(*own) : u"–"_qs;
  switch (role) {
    case Qt::DisplayRole: return text;
    case QuietRole: return !own;
    case Qt::ToolTipRole: return against;
    case Qt::AccessibleTextRole: return against.isEmpty() ? text : tr("%1, %2").arg(text, against);
    case IconInkRole: return static_cast<int>(Ink::text2);
    case IconRole: {
      const OwnRating measured = measured_rating(grade_, criterion(row));
      if (against.isEmpty() || *own == measured) return QString();
      return *own < measured ? u"chevron_up"_qs : u"chevron_down"_qs;
    }
    default: return {};
  }
}

QString CriteriaModel::own_against_measured(int row) const {
  const auto own = own_rating(row);
  if (!own || !criterion(row).measure.measured || neutral(row)) return {};
  const OwnRating measured = measured_rating(grade_, criterion(row));
  if (*own == measured) return tr("rated as it was measured");
  return *own < measured ? tr("rated higher than it was measured") : tr("rated lower than it was measured");
}

bool CriteriaModel::neutral(int row) const {
  const CriterionGrade& c = criterion(row);
  return (c.reason_code == "little_drilled" && change(row).isEmpty()) || !(c.points_max > 0);
}

Bar::Role CriteriaModel::bar_role(int row) const {
  const CriterionGrade& c = criterion(row);
  if (neutral(row)) return Bar::Role::plain;
  if (points(row).points_max - points(row).points < kLeastShownLoss) return Bar::Role::good;
  return c.points < c.points_max / 2 ? Bar::Role::bad : Bar::Role::look;
}

QVariant CriteriaModel::data(const QModelIndex& index, int role) const {
  const CriterionGrade& c = criterion(index.row());
  const Measure& m = c.measure;
  const bool marked = c.points_max > 0;  // of a target that was left out, what was not measured
  if (index.column() == kOwn) return own_data(index.row(), role);
  switch (role) {
    case Qt::TextAlignmentRole:
      if (index.column() == kMeasured || index.column() == kPoints) return static_cast<int>(Qt::AlignTrailing | Qt::AlignVCenter);
      return {};
    case IconRole:
      if (index.column() == kPlace) return m.where_mm ? u"target"_qs : QString();
      if (index.column() == kName) return change(index.row()).isEmpty() ? QString() : u"edit"_qs;
      if (index.column() != kSign) return {};
      if (!m.measured && !marked) return u"info"_qs;
      if (neutral(index.row())) return u"minus"_qs;
      return bar_role(index.row()) == Bar::Role::good  ? u"check"_qs
             : bar_role(index.row()) == Bar::Role::bad ? u"cross"_qs
                                                       : u"warning"_qs;
    case IconInkRole:
      if (index.column() != kSign || neutral(index.row())) return static_cast<int>(Ink::text2);
      return static_cast<int>(bar_role(index.row()) == Bar::Role::good  ? Ink::good
                              : bar_role(index.row()) == Bar::Role::bad ? Ink::bad
                                                                        : Ink::look);
    case SecondRole:
      if (index.column() == kMeasured && m.measured && detail_ == Detail::whole) {
        return measure_uncertainty(m);
      }
      if (index.column() == kPoints && marked) return most_text(index.row());
      return {};
    case ShareRole:
      return index.column() == kPoints && marked && detail_ == Detail::whole ? QVariant(c.points / c.points_max) : QVariant();
    case BarRole: return static_cast<int>(bar_role(index.row()));
    case BoldRole: return index.column() == kPoints && marked;
    case QuietRole: return !marked && index.column() == kPoints;
    case Qt::ToolTipRole:
      if (const QString changed = change(index.row()); !changed.isEmpty()) return short_tool_tip(changed);
      return c.band == "borderline" && c.reason_code != "little_drilled" ? tr("An edge of the marking is nearer than the figure is known.") : reason_text(c);
    case Qt::AccessibleTextRole:
      if (index.column() == kSign) {
        if (!marked) return tr("not marked");
        if (neutral(index.row())) return tr("counts with the target");
        return bar_role(index.row()) == Bar::Role::good ? tr("full points") : tr("points lost");
      }
      if (index.column() == kName && !change(index.row()).isEmpty()) return tr("%1. %2").arg(text_of(index), change(index.row()));
      if (index.column() == kPlace) return m.where_mm ? tr("shows its place on the tooth") : QString();
      if (index.column() == kMeasured && m.measured) {
        return measure_text(m);
      }
      //: Points of a criterion, and the most it can bring.
      if (index.column() == kPoints && marked) return tr("%1 of %2").arg(format_points(points(index.row()).points), format_points(points(index.row()).points_max));
      return {};
    case Qt::DisplayRole: return text_of(index);
    default: return {};
  }
}

QString CriteriaModel::text_of(const QModelIndex& index) const {
  const CriterionGrade& c = criterion(index.row());
  const Measure& m = c.measure;
  const bool marked = c.points_max > 0;  // of a target that was left out, what was not measured
  switch (index.column()) {
    case kName: {
      const QString name = metric_name(c.id, &target_, tissue_names_);
      return change(index.row()).isEmpty() ? name : tr("%1 (changed)").arg(name);
    }
    case kMeasured:
      return m.measured ? measure_value(m) : tr("not measured");
    case kWanted:
      for (const Criterion& wanted : rubric_.criteria) {
        if (wanted.metric == c.id) return wanted_text(wanted);
      }
      return {};
    case kPoints: return marked ? format_points_to(points(index.row()).points, decimals_) : tr("no points");
    default: return {};
  }
}

QVariant CriteriaModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  if (role == Qt::TextAlignmentRole && (section == kMeasured || section == kPoints)) {
    return static_cast<int>(Qt::AlignTrailing | Qt::AlignVCenter);
  }
  if (role != Qt::DisplayRole) return {};
  switch (section) {
    case kName: return tr("Criterion");
    case kMeasured: return tr("Measured");
    case kWanted: return tr("Full points");
    case kPoints: return tr("Points");
    case kOwn: return tr("Own rating");
    default: return QString();
  }
}

}  // namespace cusp::ui
