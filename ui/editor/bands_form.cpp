#include "ui/editor/bands_form.h"

#include <QBoxLayout>
#include <QLabel>
#include <QPainter>
#include <algorithm>

#include "scenarios/format/keys.h"
#include "ui/editor/form_parts.h"
#include "ui/text/grade_text.h"
#include "ui/text/names.h"
#include "ui/widgets/parts.h"

namespace cusp::ui {
namespace {

constexpr double kAnything = 1e6;  // of a metric without a range of its own, as scenarios/format/ranges

/// The sign of a mark, beside its name.
class MarkSign : public QWidget {
 public:
  explicit MarkSign(TriedBy by) : by_(by) { setFixedSize(px(16), px(16)); }

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter p(this);
    p.setRenderHint(QPainter::Antialiasing);
    paint_band_mark(p, QRectF(rect()).center(), by_);
  }

 private:
  TriedBy by_;
};

BandRange possible_of(const std::string& metric) {
  const auto known = metric_from_key(metric);
  return known ? BandRange{known->least, known->most} : BandRange{-kAnything, kAnything};
}

bool in_order(const Bands& bands) {
  return std::ranges::is_sorted(kBandEdges, {}, [&](double Bands::*edge) { return bands.*edge; });
}

}  // namespace

BandsForm::BandsForm(EditorModel& model, std::size_t index, QWidget* parent) : QFrame(parent), model_(model), index_(index) {
  setProperty("kind", u"sunken"_qs);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(px(8), px(8), px(8), px(8));
  column->setSpacing(px(4));
  const QString name = metric_name(criterion().metric, &model_.scenario().target, model_.tissue_names());
  const QString unit = metric_unit(criterion().metric);
  const auto take = [this](const Bands& bands) { return model_.set_bands(index_, bands); };
  picture_ = new BandPicture({name, unit, possible_of(criterion().metric)}, take, [this] { model_.end_gesture(); });
  column->addWidget(picture_);
  if (is_yes_or_no(criterion().metric)) {
    column->addWidget(make_label(tr("1 means yes, 0 means no."), TextRole::caption, Weight::regular, "text2"));
  }
  marks_ = new QVBoxLayout;
  marks_->setSpacing(0);
  column->addLayout(marks_);
  const double end = band_end(unit.toStdString());
  for (std::size_t edge = 0; edge < numbers_.size(); ++edge) {
    numbers_[edge] = new NumberBox(model_, tr("%1: %2").arg(name, band_edge_name(edge)), unit, -end, end, picture_->step(), 2,
                                   [this, edge](double value) {
                                     Bands bands = criterion().bands;
                                     bands.*kBandEdges[edge] = value;
                                     return model_.set_bands(index_, bands);
                                   });
    add_row(column, band_edge_name(edge), numbers_[edge]);
  }
  connect(&model_, &EditorModel::tried_out, this, &BandsForm::show_marks);
  follow_model();
}

void BandsForm::follow_model() {
  const Bands& bands = criterion().bands;
  picture_->setVisible(in_order(bands));  // a check names bands that are not; the numbers mend them
  if (in_order(bands)) picture_->show_bands(bands);
  for (std::size_t edge = 0; edge < numbers_.size(); ++edge) numbers_[edge]->show_value(bands.*kBandEdges[edge]);
  show_marks();
}

void BandsForm::show_marks() {
  while (QLayoutItem* item = marks_->takeAt(0)) {
    delete item->widget();
    delete item;
  }
  std::vector<BandMark> marks;
  for (const TriedBy by : kTriedBy) {
    const auto measured = model_.try_outs().value(by, criterion().metric, model_.scenario());
    if (!measured) continue;
    marks.push_back({by, measured->value, measured->uncertainty});
    auto* line = new QWidget;
    auto* row = new QHBoxLayout(line);
    row->setContentsMargins(px(4), 0, 0, 0);
    row->setSpacing(px(4));
    row->addWidget(new MarkSign(by));
    const QString who = by == TriedBy::author ? tr("Your try-out") : operator_name(std::string(key_of(by)));
    QLabel* label = make_label(tr("%1: %2").arg(who, measure_text(*measured)),
                               TextRole::caption, Weight::regular, "text2");
    row->addWidget(label, 1);
    marks_->addWidget(line);
  }
  picture_->set_marks(std::move(marks));
}

}  // namespace cusp::ui
