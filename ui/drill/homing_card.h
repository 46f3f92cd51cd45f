/// A card over the drilling screen while a Falcon is opened and homed. Thread: GUI.
#pragma once

#include "device/falcon/falcon_port.h"
#include "ui/modules.h"
#include "ui/widgets/parts.h"

namespace cusp::ui {

class HomingView;

class HomingCard : public Card {
  Q_OBJECT

 public:
  explicit HomingCard(QWidget* over);
  /// Shows itself in the middle of what it stands over. False, and hidden, once the Falcon is homed: what follows may take longer.
  bool show_falcon(const FalconView& view);

 private:
  HomingView* homing_;
};

}  // namespace cusp::ui
