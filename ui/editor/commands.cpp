#include "ui/editor/commands.h"

namespace cusp::ui {

ScenarioEdit::ScenarioEdit(Scenario& held, Scenario after, const QString& text, QString field, int gesture,
                           std::function<void()> changed)
    : QUndoCommand(text),
      held_(held),
      before_(held),
      after_(std::move(after)),
      field_(std::move(field)),
      gesture_(gesture),
      changed_(std::move(changed)) {}

void ScenarioEdit::undo() {
  held_ = before_;
  changed_();
}

void ScenarioEdit::redo() {
  held_ = after_;
  changed_();
}

bool ScenarioEdit::mergeWith(const QUndoCommand* next) {
  const auto* edit = static_cast<const ScenarioEdit*>(next);  // the stack compares id() first
  if (edit->field_ != field_ || edit->gesture_ != gesture_) return false;
  after_ = edit->after_;
  setObsolete(before_ == after_);  // the value of before again: no step
  return true;
}

}  // namespace cusp::ui
