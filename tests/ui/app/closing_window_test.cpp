// What is shown after the window has closed while work in the background goes on. The work waits at a gate.
#include "ui/app/closing_window.h"

#include <gtest/gtest.h>

#include <QLayout>
#include <QPushButton>
#include <QThreadPool>
#include <QTimer>
#include <functional>
#include <memory>
#include <utility>

#include "tests/modules.h"
#include "tests/ui/session/gate.h"
#include "ui/session/background_task.h"

namespace cusp::test {
namespace {

struct ClosingProgram : testing::Test {
  ClosingProgram() {
    wait_for_dropped_tasks();
    QThreadPool::globalInstance()->waitForDone();
    poll.setInterval(10);
    QObject::connect(&poll, &QTimer::timeout, &window, [this] {
      if (!window.isVisible() || !once_shown) return;
      said = window.text();
      std::exchange(once_shown, nullptr)();
    });
  }
  ~ClosingProgram() override {
    gate->open();
    wait_for_dropped_tasks();
    EXPECT_FALSE(gate->gave_up()) << "somebody waited for it";
  }
  void drop(BackgroundTask::Holds holds) const {
    BackgroundTask([held = gate] { held->pass(); }, holds);
  }
  ClosingWindow::End wait(std::function<void()> when_shown) {
    once_shown = std::move(when_shown);
    poll.start();
    return window.wait();
  }

  std::shared_ptr<Gate> gate = std::make_shared<Gate>();
  ClosingWindow window;
  QTimer poll;
  std::function<void()> once_shown;
  QString said;  // when it was shown
};

TEST_F(ClosingProgram, shows_nothing_where_nothing_is_at_work) {
  EXPECT_EQ(wait([] {}), ClosingWindow::End::work_over);
  EXPECT_TRUE(said.isEmpty());
}

TEST_F(ClosingProgram, leaves_a_drive_that_does_not_answer_where_nothing_can_be_lost) {
  drop(BackgroundTask::Holds::nothing);
  EXPECT_EQ(wait([this] { window.leave()->click(); }), ClosingWindow::End::left);
  EXPECT_TRUE(said.contains(QStringLiteral("Nothing is lost"))) << said.toStdString();
  EXPECT_FALSE(window.isVisible());
}

TEST_F(ClosingProgram, closes_by_its_frame_too_where_nothing_can_be_lost) {
  drop(BackgroundTask::Holds::device);
  EXPECT_EQ(wait([this] { window.close(); }), ClosingWindow::End::left);
}

TEST_F(ClosingProgram, names_what_is_lost_while_something_is_written_and_waits_until_it_is_written) {
  drop(BackgroundTask::Holds::change);
  bool stays = false;
  EXPECT_EQ(wait([this, &stays] {
              stays = !window.close() && window.isVisible();
              EXPECT_EQ(window.height(), window.layout()->totalHeightForWidth(window.width())) << "no gap about the text";
              gate->open();
            }),
            ClosingWindow::End::work_over);
  EXPECT_TRUE(stays) << "its frame loses nothing unasked";
  EXPECT_TRUE(said.contains(QStringLiteral("a file that is not finished is missing"))) << said.toStdString();
}

TEST_F(ClosingProgram, leaves_what_is_written_to_a_drive_that_hangs_if_somebody_wants_that) {
  drop(BackgroundTask::Holds::change);
  EXPECT_EQ(wait([this] { window.leave()->click(); }), ClosingWindow::End::left);
}

TEST_F(ClosingProgram, waits_for_the_pool_as_well) {
  QThreadPool::globalInstance()->start([held = gate] { held->pass(); });
  EXPECT_EQ(wait([this] { gate->open(); }), ClosingWindow::End::work_over);
  EXPECT_TRUE(said.contains(QStringLiteral("Nothing is lost"))) << said.toStdString();
}

}  // namespace
}  // namespace cusp::test
