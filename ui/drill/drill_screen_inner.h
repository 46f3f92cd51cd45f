/// The drilling screen's parts and the attempt that it shows. For drill_screen*.cpp alone. Thread: GUI.
#pragma once

#include <QTimer>
#include <functional>
#include <memory>
#include <thread>

#include "ui/drill/attempt_opening.h"
#include "ui/drill/attempt_sound.h"
#include "ui/drill/bur_tray.h"
#include "ui/drill/drill_bar.h"
#include "ui/drill/drill_screen.h"
#include "ui/drill/drill_stage.h"
#include "ui/drill/hand_motion.h"
#include "ui/drill/handpiece_panel.h"
#include "ui/drill/homing_card.h"
#include "ui/drill/pointer_input.h"
#include "ui/drill/score_panel.h"
#include "ui/view/frame_stats.h"
#include "ui/view/tooth_view.h"
#include "ui/widgets/busy.h"
#include "ui/widgets/idle_watch.h"

namespace cusp::ui {

struct DrillScreen::Inner {
  Ports ports;
  // Widgets.
  DrillBar* bar;
  DrillStage* stage;
  ScorePanel* panel;
  BurTray* tray;
  Busy* busy;
  QTimer look_timer;
  AttemptSound* sound;
  HomingCard* homing;

  // The attempt.
  DeviceChoice choice;
  std::shared_ptr<ToothCache> teeth;
  std::function<bool()> pedal_plugged;  // of watch_pedal()
  Guidance guidance = Guidance::full;
  QString leave_code;  // an assessment's start code, which leaves it as well; else empty
  std::unique_ptr<AttemptOpening> opening;  // until the attempt has started
  QTimer opening_timer;
  std::shared_ptr<OpenedAttempt> attempt;
  std::unique_ptr<PointerInput> input;
  std::thread worker;  // grades
  FrameStats stats;
  LiveView live;
  int looks = 0;
  IdleWatch hand{[this] { return ports.since_boot ? ports.since_boot() : time_since_boot(); }};  // mouse, keys and device
  HandMotion motion;
  std::shared_ptr<void> awake;  // Ports::keep_awake, while the attempt runs and somebody attends it
  std::function<void()> after_leaving;  // of ask_leave_then(); empty: nothing
  bool working = false, over = false;
  bool asked = false;   // Finish's or Leave's question is open
  bool stood = false;   // before that question, or its device was lost meanwhile: nothing but Resume starts it
  bool unseen = false;  // the attempt runs, its tooth stands in no frame yet
};

}  // namespace cusp::ui
