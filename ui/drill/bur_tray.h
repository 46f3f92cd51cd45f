/// The instruments of the exercise, side by side under the tooth; [ and ] go through them. Thread: GUI.
#pragma once

#include <QFrame>
#include <vector>

#include "engine/tool/bur.h"
#include "ui/modules.h"

class QButtonGroup;
class QHBoxLayout;

namespace cusp::ui {

class BurTray : public QFrame {
  Q_OBJECT

 public:
  explicit BurTray(QWidget* parent = nullptr);
  void set_burs(const std::vector<Bur>& burs);
  void choose(int index);
  /// To the next (+1) or the one before (-1); stays at the ends.
  void step(int by);
  int chosen() const;

 Q_SIGNALS:
  /// By the user, not by choose().
  void bur_chosen(int index);

 private:
  QHBoxLayout* row_;
  QButtonGroup* group_;
  int count_ = 0;
};

}  // namespace cusp::ui
