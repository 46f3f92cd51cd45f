#include "ui/editor/burrs_form.h"

#include <QBoxLayout>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <algorithm>

#include "ui/editor/burr_catalogue.h"
#include "ui/editor/form_parts.h"
#include "ui/widgets/format.h"
#include "ui/widgets/parts.h"

namespace cusp {

BurrsForm::BurrsForm(EditorModel& model, QWidget* parent) : QWidget(parent), model_(model) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(px(16), px(12), px(16), px(16));
  column->setSpacing(px(6));
  add_section(column, tr("Round burrs"));
  QLabel* note = make_label(tr("Number and diameter"), TextRole::caption, false, "text2");
  column->addWidget(note);
  list_ = new QVBoxLayout;
  list_->setSpacing(px(6));
  column->addLayout(list_);
  column->addSpacing(px(8));
  auto* adding = new QHBoxLayout;
  adding->setSpacing(px(6));
  catalogue_ = new QComboBox;
  catalogue_->setAccessibleName(tr("Burr to add"));
  add_ = make_button(tr("Add"), ButtonKind::standard, u"plus"_qs);
  add_->setAccessibleName(tr("Add a burr"));
  adding->addWidget(catalogue_, 1);
  adding->addWidget(add_);
  column->addLayout(adding);
  column->addStretch();
  connect(add_, &QPushButton::clicked, this, [this] {
    const int index = catalogue_->currentData().toInt();
    if (catalogue_->count() > 0) model_.add_burr(round_burrs()[static_cast<std::size_t>(index)]);
  });
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
      line->addWidget(make_label(tr("Burr %1").arg(name)), 1);
      auto* diameter = new NumberBox(model_, tr("Diameter of burr %1").arg(name), u"mm"_qs, 0.1, 5, 0.1, 2,
                                     [this, i](double v) { return model_.set_burr_radius_mm(i, v / 2); });
      line->addWidget(diameter);
      QPushButton* away = make_button({}, ButtonKind::quiet, u"trash"_qs);
      away->setAccessibleName(tr("Remove burr %1").arg(name));
      away->setToolTip(tr("Remove burr %1").arg(name));
      away->setFixedWidth(px(32));
      line->addWidget(away);
      connect(away, &QPushButton::clicked, this, [this, i] { model_.remove_burr(i); });
      list_->addWidget(row);
      diameters_.push_back(diameter);
    }
  }
  for (std::size_t i = 0; i < burrs.size(); ++i) diameters_[i]->show_value(2 * burrs[i].radius_mm);
  const QSignalBlocker quiet(catalogue_);
  const QVariant kept = catalogue_->currentData();
  catalogue_->clear();
  const auto all = round_burrs();
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (std::ranges::find(names, all[i].name) != names.end()) continue;
    catalogue_->addItem(tr("Round %1, %2").arg(QString::fromStdString(all[i].name),
                                               format({2 * all[i].radius_mm, {}, QStringLiteral("mm"), 1})),
                        static_cast<int>(i));
  }
  catalogue_->setCurrentIndex(std::max(catalogue_->findData(kept), 0));
  add_->setEnabled(catalogue_->count() > 0);
}

}  // namespace cusp
