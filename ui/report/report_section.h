/// The section of the report: the drilled walls, and in dashes those of the reference preparation, which is cut in Qt's pool once a
/// section was opened. Thread: GUI.
#pragma once

#include <QWidget>
#include <memory>
#include <optional>

#include "engine/volume/volume.h"
#include "scenarios/format/scenario.h"
#include "ui/modules.h"
#include "ui/widgets/pool_job.h"

namespace cusp::ui {

class PinnedTooth;
class SectionBar;

class ReportSection : public QWidget {
  Q_OBJECT

 public:
  /// `tooth` outlives this. Pre: `volume` is not null.
  ReportSection(PinnedTooth& tooth, std::shared_ptr<const Volume> volume, const Scenario& scenario, QWidget* parent = nullptr);
  void set_open(bool open);
  /// Through a pinned place; without one the plane stays where it is.
  void go_through(const std::optional<Vec3>& place_mm);
  SectionBar* bar() const { return bar_; }
  /// The walls of the reference preparation are known. They never are if its operator has no path to the target.
  bool reference_known() const { return reference_ != nullptr; }

 private:
  void cut_reference();
  void follow_plane();
  void show_cut();

  PinnedTooth& tooth_;
  std::shared_ptr<const Volume> volume_, reference_;
  Scenario scenario_;
  SectionBar* bar_;
  QWidget *reference_line_, *target_line_;  // of the legend
  bool asked_ = false;
  PoolJob<ReportSection> cutting_;  // of the reference preparation; whoever closes the report cancels it
};

}  // namespace cusp::ui
