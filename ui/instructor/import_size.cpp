#include "ui/instructor/import_size.h"

#include <QBoxLayout>
#include <QComboBox>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <algorithm>
#include <utility>

#include "scenarios/format/ranges.h"
#include "scenarios/import/import.h"
#include "scenarios/import/size_question.h"
#include "ui/modules.h"
#include "ui/text/import_text.h"
#include "ui/widgets/format.h"
#include "ui/widgets/number_field.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"

namespace cusp::ui {
namespace {

constexpr double kDefaultVoxelMm = 0.1;

struct Millimetres {
  double least, most, value;
  int decimals;
};

NumberField* millimetre_box(const Millimetres& mm) {
  auto* box = new NumberField;
  box->setLocale(QLocale());
  box->setDecimals(mm.decimals);
  box->setRange(mm.least, mm.most);
  box->setValue(mm.value);
  box->setSingleStep(mm.value / 10);
  box->setSuffix(QChar(0x00A0) + QStringLiteral("mm"));
  box->setFixedWidth(px(140));
  return box;
}

QString millimetres(double mm) {
  return format_value({.value = mm, .unit = QStringLiteral("mm"), .decimals = 1});
}

}  // namespace

ImportSize::ImportSize(QWidget* parent) : QWidget(parent) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(px(12));
  auto* numbers = new QHBoxLayout;
  numbers->setSpacing(px(16));
  unit_ = new QComboBox;
  const QStringList names = {tr("Millimetre"), tr("Centimetre"), tr("Metre"), tr("Inch"), tr("Micrometre")};
  for (std::size_t i = 0; i < kUsualUnitsMm.size(); ++i) unit_->addItem(names[static_cast<qsizetype>(i)], kUsualUnitsMm[i]);
  unit_->addItem(tr("Another"), 0.0);
  other_unit_ = millimetre_box({.least = 0.0001, .most = 1000, .value = 1, .decimals = 4});
  const NumberRange& fineness = *range_of("/specimen/voxel_mm");  // of another an exercise can hold no specimen
  voxel_ = millimetre_box({.least = fineness.least, .most = fineness.most, .value = kDefaultVoxelMm, .decimals = 3});
  up_ = new QComboBox;
  for (const std::string_view key : kUpAxisKeys) up_->addItem(QString::fromLatin1(key.data(), static_cast<int>(key.size())));
  up_->setMinimumWidth(px(80));
  unit_field_ = labelled(tr("One unit of the file is"), unit_);
  other_field_ = labelled(tr("Its length"), other_unit_);
  for (QWidget* field : {unit_field_, other_field_, labelled(tr("Fineness"), voxel_), labelled(tr("Axis of the file that points up"), up_)})
    numbers->addWidget(field);
  numbers->addStretch();
  column->addLayout(numbers);
  size_ = make_label({}, TextRole::body, Weight::bold);
  size_->setWordWrap(true);
  column->addWidget(size_);
  question_ = new QWidget;
  auto* row = new QVBoxLayout(question_);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(px(8));
  why_ = make_label({}, TextRole::body, Weight::regular, "look");
  why_->setWordWrap(true);
  row->addWidget(why_);
  answers_ = new QHBoxLayout;
  answers_->setSpacing(px(8));
  row->addLayout(answers_);
  column->addWidget(question_);
  question_->hide();
  const auto unit_changed = [this] {
    forget_answers();
    follow_unit();
    chosen_ = true;
    Q_EMIT changed();
  };
  connect(unit_, &QComboBox::currentIndexChanged, this, unit_changed);
  connect(other_unit_, &NumberField::valueChanged, this, unit_changed);
  connect(voxel_, &NumberField::valueChanged, this, [this](double mm) {
    if (file_voxel_) file_voxel_ = mm / unit_mm();
    Q_EMIT changed();
  });
  connect(up_, &QComboBox::currentIndexChanged, this, &ImportSize::changed);
}

void ImportSize::begin(const FileSize& file) {
  const QSignalBlocker quiet(this);
  unit_unknown_ = file.unit == FileSize::Unit::unknown;
  const bool was_volume = std::exchange(file_voxel_, std::nullopt).has_value();
  unit_->setCurrentIndex(std::max(0, unit_->findData(file.unit_mm)));
  forget_answers();
  if (!file.voxel_mm && was_volume) voxel_->setValue(kDefaultVoxelMm);
  file_voxel_ = file.voxel_mm;
  follow_unit();
  chosen_ = false;
}

void ImportSize::follow_unit() {
  if (!file_voxel_) return;
  const QSignalBlocker quiet(voxel_);  // a value cut to the field's range is not what was asked for
  voxel_->setValue(*file_voxel_ * unit_mm());
}

void ImportSize::set_changeable(bool on) {
  voxel_->setEnabled(on);
  up_->setEnabled(on);
}

double ImportSize::unit_mm() const {
  const double usual = unit_->currentData().toDouble();
  return scale_ * (!unit_unknown_ ? 1.0 : usual > 0.0 ? usual : other_unit_->value());
}

double ImportSize::voxel_mm() const { return voxel_->value(); }
UpAxis ImportSize::up() const { return static_cast<UpAxis>(up_->currentIndex()); }

void ImportSize::show_size(const QString& sentence, std::optional<double> longest_mm) {
  unit_field_->setVisible(unit_unknown_);
  other_field_->setVisible(unit_unknown_ && unit_->currentData().toDouble() == 0.0);
  size_->setText(sentence);
  const bool odd = longest_mm && !believed(*longest_mm) && !believed_;
  if (odd) ask(*longest_mm);
  questioned_ = odd;
  question_->setVisible(odd);
}

void ImportSize::ask(double longest_mm) {
  const QString text = odd_size_text(longest_mm) + u' ' + tr("Is the unit right?");
  if (questioned_ && why_->text() == text) return;
  while (QLayoutItem* item = answers_->takeAt(0)) {
    delete item->widget();
    delete item;
  }
  why_->setText(text);
  for (const double factor : size_factors(longest_mm)) {
    QPushButton* way = make_button(tr("× %1: %2").arg(isolate(QLocale().toString(factor, 'g', 3)), millimetres(factor * longest_mm)));
    answers_->addWidget(way);
    connect(way, &QPushButton::clicked, this, [this, factor] { answer(factor); }, Qt::QueuedConnection);
  }
  QPushButton* keep = make_button(tr("It is %1").arg(millimetres(longest_mm)), ButtonKind::quiet);
  answers_->addWidget(keep);
  connect(keep, &QPushButton::clicked, this, [this] { answer(1.0); }, Qt::QueuedConnection);
  answers_->addStretch();
  announce(this, text);
}

void ImportSize::forget_answers() {
  scale_ = 1.0;
  believed_ = false;
}

/// Called through a queued connection: it deletes the button that was clicked.
void ImportSize::answer(double factor) {
  chosen_ = true;
  if (factor == 1.0) {
    believed_ = true;
    return Q_EMIT confirmed();
  }
  scale_ *= factor;
  follow_unit();
  Q_EMIT changed();
}

}  // namespace cusp::ui
