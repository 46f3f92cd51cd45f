/// The card over the view that shows why the attempt stands still, and the ways on. Thread: GUI.
#pragma once

#include <QFrame>

#include "device/falcon/falcon_port.h"
#include "engine/step/step.h"
#include "ui/modules.h"
#include "ui/text/failure_text.h"

class QLabel;
class QPushButton;

namespace cusp::ui {

class HomingView;

/// Why a record cannot be written, and in one sentence what helps: the card itself says what is kept and what its button does.
Message describe_refused_record(const StorageFailure& failure);

class StopCard : public QFrame {
  Q_OBJECT

 public:
  /// record: while drilling; record_at_end: after Finish, when the session is stopped; behind: the tooth is being measured.
  /// handle_gone: the device answers, but not its handle, which turns the bur.
  /// silent: no tick comes, so the attempt can only be left until one does. undrawn: nobody sees where the bur cuts.
  enum class Stop { none, paused, fault, device_gone, handle_gone, device_back, silent, record, record_at_end, behind, undrawn };

  explicit StopCard(QWidget* parent = nullptr);
  /// `record`: of describe_refused_record(); `fault`: of Stop::fault. Read out when another stop or another cause
  /// stands there. True if it did.
  bool show_stop(Stop stop, const Message& record, Fault fault);
  /// While a Falcon is gone, its state, with the picture of homing, and which one is to be plugged in. True if the card grew or shrank.
  bool show_falcon(const FalconView* view);
  /// As wide as `most` and as high as it needs. If that is too high, the text of homing takes the place of its picture.
  void fit(QSize most);

 Q_SIGNALS:
  void go_on();
  void finish_again();
  void leave();

 private:
  void show_ways();

  QLabel *title_, *more_;
  QPushButton *leave_, *go_on_, *finish_again_;
  HomingView* homing_;
  QString homing_text_;  // by the homing, as it was laid out
  QString more_text_;    // without it
  QString which_text_;   // of a gone Falcon: what identifies it, if that is little
  QString cause_;  // of Stop::record and Stop::record_at_end, as it is shown
  Stop stop_ = Stop::none;
  Fault fault_ = Fault::none;  // of Stop::fault
};

}  // namespace cusp::ui
