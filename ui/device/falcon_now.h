/// The live values of a Falcon: how often it answers and how late, whether it is lost at times, its priority, its buttons and
/// its light. Thread: GUI.
#pragma once

#include <QWidget>
#include <array>
#include <cstdint>

#include "ui/session/device_bench.h"

class QLabel;

namespace cusp::ui {

class Chip;

class FalconNow : public QWidget {
  Q_OBJECT

 public:
  explicit FalconNow(QWidget* parent = nullptr);
  void show_bench(const BenchView& view);

 Q_SIGNALS:
  /// falcon::control bits.
  void light_wanted(std::uint8_t leds);

 private:
  QLabel *rate_, *late_, *lost_, *grant_;
  std::array<Chip*, 4> buttons_{};
};

}  // namespace cusp::ui
