#include "ui/admin/criteria_card.h"

#include <algorithm>
#include <utility>

#include "ui/text/grade_text.h"
#include "ui/widgets/format.h"
#include "ui/widgets/gauge.h"
#include "ui/widgets/table.h"

namespace cusp::ui {
namespace {

constexpr double kGoodShare = 0.9, kPoorShare = 0.5;  // of a criterion's points, for the colour of its bar
constexpr int kMostRows = 8;                          // shown without scrolling

QString percent(double share) { return format({100 * share, std::nullopt, u"%"_qs, 0}); }

}  // namespace

void CriterionFiguresModel::set_rows(std::vector<CriterionFigures> rows, const Region& target, const TissueNames& tissues) {
  beginResetModel();
  target_ = target;
  tissues_ = tissues;
  rows_ = std::move(rows);
  endResetModel();
}

int CriterionFiguresModel::rowCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : static_cast<int>(rows_.size()); }
int CriterionFiguresModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kColumns; }

QVariant CriterionFiguresModel::data(const QModelIndex& index, int role) const {
  const CriterionFigures& c = rows_[static_cast<std::size_t>(index.row())];
  if (role == Qt::TextAlignmentRole && index.column() != kName) return static_cast<int>(Qt::AlignTrailing | Qt::AlignVCenter);
  if (role == ShareRole && index.column() == kShare) return c.mean_share;
  if (role == BarRole) {
    const Bar::Role bar = c.mean_share >= kGoodShare ? Bar::Role::good : c.mean_share < kPoorShare ? Bar::Role::bad : Bar::Role::look;
    return static_cast<int>(bar);
  }
  if (role == BoldRole) return index.column() == kShare;
  if (role != Qt::DisplayRole) return {};
  switch (index.column()) {
    case kName: return metric_name(c.id, &target_, tissues_);
    case kShare: return percent(c.mean_share);
    case kFull: return format_share(c.full, c.attempts);
    case kAttempts: return format_number(c.attempts, 0);
    default: return {};
  }
}

QVariant CriterionFiguresModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  if (role == Qt::TextAlignmentRole && section != kName) return static_cast<int>(Qt::AlignTrailing | Qt::AlignVCenter);
  if (role != Qt::DisplayRole) return {};
  switch (section) {
    case kName: return tr("Criterion");
    case kShare: return tr("Points, mean");
    case kFull: return tr("With full points");
    case kAttempts: return tr("Attempts");
    default: return QString();
  }
}

CriteriaCard::CriteriaCard(QWidget* parent) : Card(CriteriaCard::tr("By criterion"), {}, parent), model_(new CriterionFiguresModel(this)), table_(new Table) {
  setAccessibleName(tr("By criterion"));
  set_aside(tr("graded ones of the newest %1 attempts that fit, the hardest first").arg(format_number(kMostByCriterion, 0)));
  table_->setAccessibleName(tr("By criterion"));
  table_->setModel(model_);
  table_->set_stretch_column(CriterionFiguresModel::kName);
  body()->addWidget(table_);
  hide();
}

void CriteriaCard::show_figures(std::vector<CriterionFigures> figures, const Region& target, const TissueNames& tissues) {
  table_->set_rows_shown(std::clamp(static_cast<int>(figures.size()), 1, kMostRows));
  model_->set_rows(std::move(figures), target, tissues);
}

}  // namespace cusp::ui
