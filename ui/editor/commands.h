/// One edit of an exercise as a step of undo; nothing else changes the exercise of an EditorModel. The command keeps the whole
/// exercise before and after, so that undo restores every field. Thread: GUI.
#pragma once

#include <QUndoCommand>
#include <functional>

#include "scenarios/format/scenario.h"
#include "ui/modules.h"

namespace cusp::ui {

class ScenarioEdit : public QUndoCommand {
 public:
  /// Edits with the same `field` and `gesture` (one drag of a handle, one turn of a spin box) merge into one step. The command
  /// calls `changed` after every undo and redo. `held` outlives the command.
  ScenarioEdit(Scenario& held, Scenario after, const QString& text, QString field, int gesture,
               std::function<void()> changed);
  void undo() override;
  void redo() override;
  int id() const override { return kId; }
  bool mergeWith(const QUndoCommand* next) override;

  const Scenario& before() const { return before_; }
  const QString& field() const { return field_; }
  int gesture() const { return gesture_; }

 private:
  static constexpr int kId = 1;  // all edits: field and gesture decide
  Scenario& held_;
  Scenario before_, after_;
  QString field_;
  int gesture_;
  std::function<void()> changed_;
};

}  // namespace cusp::ui
