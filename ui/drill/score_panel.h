/// Right of the tooth: the section at the bur, progress against the target, what was removed by tissue, the device, and
/// whether the record is safe. In an assessment the task stands in place of the first three. Shows what it is given; decides
/// nothing. Thread: GUI.
#pragma once

#include <QFrame>
#include <vector>

#include "engine/base/haptic_port.h"
#include "scenarios/format/scenario.h"
#include "ui/modules.h"
#include "ui/session/exercise_session.h"
#include "ui/session/observer.h"
#include "ui/text/names.h"
#include "ui/widgets/gauge.h"

class QGridLayout;
class QLabel;
class QVBoxLayout;

namespace cusp::ui {

class HandpiecePanel;
class SectionView;
class SessionFoot;

class ScorePanel : public QFrame {
  Q_OBJECT

 public:
  explicit ScorePanel(QWidget* parent = nullptr);

  /// What the exercise has besides its tissues.
  struct Has {
    bool target = false, pulp = false;
    Guidance guidance = Guidance::full;  // silent: the task, no progress, and nothing of what was removed
    TissueNames names{};                 // the specimen's, of its own tissues
  };
  /// Called once.
  void set_exercise(const Scenario& scenario, const Has& has);
  /// stiffness_share: what the device leaves of the tissues' stiffness; below 1 the panel names it.
  void set_device(const DeviceLimits& limits, double stiffness_share = 1.0);
  void show_values(const LiveView& live);
  /// Whether a foot pedal is plugged in. One that was is missed.
  void show_pedal(bool plugged);
  /// Titles and numbers alone, in a narrower panel.
  void fold(bool on);
  SectionView* section() { return section_; }
  HandpiecePanel* handpiece() { return handpiece_; }

 private:
  struct BarRow {
    QLabel* name;
    Bar* bar;
    QLabel* value;
  };
  struct TissueRow {
    Tissue tissue;
    BarRow row;
  };
  QVBoxLayout* make_scrolled(QVBoxLayout& whole);
  void make_task();
  void make_progress();
  void make_device();
  void add_targets(const Scenario& scenario);
  void show_tissues(const LiveView& live);
  /// The rows of a part with a title and a rule below; it is their parent widget.
  QVBoxLayout* add_part(const QString& title, QLabel** aside = nullptr);
  BarRow add_bar(QGridLayout& grid, const QString& name, Bar::Role role);
  void fold_bars(QGridLayout& grid, const BarRow& row) const;

  QWidget* body_;
  SectionView* section_;
  HandpiecePanel* handpiece_;
  QFrame* handpiece_rule_;
  QLabel *section_aside_, *percent_, *over_cut_, *over_pulp_, *device_, *softened_, *device_state_, *no_pedal_, *task_;
  QWidget *task_part_, *section_part_, *progress_part_, *over_pulp_row_, *removed_part_;
  Bar* percent_bar_;
  QGridLayout *target_grid_, *tissue_grid_;
  std::vector<BarRow> targets_;  // of several
  std::vector<TissueRow> tissues_;
  SessionFoot* foot_;
  bool folded_ = false;
  bool had_pedal_ = false;  // since the attempt began
};

}  // namespace cusp::ui
