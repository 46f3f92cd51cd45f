/// The instruments of the exercise, side by side under the tooth; [ and ] go through them. Thread: GUI.
#pragma once

#include <QFrame>
#include <vector>

#include "engine/tool/bur.h"
#include "ui/modules.h"

class QButtonGroup;
class QHBoxLayout;
class QLabel;

namespace cusp::ui {

class BurTray : public QFrame {
  Q_OBJECT

 public:
  explicit BurTray(QWidget* parent = nullptr);
  void set_burs(const std::vector<Bur>& burs);
  void choose(int index);
  /// The wanted bur is the chosen one. Until it is in use too, the tray says what the hand has to do.
  void show_burs(int in_use, int wanted);
  /// To the next (+1) or the one before (-1); stays at the ends.
  void step(int by);
  int chosen() const;
  /// Numbers alone, in a lower tray.
  void fold(bool on);

 Q_SIGNALS:
  /// By the user, not by choose().
  void bur_chosen(int index);

 private:
  void announce_bur(int index);

  QHBoxLayout *whole_, *row_;
  QLabel *keys_, *waits_;
  QButtonGroup* group_;
  int count_ = 0, waiting_ = -1;
  bool folded_ = false;
};

}  // namespace cusp::ui
