// The tooth in a window: what survives the loss of its OpenGL context, and a move to another window.

#include "ui/view/tooth_view.h"

#include <gtest/gtest.h>

#include <QTest>
#include <QVBoxLayout>
#include <atomic>

#include "tests/modules.h"
#include "tests/ui/render/ball.h"
#include "ui/render/framebuffer.h"
#include "ui/render/gl_context_egl.h"
#include "ui/render/opengl_allowed.h"
#include "ui/view/view_painter.h"

namespace cusp::test {
namespace {

constexpr int kPatienceMs = 60'000;  // waits for progress, never decides

/// A graphics card that loses its context when the test says so, and whose driver may report no reset.
struct Card {
  std::atomic<int> made = 0, losses = 0;  // losses: to come
  std::atomic<bool> refuses_reports = false;
};

class CardContext : public PaintContext {
 public:
  explicit CardContext(Card& card) : card_(card) {}
  bool make(Resets resets) override {
    if (resets == Resets::reported && card_.refuses_reports) return false;
    ++card_.made;
    context_ = EglContext::create(8, 8);
    return context_ != nullptr;
  }
  bool lost() override {
    if (card_.losses == 0) return false;
    --card_.losses;
    return true;
  }
  void end() override { context_.reset(); }

 private:
  Card& card_;
  std::unique_ptr<EglContext> context_;
};

struct ToothInAWindow : testing::Test {
  void SetUp() override {
    if (!EglContext::create(8, 8)) GTEST_SKIP() << "no OpenGL";
    view = new ToothView(&window, on_card());
    view->setFixedSize(240, 200);
    window.show();
    view->show_volume(Volume(Specimen::build(ball(2.0), Reading::banded)));
    ASSERT_TRUE(QTest::qWaitFor([&] { return shows_tooth(); }, kPatienceMs));
    whole = picture();
    ASSERT_EQ(card.made, 1);
  }
  ToothView::MakePainter on_card() {
    return [this](std::function<void(FinishedFrame)> drawn) {
      return std::make_unique<ViewPainter>(std::move(drawn), std::make_unique<CardContext>(card));
    };
  }
  QImage picture() const { return view->grab().toImage(); }
  bool shows_tooth() const { return shows_tooth(*view); }
  /// Enamel in the middle: warmer than grey, as the ground is colder.
  static bool shows_tooth(ToothView& in) {
    const QImage now = in.grab().toImage();
    const QRgb middle = now.pixel(now.width() / 2, now.height() / 2), corner = now.pixel(2, 2);
    return qRed(middle) > qBlue(middle) && qRed(corner) < qBlue(corner);
  }
  bool shows_the_same() const { return picture() == whole; }

  Card card;
  QWidget window;
  ToothView* view = nullptr;
  QImage whole;
};

TEST_F(ToothInAWindow, StandsAgainWithAllItHadAfterTheCardHasLostItsContext) {
  card.losses = 2;
  view->set_target_shown(true);  // as before: asks for a frame
  ASSERT_TRUE(QTest::qWaitFor([&] { return card.losses == 0 && card.made == 3; }, kPatienceMs));
  EXPECT_TRUE(QTest::qWaitFor([&] { return shows_the_same(); }, kPatienceMs));
  EXPECT_TRUE(view->pick({120, 100})) << "what is picked is no longer there";
  // A later frame, too, begins with what the new context has.
  Camera camera = view->camera();
  camera.orbit(0.5, 0.0);
  view->set_camera(camera);
  ASSERT_TRUE(QTest::qWaitFor([&] { return shows_tooth(); }, kPatienceMs));
  EXPECT_EQ(card.made, 3);
}

TEST_F(ToothInAWindow, IsDrawnByADriverThatRefusesAContextThatReportsResets) {
  card.refuses_reports = true;
  card.losses = 1;
  view->set_target_shown(true);
  ASSERT_TRUE(QTest::qWaitFor([&] { return card.losses == 0 && card.made == 2; }, kPatienceMs));
  EXPECT_TRUE(QTest::qWaitFor([&] { return shows_the_same(); }, kPatienceMs));
}

TEST_F(ToothInAWindow, IsDrawnInAnotherWindowByTheSameContext) {
  QWidget other;
  view->setParent(&other);
  view->move(10, 10);
  view->show();
  other.show();
  Camera camera = view->camera();
  const Camera before = camera;
  camera.zoom(1.5);
  view->set_camera(camera);
  ASSERT_TRUE(QTest::qWaitFor([&] { return shows_tooth() && !shows_the_same(); }, kPatienceMs));
  view->set_camera(before);
  EXPECT_TRUE(QTest::qWaitFor([&] { return shows_the_same(); }, kPatienceMs));
  EXPECT_EQ(card.made, 1);
  view->setParent(&window);  // which owns it
}

TEST_F(ToothInAWindow, IsDrawnSmallerAndScaledWhereTheViewIsWiderThanTheCardDraws) {
  const int most_px = [] {
    const auto context = EglContext::create(8, 8);
    return drawable({1 << 30, 1}).width_px;
  }();
  ASSERT_LT(most_px, 1 << 20) << "OpenGL gave no limit";
  ToothView wide(nullptr, on_card());
  wide.setFixedSize(most_px + 1000, 200);
  wide.show_volume(Volume(Specimen::build(ball(2.0), Reading::banded)));
  wide.show();
  EXPECT_TRUE(QTest::qWaitFor([&] { return !opengl_allowed() || shows_tooth(wide); }, kPatienceMs));
  EXPECT_TRUE(opengl_allowed()) << "one large view has turned every picture off";
}

}  // namespace
}  // namespace cusp::test
