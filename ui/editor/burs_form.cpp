#include "ui/editor/burs_form.h"

#include <QBoxLayout>
#include <QComboBox>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QSignalBlocker>
#include <algorithm>

#include "scenarios/burs/bur_catalogue.h"
#include "ui/editor/form_parts.h"
#include "ui/modules.h"
#include "ui/text/bur_text.h"
#include "ui/widgets/bur_silhouette.h"
#include "ui/widgets/format.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"

namespace cusp::ui {
/// The head from the side. The longest fills the height; the scale of small heads is larger.
class BurPicture : public QWidget {
 public:
  BurPicture() { setFixedSize(px(22), px(34)); }
  void show_bur(const Bur& bur) {
    if (bur_ == bur) return;
    bur_ = bur;
    update();
  }

 protected:
  void paintEvent(QPaintEvent*) override {
    constexpr double kLongestMm = 9.0;
    const double scale = std::min((height() - 2.0) / kLongestMm * 2.0, (height() - 2.0) / (bur_.radius_mm + bur_head_top_mm(bur_)));
    QPainter p(this);
    p.setRenderHint(QPainter::Antialiasing);
    p.setPen(Qt::NoPen);
    p.setBrush(tokens().text2);
    p.translate(width() / 2.0, 0.5 * (height() + (bur_head_top_mm(bur_) - bur_.radius_mm) * scale));
    p.drawPath(bur_head_path(bur_, scale));
  }

 private:
  Bur bur_;
};

BursForm::BursForm(EditorModel& model, QWidget* parent) : QWidget(parent), model_(model) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(px(16), px(12), px(16), px(16));
  column->setSpacing(px(6));
  add_section(column, tr("Burs"));
  QLabel* note = make_label(tr("Number, shape and diameter"), TextRole::caption, Weight::regular, "text2");
  column->addWidget(note);
  list_ = new QVBoxLayout;
  list_->setSpacing(px(6));
  column->addLayout(list_);
  column->addSpacing(px(8));
  add_section(column, tr("Add from the catalogue"));
  shapes_ = new QComboBox;
  shapes_->setAccessibleName(tr("Shape of the bur to add"));
  for (const std::string_view shape : bur_shapes())
    shapes_->addItem(bur_shape_name(shape), QString::fromUtf8(shape.data(), static_cast<qsizetype>(shape.size())));
  column->addWidget(shapes_);
  auto* adding = new QHBoxLayout;
  adding->setSpacing(px(6));
  catalogue_ = new QComboBox;
  catalogue_->setAccessibleName(tr("Bur to add"));
  add_ = make_button(tr("Add"), ButtonKind::standard, u"plus"_qs);
  add_->setAccessibleName(tr("Add a bur"));
  adding->addWidget(catalogue_, 1);
  adding->addWidget(add_);
  column->addLayout(adding);
  uses_ = make_label({}, TextRole::caption, Weight::regular, "text2");
  uses_->setWordWrap(true);
  column->addWidget(uses_);
  QLabel* doubt = make_label(tr("Sizes and outlines are the usual ones, not verified. Blades are not modelled: a head is the "
                                "body that they sweep."),
                             TextRole::caption, Weight::regular, "text2");
  doubt->setWordWrap(true);
  column->addWidget(doubt);
  column->addStretch();
  connect(add_, &QPushButton::clicked, this, [this] {
    const int index = catalogue_->currentData().toInt();
    if (catalogue_->count() > 0) model_.add_bur(bur_catalogue()[static_cast<std::size_t>(index)].bur);
  });
  connect(shapes_, &QComboBox::currentIndexChanged, this, &BursForm::fill_catalogue);
  connect(catalogue_, &QComboBox::currentIndexChanged, this, &BursForm::show_uses);
  connect(&model_, &EditorModel::changed, this, &BursForm::follow_model);
  follow_model();
}

void BursForm::follow_model() {
  const auto& burs = model_.scenario().instruments;
  // Another diameter or name keeps the rows: a number that is being typed stays in focus.
  std::vector<Profile> heads;
  for (const Bur& bur : burs) heads.push_back(bur.head);
  if (heads != built_) {
    while (QLayoutItem* item = list_->takeAt(0)) {
      if (item->widget()) {
        item->widget()->hide();
        item->widget()->deleteLater();
      }
      delete item;
    }
    rows_.clear();
    built_ = heads;
    for (std::size_t i = 0; i < burs.size(); ++i) rows_.push_back(make_row(i));
  }
  for (std::size_t i = 0; i < burs.size(); ++i) show_row(rows_[i], burs[i]);
  fill_catalogue();
}

BursForm::Row BursForm::make_row(std::size_t index) {
  Row out{};
  auto* row = new QWidget;
  auto* line = new QHBoxLayout(row);
  line->setContentsMargins(0, 0, 0, 0);
  line->setSpacing(px(6));
  auto* which = new QVBoxLayout;
  which->setSpacing(0);
  out.name = make_label({});
  out.shape = make_label({}, TextRole::caption, Weight::regular, "text2");
  which->addWidget(out.name);
  which->addWidget(out.shape);
  out.picture = new BurPicture;
  line->addWidget(out.picture);
  line->addLayout(which, 1);
  if (model_.scenario().instruments[index].head.ball()) {
    out.diameter = new NumberBox(model_, {}, u"mm"_qs, 0.1, 5, 0.1, 2,
                                 [this, index](double v) { return model_.set_bur_radius_mm(index, v / 2); });
    line->addWidget(out.diameter);
  } else {
    out.size = make_label({});
    line->addWidget(out.size);
  }
  out.remove = make_button({}, ButtonKind::quiet, u"trash"_qs);
  out.remove->setFixedWidth(px(32));
  line->addWidget(out.remove);
  connect(out.remove, &QPushButton::clicked, this, [this, index] { model_.remove_bur(index); });
  list_->addWidget(row);
  if (out.diameter != nullptr) list_->addWidget(out.diameter->note());
  return out;
}

void BursForm::show_row(const Row& row, const Bur& bur) {
  const QString name = QString::fromStdString(bur.name);
  row.picture->show_bur(bur);
  row.name->setText(tr("Bur %1").arg(name));
  row.shape->setText(bur_shape_name(shape_of(bur)));
  row.remove->setAccessibleName(tr("Remove bur %1").arg(name));
  row.remove->setToolTip(short_tool_tip(row.remove->accessibleName()));
  if (row.size != nullptr) row.size->setText(bur_diameter_text(bur));
  if (row.diameter == nullptr) return;
  row.diameter->setAccessibleName(tr("Diameter of bur %1").arg(name));
  row.diameter->show_value(2 * bur.radius_mm);
}

void BursForm::fill_catalogue() {
  const auto& burs = model_.scenario().instruments;
  const std::string shape = shapes_->currentData().toString().toStdString();
  const QSignalBlocker quiet(catalogue_);
  const QVariant kept = catalogue_->currentData();
  catalogue_->clear();
  const auto& all = bur_catalogue();
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].shape != shape || std::ranges::find(burs, all[i].bur.name, &Bur::name) != burs.end()) continue;
    //: Number of a bur and its diameter.
    catalogue_->addItem(tr("%1, %2").arg(QString::fromStdString(all[i].bur.name), bur_diameter_text(all[i].bur)),
                        static_cast<int>(i));
  }
  catalogue_->setCurrentIndex(std::max(catalogue_->findData(kept), 0));
  add_->setEnabled(catalogue_->count() > 0);
  show_uses();
}

void BursForm::show_uses() {
  if (catalogue_->count() == 0) return uses_->setText(tr("All burs of this shape are in the exercise."));
  const auto index = static_cast<std::size_t>(catalogue_->currentData().toInt());
  uses_->setText(bur_uses_text(bur_catalogue()[index].bur));
}

}  // namespace cusp::ui
