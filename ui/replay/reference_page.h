/// The reference preparation as it is cut: the tooth, the bur on its way, and a bar to play it. Ends with the finished preparation.
/// Thread: GUI.
#pragma once

#include <QElapsedTimer>
#include <QStackedWidget>
#include <QTimer>
#include <QWidget>

#include "ui/render/tooth_picture.h"
#include "ui/replay/reference_player.h"

class QLabel;

namespace cusp::ui {

class Busy;
class PlaybackBar;
class ToothView;

class ReferencePage : public QWidget {
  Q_OBJECT

 public:
  /// Begins at once, and plays as soon as the tooth is seen.
  ReferencePage(std::shared_ptr<ToothCache> teeth, const ToothWish& wish, const QString& title, QWidget* parent = nullptr);
  PlaybackBar* bar() const { return bar_; }
  ToothView* view() const { return view_; }
  /// The tooth stands in the view, and can be turned and played.
  bool ready() const { return show_ != nullptr; }
  /// Seconds of the path that the tooth in the view has.
  double shown_s() const;
  /// Where the bur is drawn; nullopt once the preparation is finished.
  std::optional<BurPose> bur_now() const;

  /// Whether a scripted operator may have a path for it: a target and a bur. The path itself shows the rest.
  static bool offered(const Scenario& scenario);

 Q_SIGNALS:
  void back_wanted();

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  QWidget* make_bar(const QString& title);
  QWidget* make_stage();
  void look();
  void show_progress();
  void begin();
  void show_failure(const ReferencePlayer::Failure& failure);
  void show_caption();
  /// The bar is at the end, and the tooth in the view too.
  bool finished() const;
  void turn_back();

  ReferencePlayer player_;
  std::shared_ptr<const ReferencePlayer::Show> show_;  // null: not yet
  QStackedWidget* stack_;
  Busy* busy_ = nullptr;
  ToothView* view_ = nullptr;
  QLabel* caption_ = nullptr;
  PlaybackBar* bar_ = nullptr;
  QTimer timer_;
  QElapsedTimer since_;  // the last look
  int shown_ = 0;
  int mesial_x_ = 0;  // of the tooth; 0 where no side is known
  double expected_time_s_ = 0;
  double tool_tilt_deg_ = 0;
};

}  // namespace cusp::ui
