#include "ui/editor/template_dialog.h"

#include <QBoxLayout>
#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalBlocker>
#include <algorithm>
#include <cmath>

#include "ui/editor/specimen_form.h"
#include "ui/editor/template_messages.h"
#include "ui/text/names.h"
#include "ui/widgets/format.h"
#include "ui/widgets/number_field.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"

namespace cusp::ui {
namespace {

constexpr int kFirstTooth = 36;
constexpr int kFitRestMs = 200;         // fitting takes some 50 ms: a field that is being turned fits once, at its end
constexpr double kShownRounding = 0.005;  // the fields show two decimals
constexpr int kDialogWidth = 760;     // px at 100 %, as the next two
constexpr int kLeastRowsHeight = 96;  // of the parameters: two rows, the others scroll
constexpr int kOtherHeight = 272;     // of all that stands above and below the parameters

}  // namespace

QWidget* TemplateDialog::Row::field() const { return number ? static_cast<QWidget*>(number) : choice; }

double TemplateDialog::Row::value() const {
  if (choice) return choice->isChecked() ? 1 : 0;
  return number->hasAcceptableInput() ? number->valueFromText(number->text()) : number->value();
}

void TemplateDialog::Row::show(double value) {
  if (number) return number->show_value(value);
  const QSignalBlocker quiet(choice);
  choice->setChecked(value > 0.5);
}

bool TemplateDialog::Row::at_default() const { return std::abs(value() - usual) <= kShownRounding; }

TemplateDialog::TemplateDialog(const std::string& key, QWidget* parent) : QDialog(parent), id_(ScenarioId::make()) {
  setAttribute(Qt::WA_DeleteOnClose);
  setWindowTitle(tr("New exercise from a template"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(px(24), px(24), px(24), px(24));
  column->setSpacing(px(12));
  make_choices();
  if (const auto first = std::ranges::find(exercise_templates(), key, &ExerciseTemplate::key); first != exercise_templates().end())
    template_->setCurrentIndex(static_cast<int>(first - exercise_templates().begin()));
  column->addWidget(make_rule());
  scroll_ = new QScrollArea;
  scroll_->setWidgetResizable(true);
  scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll_->setFocusPolicy(Qt::NoFocus);
  column->addWidget(scroll_, 1);
  make_foot();
  fit_soon_.setSingleShot(true);
  fit_soon_.setInterval(kFitRestMs);
  connect(&fit_soon_, &QTimer::timeout, this, &TemplateDialog::fit);
  connect(template_, &QComboBox::currentIndexChanged, this, &TemplateDialog::show_template);
  connect(tooth_, &QComboBox::currentIndexChanged, this, [this] {
    show_defaults();
    fit();
  });
  show_template();
}

TemplateDialog::~TemplateDialog() {
  // A field that has the focus reports its value once more when it goes: no row may be read then.
  rows_.clear();
  delete scroll_->takeWidget();
}

void TemplateDialog::make_choices() {
  template_ = new QComboBox;
  for (const ExerciseTemplate& one : exercise_templates()) template_->addItem(local(one.name));
  tooth_ = new QComboBox;
  for (const int quadrant : {1, 2, 3, 4})
    for (int place = 4; place <= 8; ++place) {  // premolars and molars
      SpecimenSource tooth;
      tooth.generator = "tooth";
      tooth.fdi = 10 * quadrant + place;
      tooth_->addItem(specimen_name(tooth), tooth.fdi);
    }
  tooth_->setCurrentIndex(tooth_->findData(kFirstTooth));
  auto* row = new QHBoxLayout;
  row->setSpacing(px(16));
  row->addWidget(labelled(tr("Template"), template_), 1);
  row->addWidget(labelled(tr("Tooth"), tooth_), 1);
  auto* column = static_cast<QVBoxLayout*>(layout());
  column->addLayout(row);
  about_ = make_label({}, TextRole::body, Weight::regular, "text2");
  about_->setWordWrap(true);
  column->addWidget(about_);
}

void TemplateDialog::make_foot() {
  auto* column = static_cast<QVBoxLayout*>(layout());
  band_ = new Band;
  column->addWidget(band_);
  auto* row = new QHBoxLayout;
  row->addStretch();
  cancel_ = make_button(tr("Cancel"));
  make_ = make_button(tr("Make the exercise"), ButtonKind::primary);
  make_->setDefault(true);
  cancel_->setAutoDefault(false);
  row->addWidget(cancel_);
  row->addWidget(make_);
  column->addLayout(row);
  connect(cancel_, &QPushButton::clicked, this, &QDialog::reject);
  connect(make_, &QPushButton::clicked, this, &TemplateDialog::accept);
}

const ExerciseTemplate& TemplateDialog::chosen() const {
  return exercise_templates()[static_cast<std::size_t>(template_->currentIndex())];
}

void TemplateDialog::show_template() {
  about_->setText(local(chosen().about));
  rows_.clear();
  auto* body = new QWidget;
  auto* form = new QFormLayout(body);
  form->setContentsMargins(0, 0, px(12), 0);
  form->setHorizontalSpacing(px(16));
  form->setVerticalSpacing(px(8));
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  form->setFormAlignment(Qt::AlignLeading | Qt::AlignTop);
  for (const TemplateParameter& one : chosen().parameters) add_row(*form, one);
  scroll_->setWidget(body);  // deletes the one before
  order_fields();
  show_defaults();
  fit_height();
  fit();
}

void TemplateDialog::add_row(QFormLayout& form, const TemplateParameter& parameter) {
  Row row;
  row.parameter = parameter;
  const QString name = local(parameter.name);
  auto* label = make_label(name);
  label->setWordWrap(true);
  label->setFixedWidth(px(224));
  QWidget* field = make_field(row);
  field->setAccessibleName(name);
  label->setBuddy(field);
  row.note = make_label({}, TextRole::caption, Weight::regular, "text2");
  row.note->setWordWrap(true);
  auto* right = new QHBoxLayout;
  right->setSpacing(px(16));
  right->addWidget(field, 0, Qt::AlignVCenter);
  right->addWidget(row.note, 1);
  form.addRow(label, right);
  if (row.number) form.addRow(row.number->note());
  rows_.push_back(std::move(row));
}

QWidget* TemplateDialog::make_field(Row& row) {
  constexpr int kFieldWidth = 112;
  const TemplateParameter& p = row.parameter;
  if (is_choice(p)) {
    row.choice = new QCheckBox;
    row.choice->setFixedWidth(px(kFieldWidth));
    connect(row.choice, &QCheckBox::toggled, this, &TemplateDialog::take_edit);
    return row.choice;
  }
  row.number = new NumberField;
  row.number->setDecimals(2);
  row.number->setRange(p.least, p.most);
  row.number->setSingleStep(p.unit == "deg" ? 1 : 0.05);
  row.number->setAlignment(Qt::AlignRight);
  row.number->setFixedWidth(px(kFieldWidth));
  if (!p.unit.empty()) row.number->setSuffix(QChar(0x00A0) + unit_text(QString::fromStdString(p.unit)));
  // NumberField reports a value when it is left; the button must follow each key.
  connect(row.number->findChild<QLineEdit*>(), &QLineEdit::textChanged, this, &TemplateDialog::take_edit);
  connect(row.number, &NumberField::editingFinished, this, &TemplateDialog::take_edit);
  return row.number;
}

void TemplateDialog::show_defaults() {
  const auto defaults = template_defaults(chosen().key, tooth_->currentData().toInt());
  if (!defaults) return;  // fit() says why
  for (Row& row : rows_) {
    const bool follows = row.note->text().isEmpty() || row.at_default();  // a value set by hand stays
    row.usual = defaults->at(row.parameter.key);
    row.note->setText(parameter_note(row.parameter, row.usual));
    row.field()->setAccessibleDescription(row.note->text());
    if (follows) row.show(row.usual);
  }
}

void TemplateDialog::take_edit() {
  fit_soon_.start();
  if (!refusal().isEmpty()) fit();  // at once: the button must not make an exercise of the value before
}

QString TemplateDialog::refusal() const {
  for (const Row& row : rows_) {
    if (!row.number || row.number->hasAcceptableInput()) continue;
    return outside_message(row.parameter, row.number->cleanText().trimmed());
  }
  return {};
}

FitRequest TemplateDialog::request() const {
  FitRequest out{.key = chosen().key, .fdi = tooth_->currentData().toInt(), .id = id_};
  for (const Row& row : rows_)
    if (!row.at_default()) out.values[row.parameter.key] = row.value();
  return out;
}

void TemplateDialog::fit() {
  fit_soon_.stop();
  exercise_.reset();
  if (const QString refused = refusal(); !refused.isEmpty()) return show_standing(Fits::no, refused);
  auto fitted = fit_template(request());
  if (!fitted) return show_standing(Fits::no, fit_message(chosen(), fitted.error()));
  exercise_ = std::move(*fitted);
  show_standing(Fits::yes, tr("These values make an exercise on tooth %1.").arg(tooth_->currentData().toInt()));
}

void TemplateDialog::show_standing(Fits fits, const QString& text) {
  make_->setEnabled(fits == Fits::yes);
  if (band_->text() != text) band_->show_message(fits == Fits::yes ? Band::Kind::good : Band::Kind::look, text);
}

void TemplateDialog::accept() {
  fit();
  if (!exercise_) return;
  const Scenario exercise = *exercise_;
  QDialog::accept();
  Q_EMIT made(exercise);  // last: whoever takes it may close the page below
}

/// Tab follows reading: the rows are younger than the buttons below them.
void TemplateDialog::order_fields() {
  QWidget* before = tooth_;
  for (const Row& row : rows_) {
    setTabOrder(before, row.field());
    before = row.field();
  }
  setTabOrder(before, cancel_);
  setTabOrder(cancel_, make_);
}

void TemplateDialog::showEvent(QShowEvent* event) {
  QDialog::showEvent(event);
  fit_height();  // the theme's fonts are known only now
}

void TemplateDialog::fit_height() {
  const QSize room = most_of_screen(*this);
  const int width = std::min(px(kDialogWidth), room.width());
  setFixedWidth(width);
  // Names of two lines make rows taller than the size hint says.
  const int wanted = scroll_->widget()->layout()->totalHeightForWidth(width - 2 * px(24));
  scroll_->widget()->setMinimumHeight(wanted);  // else the rows give up the last line of their notes
  scroll_->setMinimumHeight(std::min(wanted, std::max(px(kLeastRowsHeight), room.height() - px(kOtherHeight))));
  adjustSize();
}

}  // namespace cusp::ui
