/// The start page's word about an attempt that broke off: what, when, how far, and the one way on.
#pragma once

#include "storage/store.h"
#include "ui/modules.h"
#include "ui/widgets/parts.h"

namespace cusp::ui {

/// What may be done with an interrupted attempt.
enum class InterruptedWay : std::uint8_t {
  go_on,         // by the same student, engine version and class of device
  other_device,  // only graded as it stands: this station drills with another class of device
  scripted,      // only graded as it stands: a scripted operator cut it
  other_engine,  // neither: its inputs cannot be run again
};
Stored<InterruptedWay> way_of(Store& store, const HistoryRow& row, const std::string& device_class);

class InterruptedCard : public Card {
  Q_OBJECT

 public:
  /// `way` is not other_engine.
  InterruptedCard(Store& store, const HistoryRow& row, InterruptedWay way, const std::string& device_class,
                  QWidget* parent = nullptr);
  QPushButton* primary() const { return primary_; }

 Q_SIGNALS:
  void resume_wanted();
  void grade_wanted();

 private:
  QPushButton* primary_ = nullptr;
};

}  // namespace cusp::ui
