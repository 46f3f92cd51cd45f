#include "ui/report/paper_criteria.h"

#include <QPainter>
#include <algorithm>
#include <array>
#include <span>

#include "ui/report/criteria_model.h"
#include "ui/widgets/gauge.h"
#include "ui/widgets/table.h"

namespace cusp::ui {
namespace {

constexpr int kColumnsShown[] = {CriteriaModel::kName, CriteriaModel::kMeasured, CriteriaModel::kWanted, CriteriaModel::kPoints, CriteriaModel::kOwn};
constexpr std::size_t kPointsAt = 3;  // the points stand beside a bar, on one line
// Shares of the page's width, with the student's own rating and without it.
constexpr std::array kRatedWidths = {0.3, 0.19, 0.17, 0.19, 0.15};
constexpr std::array kWidths = {0.36, 0.22, 0.2, 0.22};

class PaperTable {
 public:
  PaperTable(Paper& paper, const ReportData& data, const Tokens& tokens)
      : paper_(paper), tokens_(tokens), model_(data.result.grade, data.result.scenario, data.changes),
        widths_(data.own && !data.own->skipped() ? std::span<const double>(kRatedWidths) : std::span<const double>(kWidths)) {
    model_.set_own(data.own);
    model_.set_tissue_names(tissue_names_of(data.result));
  }
  int rows() const { return model_.rowCount(); }
  void write_heads() {
    const QFont font = paper_.font(10.5, Weight::bold);
    const auto head = [this](std::size_t i) { return model_.headerData(kColumnsShown[i], Qt::Horizontal, Qt::DisplayRole).toString(); };
    double high = paper_.u(kCriteriaRow);
    for (std::size_t i = 0; i < widths_.size(); ++i) high = std::max(high, height_at(i, head(i), font));
    for (std::size_t i = 0; i < widths_.size(); ++i) write(i, head(i), {font, tokens_.text2, high});
    paper_.skip(high / paper_.u(1) + 2);
    paper_.rule(tokens_.border);
    paper_.skip(3);
  }
  /// Of the row's texts. Units of the painter, as height_below().
  double height_of(int row) {
    double high = paper_.u(kCriteriaRow);
    for (std::size_t i = 0; i < widths_.size(); ++i) high = std::max(high, height_at(i, text_at(row, i), font_at(i)));
    return high;
  }
  double height_below(int row) const { return paper_.u(model_.change(row).isEmpty() ? 2 : 16); }
  void write_row(int row) {
    const double high = height_of(row);
    for (std::size_t i = 0; i < widths_.size(); ++i) write(i, text_at(row, i), {font_at(i), tokens_.text, high});
    if (const CriterionGrade& c = model_.criterion(row); c.points_max > 0) {
      const QRectF last = cell(kPointsAt, high);
      paint_bar(paper_.painter(), QRectF(last.left(), last.center().y() - paper_.u(2.5), paper_.u(44), paper_.u(5)), c.points / c.points_max,
                colour_of(model_.bar_role(row)), tokens_.sunken);
    }
    paper_.skip(high / paper_.u(1) + 2);
    if (const QString change = model_.change(row); !change.isEmpty()) write_change(change);
    paper_.rule(tokens_.line);
    paper_.skip(3);
  }

 private:
  struct Look {
    QFont font;
    QColor ink;
    double high;
  };
  static bool is_figure(std::size_t column) { return column == 1 || column == kPointsAt; }
  static int flags_at(std::size_t column) {
    return static_cast<int>((is_figure(column) ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter) | (column == kPointsAt ? 0 : int{Qt::TextWordWrap});
  }
  double height_at(std::size_t column, const QString& text, const QFont& font) {
    paper_.painter().setFont(font);
    return paper_.painter().boundingRect(QRectF(0.0, 0.0, cell(column, 0.0).width(), paper_.page().height()), flags_at(column), text).height();
  }
  QFont font_at(std::size_t column) const { return paper_.font(11, column == kPointsAt ? Weight::bold : Weight::regular); }
  QString text_at(int row, std::size_t column) const {
    const QModelIndex at = model_.index(row, kColumnsShown[column]);
    const QString text = model_.data(at, Qt::DisplayRole).toString(), second = model_.data(at, SecondRole).toString();
    return second.isEmpty() ? text : text + u' ' + second;
  }
  QRectF cell(std::size_t column, double high) const {
    const QRectF& page = paper_.page();
    double x = page.left();
    for (std::size_t i = 0; i < column; ++i) x += widths_[i] * page.width();
    return {x, paper_.y(), widths_[column] * page.width() - paper_.u(10), high};
  }
  void write(std::size_t column, const QString& text, const Look& look) {
    paper_.painter().setFont(look.font);
    paper_.painter().setPen(look.ink);
    paper_.painter().drawText(cell(column, look.high), flags_at(column), text);
  }
  /// One line: the remarks have the whole reason.
  void write_change(const QString& change) {
    const QRectF& page = paper_.page();
    const QRectF line(page.left() + paper_.u(10), paper_.y() - paper_.u(3), page.width() - paper_.u(20), paper_.u(15));
    paper_.painter().setFont(paper_.font(10));
    paper_.painter().setPen(tokens_.text2);
    paper_.painter().drawText(line, Qt::AlignLeft | Qt::AlignVCenter, paper_.painter().fontMetrics().elidedText(change, Qt::ElideRight, static_cast<int>(line.width())));
    paper_.skip(14);
  }

  Paper& paper_;
  const Tokens& tokens_;
  CriteriaModel model_;
  std::span<const double> widths_;
};

}  // namespace

void write_criteria(Paper& paper, const ReportData& data, const Tokens& tokens, const MakeRoom& make_room) {
  PaperTable table(paper, data, tokens);
  table.write_heads();
  for (int row = 0; row < table.rows(); ++row) {
    if (make_room(table.height_of(row) + table.height_below(row))) table.write_heads();
    table.write_row(row);
  }
  paper.skip(7);
}

}  // namespace cusp::ui
