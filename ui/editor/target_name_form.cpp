#include "ui/editor/target_name_form.h"

#include <QBoxLayout>
#include <QLineEdit>
#include <string>

#include "scenarios/format/ranges.h"
#include "ui/editor/target_names.h"
#include "ui/text/grade_text.h"
#include "ui/text/language.h"
#include "ui/widgets/parts.h"

namespace cusp::ui {
namespace {

/// The window's language; English where it is none that an exercise can have.
std::string language_of_names() {
  for (const Language& one : languages())
    if (one.code == current_language()) return one.code.toStdString();
  return "en";
}

}  // namespace

TargetNameForm::TargetNameForm(EditorModel& model, QWidget* parent) : QWidget(parent), model_(model), name_(new QLineEdit) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, px(4), 0, 0);
  name_->setMaxLength(static_cast<int>(kMostTextCharacters));
  name_->setPlaceholderText(tr("graded with the whole target"));
  name_->setToolTip(tr("A shape with a name is a target of its own: criteria can ask for its depth, walls and over-cut alone."));
  column->addWidget(labelled(tr("Name as a target of its own"), name_));
  connect(name_, &QLineEdit::editingFinished, this, &TargetNameForm::take);
  connect(&model_, &EditorModel::changed, this, [this] {
    if (!name_->hasFocus() || !name_->isModified()) follow_model();  // a tooth that has grown leaves a half-typed name
  });
  connect(&model_, &EditorModel::part_chosen, this, &TargetNameForm::follow_model);
  follow_model();
}

void TargetNameForm::take() {
  if (!name_->isModified() || !can_be_target(model_.scenario().target, model_.part())) return;
  name_->setModified(false);
  const std::size_t part = model_.part().front();
  const QString name = name_->text().trimmed();
  model_.end_gesture();
  if (name.isEmpty()) model_.clear_target(part);
  else model_.set_target_title(part, language_of_names(), name);
  model_.end_gesture();
  follow_model();
}

void TargetNameForm::follow_model() {
  const Region& whole = model_.scenario().target;
  const bool can = can_be_target(whole, model_.part());
  setVisible(can);
  if (!can) return name_->clear();
  const Region& part = model_.chosen();
  const auto own = part.title.find(language_of_names());
  name_->setText(own != part.title.end() ? QString::fromStdString(own->second) : part.name.empty() ? QString() : target_title(part.name, &whole));
  name_->setModified(false);
}

}  // namespace cusp::ui
