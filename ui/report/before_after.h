/// The tooth of the report alone, or beside the same tooth as it was: both from one side, turned and zoomed together. Thread: GUI.
#pragma once

#include <QWidget>
#include <memory>

#include "engine/volume/volume.h"
#include "scenarios/format/scenario.h"
#include "ui/modules.h"

class QFrame;

namespace cusp::ui {

class PinnedTooth;
class ToothView;

class BeforeAfter : public QWidget {
  Q_OBJECT

 public:
  /// Takes the tooth. `volume` may be null: then nothing is shown beside it.
  BeforeAfter(PinnedTooth* after, std::shared_ptr<const Volume> volume, const Scenario& scenario, QWidget* parent = nullptr);
  enum class Shown { after, both };
  void show_teeth(Shown shown);
  /// nullptr until both were shown.
  ToothView* before() const { return before_; }
  /// The mesh of the tooth as it was is built in the background.
  bool before_shown() const { return before_shown_; }

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void make_before();
  QFrame* make_name(const QString& text);
  void place_all();

  PinnedTooth* after_;
  ToothView* before_ = nullptr;
  QFrame *before_name_, *after_name_;
  std::shared_ptr<const Volume> volume_;
  Scenario scenario_;
  Shown shown_ = Shown::after;
  bool before_shown_ = false;
};

}  // namespace cusp::ui
