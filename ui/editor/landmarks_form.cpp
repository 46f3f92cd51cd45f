#include "ui/editor/landmarks_form.h"

#include <QBoxLayout>
#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTreeWidget>
#include <algorithm>

#include "scenarios/format/ranges.h"
#include "ui/editor/form_parts.h"
#include "ui/editor/landmark_job.h"
#include "ui/editor/landmark_names.h"
#include "ui/editor/specimen_form.h"
#include "ui/modules.h"
#include "ui/widgets/busy.h"
#include "ui/widgets/icon.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"

namespace cusp::ui {
namespace {

constexpr int kFirstTooth = 36;
constexpr int kRowsShown = 8;
constexpr int kNameColumn = 0, kStateColumn = 1;
constexpr int kSignPx = 14;  // of a state's icon, at 100 %
constexpr int kBusyPx = 200;  // of the progress, which the panel's width limits, at 100 %
constexpr double kStepMm = 0.05;

}  // namespace

LandmarksForm::LandmarksForm(EditorModel& model, QWidget* parent) : QWidget(parent), model_(model), job_(new LandmarkJob(this)) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(px(6));
  make_proposing(*column);
  marked_ = new QWidget;
  auto* inside = new QVBoxLayout(marked_);
  inside->setContentsMargins(0, 0, 0, 0);
  inside->setSpacing(px(6));
  make_list(*inside);
  make_buttons(*inside);
  make_numbers(*inside);
  column->addWidget(marked_);
  follow_job();
  connect(&model_, &EditorModel::changed, this, &LandmarksForm::follow_model);
  connect(&model_, &EditorModel::landmark_chosen, this, &LandmarksForm::follow_model);
  connect(&model_, &EditorModel::specimen_changed, this, [this] {
    stop();
    band_->clear();
  });
  follow_model();
}

void LandmarksForm::make_proposing(QVBoxLayout& column) {
  add_section(&column, tr("Landmarks"));
  tooth_ = new QComboBox;
  add_teeth(*tooth_);
  tooth_->setCurrentIndex(tooth_->findData(kFirstTooth));
  column.addWidget(labelled(tr("Number of the tooth"), tooth_));
  propose_ = make_button(tr("Propose landmarks"), ButtonKind::standard, u"search"_qs);
  propose_->setToolTip(tr("By the average tooth of that number. Landmarks that are set stay while the number does."));
  column.addWidget(propose_, 0, Qt::AlignLeft);
  busy_place_ = new QVBoxLayout;
  column.addLayout(busy_place_);
  band_ = new Band;
  column.addWidget(band_);
  connect(propose_, &QPushButton::clicked, this, &LandmarksForm::propose);
}

void LandmarksForm::make_list(QVBoxLayout& column) {
  counts_ = make_label({}, TextRole::caption, Weight::regular, "text2");
  column.addWidget(counts_);
  list_ = new QTreeWidget;
  list_->setAccessibleName(tr("Landmarks"));
  list_->setColumnCount(2);
  list_->setHeaderHidden(true);
  list_->header()->setStretchLastSection(false);
  list_->header()->setSectionResizeMode(kNameColumn, QHeaderView::Stretch);
  list_->header()->setSectionResizeMode(kStateColumn, QHeaderView::ResizeToContents);
  list_->setIconSize(QSize(px(kSignPx), px(kSignPx)));
  list_->setTextElideMode(Qt::ElideMiddle);  // the end names which one
  list_->setIndentation(0);
  list_->setRootIsDecorated(false);
  list_->setItemsExpandable(false);
  list_->setUniformRowHeights(true);
  column.addWidget(list_);
  connect(list_, &QTreeWidget::currentItemChanged, this, [this](QTreeWidgetItem* item) {
    if (item != nullptr) model_.choose_landmark({static_cast<std::size_t>(list_->indexOfTopLevelItem(item)), 0});
  });
}

void LandmarksForm::make_buttons(QVBoxLayout& column) {
  accept_ = make_button(tr("Accept"), ButtonKind::standard, u"check"_qs);
  accept_->setToolTip(tr("The chosen landmark is set where it lies"));
  accept_all_ = make_button(tr("Accept all"), ButtonKind::standard);
  remove_ = make_button({}, ButtonKind::standard, u"trash"_qs);
  remove_->setAccessibleName(tr("Remove the landmark"));
  remove_->setToolTip(tr("Remove the landmark"));
  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(px(6));
  buttons->addWidget(accept_);
  buttons->addStretch();
  buttons->addWidget(remove_);
  column.addLayout(buttons);
  column.addWidget(accept_all_, 0, Qt::AlignLeft);
  connect(accept_, &QPushButton::clicked, this, [this] { model_.accept_landmark(model_.landmark().mark); });
  connect(accept_all_, &QPushButton::clicked, this, [this] { model_.accept_landmarks(); });
  connect(remove_, &QPushButton::clicked, this, [this] { model_.remove_landmark(model_.landmark().mark); });
}

void LandmarksForm::make_numbers(QVBoxLayout& column) {
  point_ = new QComboBox;
  point_->setAccessibleName(tr("Point of the landmark"));
  column.addWidget(point_);
  connect(point_, &QComboBox::activated, this,
          [this](int index) { model_.choose_landmark({model_.landmark().mark, static_cast<std::size_t>(index)}); });
  const std::array names = {tr("Along the arch"), tr("Towards buccal"), tr("Height")};
  const NumberRange& mm = *range_of("/specimen/landmarks/marks/0/points_mm/0/0");
  for (int axis = 0; axis < 3; ++axis) {
    const auto at = static_cast<std::size_t>(axis);
    numbers_[at] = new NumberBox(model_, tr("Landmark: %1").arg(names[at]), u"mm"_qs, mm.least, mm.most, kStepMm, 2, [this, axis](double value) {
      const MarkPoint chosen = model_.landmark();
      if (model_.landmarks().marks.empty()) return false;
      Vec3 to = model_.landmarks().marks[chosen.mark].points_mm[chosen.point];
      to[axis] = value;
      return model_.move_landmark(chosen, to);
    });
    add_row(&column, names[at], numbers_[at]);
  }
}

void LandmarksForm::follow_job() {
  connect(job_, &LandmarkJob::proposed, this, &LandmarksForm::take);
  connect(job_, &LandmarkJob::unreadable, this, [this](const ImportFailure& failure) { show_failure(describe(failure)); });
  connect(job_, &LandmarkJob::failed, this, [this](ProposeError error) { show_failure(describe(error)); });
}

void LandmarksForm::propose() {
  stop();
  band_->clear();
  busy_ = new Busy;
  busy_->setMinimumWidth(px(kBusyPx));
  busy_place_->addWidget(busy_);
  busy_->start(tr("Looking for landmarks"), Busy::Cancel::offered);
  connect(busy_, &Busy::cancelled, this, &LandmarksForm::stop);
  job_->start(model_.scenario().specimen, model_.folder(), tooth_->currentData().toInt());
  follow_model();
}

void LandmarksForm::stop() {
  job_->cancel();
  if (busy_ != nullptr) {
    busy_->hide();
    busy_->deleteLater();
    busy_ = nullptr;
  }
  follow_model();
}

void LandmarksForm::take(const SpecimenLandmarks& proposed) {
  stop();
  const Message lack = describe_lack(proposed);
  if (proposed.marks.empty()) return show_failure(lack);
  if (!model_.take_proposed(proposed)) return show_failure({tr("The landmarks cannot be taken."), tr("Nothing was changed.")});
  if (!lack.what.isEmpty()) band_->show_message(Band::Kind::look, lack.what, lack.more);
  announce(this, counts_->text());
}

void LandmarksForm::show_failure(const Message& message) {
  stop();
  band_->show_message(Band::Kind::look, message.what, message.more);
}

void LandmarksForm::follow_model() {
  const SpecimenLandmarks& landmarks = model_.landmarks();
  propose_->setEnabled(model_.takes_landmarks() && !job_->running());
  marked_->setVisible(!landmarks.marks.empty());
  // The file that an exercise moves to is mostly of the tooth that it was on.
  const int fdi = landmarks.fdi != 0 ? landmarks.fdi : model_.scenario().specimen.grown_fdi();
  if (fdi != 0 && fdi != shown_fdi_) {
    shown_fdi_ = fdi;
    tooth_->setCurrentIndex(tooth_->findData(shown_fdi_));
  }
  if (landmarks.marks.empty()) return;
  const auto proposed = std::ranges::count(landmarks.marks, MarkState::proposed, &Landmark::state);
  const auto set = static_cast<qsizetype>(landmarks.marks.size()) - proposed;
  //: %1, %2: numbers of landmarks
  counts_->setText(tr("%1 proposed, %2 set").arg(QLocale().toString(proposed), QLocale().toString(set)));
  accept_all_->setEnabled(proposed > 0);
  show_list();
  show_chosen();
}

void LandmarksForm::show_list() {
  const auto& marks = model_.landmarks().marks;
  const auto rows = static_cast<int>(marks.size());
  const QSignalBlocker quiet(list_);
  while (list_->topLevelItemCount() > rows) delete list_->takeTopLevelItem(rows);
  while (list_->topLevelItemCount() < rows) new QTreeWidgetItem(list_);
  for (int row = 0; row < rows; ++row) {
    const Landmark& mark = marks[static_cast<std::size_t>(row)];
    QTreeWidgetItem* item = list_->topLevelItem(row);
    item->setText(kNameColumn, landmark_name(mark));
    item->setToolTip(kNameColumn, landmark_name(mark));
    item->setData(kStateColumn, Qt::AccessibleTextRole, mark_state_name(mark.state));  // the sign leaves room for names
    item->setToolTip(kStateColumn, mark_state_name(mark.state));
    item->setIcon(kStateColumn, icon(mark_state_icon(mark.state), Ink::text2));
  }
  list_->setCurrentItem(list_->topLevelItem(static_cast<int>(model_.landmark().mark)));
  list_->setFixedHeight(std::min(rows, kRowsShown) * px(26) + px(8));
  list_->scrollToItem(list_->currentItem());
}

void LandmarksForm::show_chosen() {
  const MarkPoint chosen = model_.landmark();
  const Landmark& mark = model_.landmarks().marks[chosen.mark];
  accept_->setEnabled(mark.state == MarkState::proposed);
  const QSignalBlocker quiet(point_);
  const std::size_t points = movable_points(mark);
  point_->clear();
  for (std::size_t i = 0; i < points; ++i) point_->addItem(landmark_point_name(mark, i));
  point_->setCurrentIndex(static_cast<int>(chosen.point));
  point_->setVisible(points > 1);
  for (std::size_t axis = 0; axis < numbers_.size(); ++axis)
    numbers_[axis]->show_value(mark.points_mm[chosen.point][static_cast<int>(axis)]);
}

}  // namespace cusp::ui
