#include "ui/editor/burrs_form.h"

#include <QBoxLayout>
#include <QComboBox>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QSignalBlocker>
#include <algorithm>

#include "scenarios/burrs/burr_catalogue.h"
#include "ui/app/burr_words.h"
#include "ui/editor/form_parts.h"
#include "ui/widgets/burr_silhouette.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"

namespace cusp {
namespace {

/// The head from the side, the longest as high as there is room, small ones larger than they are beside it.
class BurrPicture : public QWidget {
 public:
  explicit BurrPicture(const Burr& burr) : burr_(burr) { setFixedSize(px(22), px(34)); }

 protected:
  void paintEvent(QPaintEvent*) override {
    constexpr double kLongestMm = 9.0;
    const double scale = std::min((height() - 2.0) / kLongestMm * 2.0, (height() - 2.0) / (burr_.radius_mm + burr_head_top_mm(burr_)));
    QPainter p(this);
    p.setRenderHint(QPainter::Antialiasing);
    p.setPen(Qt::NoPen);
    p.setBrush(tokens().text2);
    p.translate(width() / 2.0, 0.5 * (height() + (burr_head_top_mm(burr_) - burr_.radius_mm) * scale));
    p.drawPath(burr_head_path(burr_, scale));
  }

 private:
  Burr burr_;
};

}  // namespace

BurrsForm::BurrsForm(EditorModel& model, QWidget* parent) : QWidget(parent), model_(model) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(px(16), px(12), px(16), px(16));
  column->setSpacing(px(6));
  add_section(column, tr("Burrs"));
  QLabel* note = make_label(tr("Number, shape and diameter"), TextRole::caption, false, "text2");
  column->addWidget(note);
  list_ = new QVBoxLayout;
  list_->setSpacing(px(6));
  column->addLayout(list_);
  column->addSpacing(px(8));
  add_section(column, tr("Add from the catalogue"));
  shapes_ = new QComboBox;
  shapes_->setAccessibleName(tr("Shape of the burr to add"));
  for (const std::string_view shape : burr_shapes())
    shapes_->addItem(burr_shape_name(shape), QString::fromUtf8(shape.data(), static_cast<qsizetype>(shape.size())));
  column->addWidget(shapes_);
  auto* adding = new QHBoxLayout;
  adding->setSpacing(px(6));
  catalogue_ = new QComboBox;
  catalogue_->setAccessibleName(tr("Burr to add"));
  add_ = make_button(tr("Add"), ButtonKind::standard, u"plus"_qs);
  add_->setAccessibleName(tr("Add a burr"));
  adding->addWidget(catalogue_, 1);
  adding->addWidget(add_);
  column->addLayout(adding);
  uses_ = make_label({}, TextRole::caption, false, "text2");
  uses_->setWordWrap(true);
  column->addWidget(uses_);
  QLabel* doubt = make_label(tr("Sizes and outlines are the usual ones, not verified. Blades are not modelled: a head is the "
                                "body that they sweep."),
                             TextRole::caption, false, "text2");
  doubt->setWordWrap(true);
  column->addWidget(doubt);
  column->addStretch();
  connect(add_, &QPushButton::clicked, this, [this] {
    const int index = catalogue_->currentData().toInt();
    if (catalogue_->count() > 0) model_.add_burr(burr_catalogue()[static_cast<std::size_t>(index)].burr);
  });
  connect(shapes_, &QComboBox::currentIndexChanged, this, &BurrsForm::fill_catalogue);
  connect(catalogue_, &QComboBox::currentIndexChanged, this, &BurrsForm::tell_uses);
  connect(&model_, &EditorModel::changed, this, &BurrsForm::follow_model);
  follow_model();
}

void BurrsForm::follow_model() {
  const auto& burrs = model_.scenario().instruments;
  std::vector<std::string> names;
  for (const Burr& b : burrs) names.push_back(b.name);
  if (names != built_ || diameters_.size() != names.size()) {
    while (QLayoutItem* item = list_->takeAt(0)) {
      if (item->widget()) {
        item->widget()->hide();
        item->widget()->deleteLater();
      }
      delete item;
    }
    diameters_.clear();
    built_ = names;
    for (std::size_t i = 0; i < burrs.size(); ++i) {
      const QString name = QString::fromStdString(burrs[i].name);
      auto* row = new QWidget;
      auto* line = new QHBoxLayout(row);
      line->setContentsMargins(0, 0, 0, 0);
      line->setSpacing(px(6));
      auto* which = new QVBoxLayout;
      which->setSpacing(0);
      which->addWidget(make_label(tr("Burr %1").arg(name)));
      which->addWidget(make_label(burr_shape_name(shape_of(burrs[i])), TextRole::caption, false, "text2"));
      line->addWidget(new BurrPicture(burrs[i]));
      line->addLayout(which, 1);
      NumberBox* diameter = nullptr;
      if (burrs[i].head.ball()) {
        diameter = new NumberBox(model_, tr("Diameter of burr %1").arg(name), u"mm"_qs, 0.1, 5, 0.1, 2,
                                 [this, i](double v) { return model_.set_burr_radius_mm(i, v / 2); });
        line->addWidget(diameter);
      } else {
        line->addWidget(make_label(burr_diameter_text(burrs[i])));
      }
      QPushButton* away = make_button({}, ButtonKind::quiet, u"trash"_qs);
      away->setAccessibleName(tr("Remove burr %1").arg(name));
      away->setToolTip(tr("Remove burr %1").arg(name));
      away->setFixedWidth(px(32));
      line->addWidget(away);
      connect(away, &QPushButton::clicked, this, [this, i] { model_.remove_burr(i); });
      list_->addWidget(row);
      if (diameter != nullptr) list_->addWidget(diameter->note());
      diameters_.push_back(diameter);
    }
  }
  for (std::size_t i = 0; i < burrs.size(); ++i)
    if (diameters_[i] != nullptr) diameters_[i]->show_value(2 * burrs[i].radius_mm);
  fill_catalogue();
}

void BurrsForm::fill_catalogue() {
  const auto& burrs = model_.scenario().instruments;
  const std::string shape = shapes_->currentData().toString().toStdString();
  const QSignalBlocker quiet(catalogue_);
  const QVariant kept = catalogue_->currentData();
  catalogue_->clear();
  const auto& all = burr_catalogue();
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].shape != shape || std::ranges::find(burrs, all[i].burr.name, &Burr::name) != burrs.end()) continue;
    //: Number of a burr and its diameter.
    catalogue_->addItem(tr("%1, %2").arg(QString::fromStdString(all[i].burr.name), burr_diameter_text(all[i].burr)),
                        static_cast<int>(i));
  }
  catalogue_->setCurrentIndex(std::max(catalogue_->findData(kept), 0));
  add_->setEnabled(catalogue_->count() > 0);
  tell_uses();
}

void BurrsForm::tell_uses() {
  if (catalogue_->count() == 0) return uses_->setText(tr("All burrs of this shape are in the exercise."));
  const auto index = static_cast<std::size_t>(catalogue_->currentData().toInt());
  uses_->setText(burr_uses_text(burr_catalogue()[index].burr));
}

}  // namespace cusp
