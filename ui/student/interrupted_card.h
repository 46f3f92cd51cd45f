/// Card of an interrupted attempt: exercise, time, progress, and how to continue. Thread: GUI.
#pragma once

#include "storage/store.h"
#include "ui/modules.h"
#include "ui/widgets/parts.h"

namespace cusp::ui {

/// What may be done with an interrupted attempt.
enum class InterruptedWay : std::uint8_t {
  resume,        // same student, engine version and device class
  other_device,  // can only be graded: this station has another device class
  volume_kept,   // can only be graded: an older program has kept its volume, and a session has one
  scripted,      // can only be graded: a scripted operator cut it
  other_engine,  // neither: this engine cannot replay its inputs
};
Stored<InterruptedWay> way_of(Store& store, const HistoryRow& row, const std::string& device_class);

class InterruptedCard : public Card {
  Q_OBJECT

 public:
  /// Pre: `way` is not other_engine. `kind`: of primary(), as a page has one button of ButtonKind::primary.
  InterruptedCard(Store& store, const HistoryRow& row, InterruptedWay way, const std::string& device_class,
                  ButtonKind kind = ButtonKind::primary, QWidget* parent = nullptr);
  /// "Continue" is disabled after forbid_opengl(), and the card gives the reason.
  QPushButton* primary() const { return primary_; }

 Q_SIGNALS:
  void resume_wanted();
  /// Of an assessment: it is to be handed in as it stands.
  void grade_wanted();

 private:
  QPushButton* primary_ = nullptr;
};

}  // namespace cusp::ui
