/// The editor page: shapes and specimen at the left, the tooth with handles in the middle, numbers at the right, checks below.
/// It shows one EditorModel and saves the draft after each pause and on leaving. Thread: GUI.
#pragma once

#include <QTimer>
#include <QWidget>
#include <memory>

#include "storage/store.h"
#include "ui/editor/editor_model.h"
#include "ui/editor/later_forms.h"
#include "ui/editor/specimen_grower.h"
#include "ui/modules.h"
#include "ui/session/background_task.h"
#include "ui/session/exercise_session.h"
#include "ui/widgets/ports.h"

class QAbstractButton;
class QButtonGroup;
class QHBoxLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QStackedWidget;
class QTabWidget;
class QToolButton;
class QVBoxLayout;

namespace cusp::ui {

class Band;
class Busy;
class ButtonWait;
class Chip;
class OperatorJob;
class TargetView;
struct Published;

class EditorPage : public QWidget {
  Q_OBJECT

 public:
  EditorPage(Store& store, const Actor& actor, const Ports& ports, EditorStart start, QWidget* parent = nullptr);
  ~EditorPage() override;

  EditorModel& model() { return *model_; }
  TargetView* stage() const { return stage_; }
  /// The specimen shown; nullptr until it is grown.
  const std::shared_ptr<const GrownSpecimen>& grown() const { return grown_; }

 public Q_SLOTS:
  /// Starts an attempt at the draft as it stands, of which nothing is kept. After forbid_opengl() its button is disabled.
  void try_out();
  /// Lets the reference operator cut the draft at once, and asks for the report of it.
  void try_out_by_reference();
  /// Checks the exercise by attempts at it, off this thread, and opens the sheet that asks before publishing. Asks first as leave()
  /// does.
  void publish_version();
  /// Saves the draft while the window closes; as a copy if another window has changed it. False if neither can be written: the page
  /// shows the cause.
  bool keep_before_closing();
  /// Saves the draft and emits back_wanted(), both once a version that is being published stands. Asks first about a briefing that the
  /// exercise cannot hold. If saving fails, the page stays and shows the cause.
  void leave();

 Q_SIGNALS:
  void back_wanted();
  void try_out_wanted(const SessionPlan& plan, const QString& title);
  /// Of the reference operator's try-out.
  void result_wanted(const std::shared_ptr<const SessionResult>& result);
  void published(const ScenarioVersion& version);
  /// The editor continues with this copy; the opened exercise belongs to another window.
  void copied(const EditorStart& copy);
  /// The specimen is grown and shown.
  void ready();

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void lay_out();
  void follow_grower();
  void follow_reference();
  void stop_reference();
  void end_reference();
  void start_autosave();
  void take_typed();
  QWidget* make_top_bar();
  void add_try_outs(QHBoxLayout& row);
  QWidget* make_panels();
  QWidget* make_left();
  void add_tooth(QVBoxLayout& column);
  QWidget* make_right();
  void fit_left();
  bool left_in_tabs() const;
  QWidget* make_checks();
  Band* make_clash();
  bool keep();
  void keep_and_leave();
  bool half_filled() const;
  void with_briefing(const QString& question, const QString& verb, void (EditorPage::*act)());
  void show_clash();
  void see_theirs();
  void keep_copy();
  void ask_to_replace_theirs();
  void publish_now(int number);
  bool publishing() const;
  void begin_proof();
  void stop_proof();
  void show_proved(const Scenario& checked, std::vector<Finding> found);
  void open_sheet();
  void show_published(const Stored<Published>& done);
  void show_failure(const StorageFailure& failure);
  void grow();
  void follow_model();
  void show_title();
  void show_version();
  void show_undo();
  /// Undo or redo, after which the field that had the focus has it again.
  void step_history(QToolButton* button, void (QUndoStack::*step)());
  void show_check();
  void show_next_check();
  void show_place_of_check();
  void put_target_on_top();
  void show_tooth_form(bool on);

  Store& store_;
  Actor actor_;
  const Ports& ports_;
  std::optional<std::string> kept_;  // the draft's JSON that this window read or wrote last
  QTimer autosave_, grow_soon_;
  EditorModel* model_;
  std::shared_ptr<const void> held_;  // the folder of the volume: another window may discard the draft
  SpecimenGrower* grower_;
  OperatorJob* reference_job_ = nullptr;
  std::shared_ptr<const GrownSpecimen> grown_;
  TargetView* stage_ = nullptr;
  Band *band_ = nullptr, *clash_ = nullptr;
  QPushButton* see_theirs_ = nullptr;
  std::unique_ptr<ButtonWait> publish_wait_;
  BackgroundTask publish_task_;
  bool proving_ = false;  // before the sheet opens
  int proof_ = 0;         // the newest; what an older one found counts no more
  bool leaves_ = false;   // once the version is published
  std::size_t shown_check_ = 0;  // of the model's findings
  Busy* busy_ = nullptr;
  QLineEdit* title_ = nullptr;
  Chip *version_ = nullptr, *checks_chip_ = nullptr;
  QToolButton *undo_ = nullptr, *redo_ = nullptr, *next_check_ = nullptr;
  QPushButton* back_ = nullptr;
  QPushButton *try_ = nullptr, *reference_ = nullptr, *publish_ = nullptr, *stop_proof_ = nullptr, *show_ = nullptr, *change_ = nullptr, *on_top_ = nullptr;
  QLabel *check_title_ = nullptr, *check_aside_ = nullptr, *check_ = nullptr, *check_sign_ = nullptr, *tooth_ = nullptr, *try_key_ = nullptr;
  QHBoxLayout* panels_ = nullptr;  // left_, middle_ and tabs_
  QVBoxLayout *body_ = nullptr, *middle_ = nullptr;  // panels_, and the tooth; one of both ends with the checks
  QStackedWidget* left_ = nullptr;  // the first of panels_, or the last of tabs_
  QWidget* tooth_page_ = nullptr;  // of left_
  LaterForms forms_;
  QTabWidget* tabs_ = nullptr;
  QButtonGroup* shapes_ = nullptr;
  QVBoxLayout* contents_ = nullptr;
};

}  // namespace cusp::ui
