#include "ui/instructor/assignment_form.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDateTimeEdit>
#include <QFormLayout>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QLocale>
#include <QPushButton>
#include <QRandomGenerator>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QVBoxLayout>
#include <algorithm>

#include "device/catalogue.h"
#include "scenarios/format/content_hash.h"
#include "scenarios/templates/other_tooth.h"
#include "ui/text/names.h"
#include "ui/widgets/format.h"
#include "ui/widgets/theme.h"

namespace cusp::ui {
namespace {

constexpr int kBetween = 4;          // px at 100 %
constexpr int kUsualDays = 14;       // until an assignment is due
constexpr int kMostAttempts = 99;
constexpr int kCodeDigits = 6;
constexpr int kUsualSelfTestDays = 7;

}  // namespace

AssignmentForm::AssignmentForm(std::vector<Exercise> exercises, const QDateTime& now, QWidget* parent)
    : Card(tr("Assign an exercise"), {}, parent) {
  setFixedWidth(px(300));
  QFormLayout* form = make_form();
  body()->addLayout(form);
  exercise_ = new QComboBox;
  exercise_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  fill_exercises(std::move(exercises));
  exercise_->setPlaceholderText(tr("Choose an exercise"));
  add_field(*form, tr("Exercise"), exercise_);
  kind_ = new Segments({tr("Practice"), tr("Assessment")});
  add_field(*form, tr("Kind"), kind_, kBetween);
  const QDateTime day(now.date(), QTime(8, 0));
  opens_ = add_moment(*form, tr("Open from"), day);
  due_ = add_moment(*form, tr("Due"), QDateTime(now.date().addDays(kUsualDays), QTime(18, 0)));
  due_.on->setChecked(true);
  attempts_ = new QSpinBox;
  attempts_->setRange(0, kMostAttempts);
  attempts_->setSpecialValueText(tr("any number"));
  add_field(*form, tr("Attempts"), attempts_, kBetween);
  body()->addWidget(make_devices());
  self_test_row_ = make_self_test();
  body()->addWidget(self_test_row_);
  teeth_row_ = make_teeth();
  body()->addWidget(teeth_row_);
  code_ = new QLineEdit;
  code_->setMaxLength(static_cast<int>(kMostStartCode));
  code_->setToolTip(tr("The invigilator says it when the assessment begins"));
  code_row_ = labelled(tr("Start code"), code_);
  body()->addWidget(code_row_);
  connect(kind_, &Segments::changed, this, [this] { choose_kind(kind_->chosen() == 1 ? SessionKind::assessment : SessionKind::practice); });
  connect(exercise_, &QComboBox::currentIndexChanged, this, &AssignmentForm::offer_teeth);
  draw_start_code();
  choose_kind(SessionKind::practice);
  body()->addSpacing(px(8));
  act_ = make_button(tr("Assign"), ButtonKind::primary);
  body()->addWidget(act_);
  connect(act_, &QPushButton::clicked, this, &AssignmentForm::assign_wanted);
  watch_fields();
}

void AssignmentForm::watch_fields() {
  connect(exercise_, &QComboBox::currentIndexChanged, this, &AssignmentForm::note_change);
  connect(kind_, &Segments::changed, this, &AssignmentForm::note_change);
  for (const Moment& moment : {opens_, due_}) {
    connect(moment.on, &QCheckBox::toggled, this, &AssignmentForm::note_change);
    connect(moment.when, &QDateTimeEdit::dateTimeChanged, this, &AssignmentForm::note_change);
  }
  for (QSpinBox* number : {attempts_, self_test_days_}) connect(number, &QSpinBox::valueChanged, this, &AssignmentForm::note_change);
  for (QCheckBox* check : {self_test_, drawn_tooth_}) connect(check, &QCheckBox::toggled, this, &AssignmentForm::note_change);
  for (const auto& one : devices_) connect(one.second, &QCheckBox::toggled, this, &AssignmentForm::note_change);
  connect(code_, &QLineEdit::textChanged, this, &AssignmentForm::note_change);
}

void AssignmentForm::note_change() {
  changed_ = true;
  enable_act();
}

void AssignmentForm::enable_act() { act_->setEnabled(true); }

void AssignmentForm::disable_act() {
  if (act_->hasFocus()) exercise_->setFocus();  // a disabled button hands the focus on
  act_->setEnabled(false);
  changed_ = false;
}

AssignmentForm::Moment AssignmentForm::add_moment(QFormLayout& form, const QString& label, const QDateTime& usual) {
  Moment out;
  out.on = new QCheckBox(label);
  out.when = new QDateTimeEdit(usual);
  out.when->setLocale(QLocale());  // the language may be another than when the window was made
  out.when->setCalendarPopup(true);
  out.when->setDisplayFormat(date_pattern() + QStringLiteral(", HH:mm"));
  out.when->setAccessibleName(label);
  out.when->setEnabled(false);
  connect(out.on, &QCheckBox::toggled, out.when, &QWidget::setEnabled);
  auto* gap = new QVBoxLayout;
  gap->setContentsMargins(0, px(kBetween), 0, 0);
  gap->addWidget(out.on);
  form.addRow(gap);
  form.addRow(out.when);
  return out;
}

/// One check box for each device that a student can choose.
QWidget* AssignmentForm::make_devices() {
  auto* box = new QWidget;
  box->setToolTip(tr("An attempt with another device does not count for the assignment"));
  auto* grid = new QGridLayout(box);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(px(8));
  grid->setVerticalSpacing(px(4));
  grid->addWidget(make_label(tr("Devices admitted"), TextRole::caption), 0, 0, 1, 2);
  for (const DeviceKind& kind : device::device_kinds()) {
    if (!kind.offered) continue;
    const std::string device_class(kind.device_class);
    auto* check = new QCheckBox(device_name(device_class));
    check->setChecked(true);
    check->setAccessibleDescription(tr("Devices admitted"));
    const int at = static_cast<int>(devices_.size());
    grid->addWidget(check, 1 + at / 2, at % 2);
    devices_.emplace_back(device_class, check);
  }
  return box;
}

/// Whether an assessment asks for a self-test of the device, and how old it may be.
QWidget* AssignmentForm::make_self_test() {
  auto* box = new QWidget;
  auto* column = new QVBoxLayout(box);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(px(4));
  self_test_ = new QCheckBox(tr("Self-test of the device, at most"));
  self_test_->setToolTip(tr("Staff test a Falcon on the page Device. Devices without a self-test then do not start it."));
  self_test_days_ = new QSpinBox;
  self_test_days_->setRange(1, kMostSelfTestDays);
  self_test_days_->setValue(kUsualSelfTestDays);
  const auto name_days = [this](int days) { self_test_days_->setSuffix(u' ' + tr("day(s) old", nullptr, days)); };
  name_days(kUsualSelfTestDays);
  connect(self_test_days_, &QSpinBox::valueChanged, this, name_days);
  self_test_days_->setAccessibleName(tr("Days since the self-test"));
  self_test_days_->setEnabled(false);
  connect(self_test_, &QCheckBox::toggled, self_test_days_, &QWidget::setEnabled);
  column->addWidget(self_test_);
  column->addWidget(self_test_days_);
  return box;
}

/// Whether each candidate of an assessment has a tooth of his own.
QWidget* AssignmentForm::make_teeth() {
  auto* box = new QWidget;
  auto* column = new QVBoxLayout(box);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(px(4));
  drawn_tooth_ = new QCheckBox(tr("Another tooth for each candidate"));
  drawn_tooth_->setToolTip(tr("Of the same number, with its target fitted to it. The session keeps which tooth it was."));
  remark_ = make_label({}, TextRole::caption, Weight::regular, "text2");
  remark_->setWordWrap(true);
  column->addWidget(drawn_tooth_);
  column->addWidget(remark_);
  return box;
}

void AssignmentForm::offer_teeth() {
  if (kind_->chosen() != 1) return;
  if (!has_exercise()) return remark_->hide();
  const Exercise& exercise = chosen_exercise();
  const auto bound = bound_to_its_tooth(exercise.scenario);
  drawn_tooth_->setEnabled(!bound);
  QString remark;
  if (!bound) {
    if (keeps_its_texts(exercise.scenario)) remark = tr("Its title or briefing was edited: figures in them stay those of the exercise’s own tooth.");
  } else if (bound->code == OtherToothError::by_hand) {
    remark = tr("All have the exercise’s own tooth: no template made this exercise.");
  } else if (bound->code == OtherToothError::edited) {
    remark = tr("All have the exercise’s own tooth: its target was edited after the template made it.");
  } else {
    remark = tr("All have the exercise’s own tooth: its template fits no other.");
  }
  remark_->setText(remark);
  remark_->setVisible(!remark.isEmpty());
}

void AssignmentForm::choose_drawn_tooth() { drawn_tooth_->setChecked(true); }

void AssignmentForm::choose_self_test(int days) {
  self_test_->setChecked(true);
  self_test_days_->setValue(days);
}

void AssignmentForm::choose_devices(const std::vector<std::string>& device_classes) {
  for (const auto& [device_class, check] : devices_) check->setChecked(storage::admits(device_classes, device_class));
}

void AssignmentForm::fill_exercises(std::vector<Exercise> exercises) {
  exercises_ = std::move(exercises);
  std::ranges::sort(exercises_, stands_before, [](const Exercise& exercise) { return local(exercise.scenario.title).toStdString(); });
  exercise_->clear();
  for (const Exercise& exercise : exercises_) exercise_->addItem(local(exercise.scenario.title));
}

void AssignmentForm::set_exercises(std::vector<Exercise> exercises) {
  const std::optional<Exercise> before = has_exercise() ? std::optional(chosen_exercise()) : std::nullopt;
  {
    const QSignalBlocker quiet(exercise_);
    fill_exercises(std::move(exercises));
    exercise_->setCurrentIndex(-1);
    if (before) choose_exercise(before->scenario.id);
  }
  offer_teeth();
  if (!before) return;
  const Exercise* now = find(before->scenario.id);
  if (now == nullptr || content_hash(now->scenario).bytes != content_hash(before->scenario).bytes) enable_act();
}

bool AssignmentForm::has_exercise() const { return exercise_->currentIndex() >= 0; }

const Exercise& AssignmentForm::chosen_exercise() const { return exercises_[static_cast<std::size_t>(exercise_->currentIndex())]; }

const Exercise* AssignmentForm::find(const ScenarioId& id) const {
  const auto it = std::ranges::find_if(exercises_, [&](const Exercise& e) { return e.scenario.id == id; });
  return it == exercises_.end() ? nullptr : &*it;
}

void AssignmentForm::choose_exercise(const ScenarioId& id) {
  if (const Exercise* there = find(id)) exercise_->setCurrentIndex(static_cast<int>(there - exercises_.data()));
}

void AssignmentForm::choose_due(const QDateTime& due) {
  due_.on->setChecked(true);
  due_.when->setDateTime(due);
}

void AssignmentForm::choose_kind(SessionKind kind) {
  const bool assessment = kind == SessionKind::assessment;
  kind_->choose(assessment ? 1 : 0);
  code_row_->setVisible(assessment);
  self_test_row_->setVisible(assessment);
  teeth_row_->setVisible(assessment);
  offer_teeth();
  // A single attempt is usual in an assessment, any number in practice.
  attempts_->setValue(assessment ? 1 : 0);
}

void AssignmentForm::draw_start_code() {
  QString code;
  for (int i = 0; i < kCodeDigits; ++i) code += QString::number(QRandomGenerator::system()->bounded(10));
  code_->setText(code);
}

AssignmentForm::Wish AssignmentForm::wish() const {
  Wish out;
  out.exercise = chosen_exercise();
  if (opens_.on->isChecked()) out.opens = opens_.when->dateTime();
  if (due_.on->isChecked()) out.due = due_.when->dateTime();
  if (attempts_->value() > 0) out.attempts = attempts_->value();
  for (const auto& [device_class, check] : devices_) {
    if (check->isChecked()) out.device_classes.push_back(device_class);
  }
  out.admits_none = out.device_classes.empty();
  // A device of a later version is then admitted too.
  if (out.device_classes.size() == devices_.size()) out.device_classes.clear();
  if (kind_->chosen() != 1) return out;
  out.kind = SessionKind::assessment;
  out.start_code = code_->text().trimmed();
  if (self_test_->isChecked()) out.self_test_days = self_test_days_->value();
  out.drawn_tooth = drawn_tooth_->isEnabled() && drawn_tooth_->isChecked();
  return out;
}

}  // namespace cusp::ui
