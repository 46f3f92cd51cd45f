/// One edit of an exercise, to be undone and done again. Nothing else changes the exercise that an editor holds.
/// An exercise is a page of values, so an edit keeps it whole before and after: undoing cannot forget a field.
#pragma once

#include <QUndoCommand>
#include <functional>

#include "scenarios/format/scenario.h"
#include "ui/modules.h"

namespace cusp::ui {

class ScenarioEdit : public QUndoCommand {
 public:
  /// `field` and `gesture` say what may merge: edits of one field within one gesture (a handle being dragged, a spin box
  /// being turned) become one step. `changed` is called after every undo and redo; `held` outlives the command.
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
