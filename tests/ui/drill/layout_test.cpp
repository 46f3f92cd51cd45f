// What the drilling screen does in a small window, and in languages that are read from the right.
#include <gtest/gtest.h>

#include <sstream>

#include <QApplication>
#include <QLabel>
#include <QPushButton>

#include "scenarios/library/library.h"
#include "tests/modules.h"
#include "ui/drill/depth_scale.h"
#include "ui/drill/cut_slider.h"
#include "ui/drill/drill_stage.h"
#include "ui/drill/handpiece_panel.h"
#include "ui/drill/score_panel.h"
#include "ui/drill/section_view.h"
#include "ui/drill/section_place.h"
#include "ui/text/tooth_sides.h"
#include "ui/view/compass.h"
#include "ui/widgets/format.h"
#include "ui/widgets/gauge.h"
#include "ui/widgets/theme.h"

namespace cusp::test {
namespace {

/// Pixels of the half of `image` that differ from the same half of `empty`.
enum class Half { left, right };
int drawn_in(Half half, const QImage& image, const QImage& empty) {
  int out = 0;
  const int middle = image.width() / 2, first = half == Half::left ? 0 : middle, end = half == Half::left ? middle : image.width();
  for (int y = 0; y < image.height(); ++y)
    for (int x = first; x < end; ++x) out += image.pixel(x, y) != empty.pixel(x, y);
  return out;
}

TEST(DrillLayout, the_sides_of_a_section_stay_where_they_are_on_the_tooth_in_every_language) {
  for (const Qt::LayoutDirection way : {Qt::LeftToRight, Qt::RightToLeft}) {
    SectionView section;
    section.setLayoutDirection(way);
    section.resize(271, 202);
    const QImage empty = section.grab().toImage();
    section.set_sides(QStringLiteral("B"), {});
    const QImage shown = section.grab().toImage();
    EXPECT_GT(drawn_in(Half::left, shown, empty), 5);
    EXPECT_EQ(drawn_in(Half::right, shown, empty), 0);
  }
}

TEST(DrillLayout, a_gauge_looks_the_same_in_every_language) {
  QImage before;
  for (const Qt::LayoutDirection way : {Qt::LeftToRight, Qt::RightToLeft}) {
    Gauge gauge(QStringLiteral("Force"), QStringLiteral("N"), Gauge::Grows::up);
    gauge.setLayoutDirection(way);
    gauge.set_scale({.least = 0, .most = 3, .major_step = 0.5});
    gauge.set_scale_side(Gauge::ScaleSide::right);
    gauge.set_value(1.2);
    gauge.resize(gauge.sizeHint());
    const QImage image = gauge.grab().toImage();
    if (!before.isNull()) {
      EXPECT_EQ(image, before);
    }
    before = image;
  }
}

TEST(DrillLayout, in_half_a_full_hd_screen_the_tools_fit_and_nothing_covers_the_gauges) {
  // 960 x 540 is what full HD has at 200 %; bars and the panel at the side leave this to the stage.
  DrillStage stage;
  stage.resize(656, 400);
  stage.show();
  QApplication::processEvents();
  EXPECT_EQ(stage.size(), QSize(656, 400));
  QPushButton* turn = nullptr;
  for (QPushButton* button : stage.findChildren<QPushButton*>())
    if (turn == nullptr && button->toolTip().endsWith(QStringLiteral("(1)"))) turn = button;
  ASSERT_NE(turn, nullptr);
  const QRect tools = turn->parentWidget()->geometry();
  EXPECT_GE(tools.left(), 0);
  EXPECT_LE(tools.right(), 656);
  for (const Gauge* gauge : stage.findChildren<Gauge*>()) {
    EXPECT_GT(gauge->geometry().top(), tools.bottom());
    EXPECT_LE(gauge->geometry().bottom(), 400 - 50);  // the legend and the coach stand below
    EXPECT_GE(gauge->height(), gauge->minimumSizeHint().height());
  }
}

/// A stage for a slot 1.6 mm wide and 1.8 mm deep in a specimen of 20 x 20 x 10 mm below z = 0.
struct DrillGauges : testing::Test {
  DrillStage stage;
  LiveView live;
  void SetUp() override {
    Scenario scenario;
    scenario.target.outline.shape = "channel";
    scenario.target.outline.paths = {{{-4, 0, -1.8}, {4, 0, -1.8}}};
    scenario.target.outline.width_mm = 1.6;
    scenario.target.outline.depth_mm = 1.8;
    scenario.leeway = {0.2, 0.2};
    stage.resize(900, 600);
    stage.show();
    stage.set_exercise(scenario, TargetLook(scenario.target, scenario.leeway, nullptr), {.bounds = {{-10, -10, -10}, {10, 10, 0}}, .by_mouse = true, .is_tooth = true, .pulp_depth_mm = 3.1});
    live.phase = LoopPhase::running;
    live.output.tick = 1;
    live.output.contact = true;
    live.push_n = 0.8;
    live.removed_mm3[index_of(Tissue::enamel)] = 1.0;
    at({0, 0, -1}, 1.5);
  }
  void at(Vec3 pivot_mm, double depth_mm) {
    live.output.proxy_mm = pivot_mm;
    live.bur_depth_mm = depth_mm;
    stage.show_values(live);
  }
  Gauge& gauge(const char* name) {
    for (Gauge* one : stage.findChildren<Gauge*>())
      if (one->title() == QLatin1String(name)) return *one;
    throw std::runtime_error(name);
  }
  QLabel* coach() {
    for (QLabel* label : stage.findChildren<QLabel*>())
      if (label->accessibleName() == QStringLiteral("Coach")) return label;
    return nullptr;
  }
};

TEST_F(DrillGauges, the_depth_scale_shows_what_is_too_deep_and_the_pulp) {
  EXPECT_DOUBLE_EQ(gauge("Depth").most(), 4.0);  // pulp at 3.1, and half a millimetre beyond it
  EXPECT_DOUBLE_EQ(depth_scale_mm({.required_mm = 1.8, .leeway_mm = 0.2}), 3.0);
  EXPECT_DOUBLE_EQ(depth_scale_mm({.required_mm = 1.8, .leeway_mm = 0.2, .pulp_mm = 2.4}), 3.0);
  EXPECT_DOUBLE_EQ(depth_scale_mm({.required_mm = 2.0, .leeway_mm = 0.3}), 3.5);
  EXPECT_DOUBLE_EQ(depth_scale_mm({.required_mm = 0.5, .leeway_mm = 0.1, .pulp_mm = 6.2}), 7.0);
  at({0, 0, -4.2}, 4.7);
  EXPECT_GE(gauge("Depth").most(), 4.7);
  EXPECT_DOUBLE_EQ(gauge("Depth").value().value(), 4.7);
}

TEST_F(DrillGauges, before_the_first_step_the_bur_has_no_depth_and_the_scale_stays) {
  live.output.tick = 0;
  live.output.contact = false;
  at({0, 0, 0}, 4.7);  // deeper than the scale
  EXPECT_FALSE(gauge("Depth").value().has_value());
  EXPECT_DOUBLE_EQ(gauge("Depth").most(), 4.0);
}

TEST_F(DrillGauges, a_bur_beside_the_tooth_has_no_depth_and_one_over_the_cavity_has) {
  live.output.contact = false;
  at({9, 9, -6}, 6.5);
  EXPECT_FALSE(gauge("Depth").value().has_value());
  at({0, 0, -0.5}, 1.0);
  EXPECT_TRUE(gauge("Depth").value().has_value());
}

TEST_F(DrillGauges, nothing_on_the_stage_covers_anything_else_in_half_a_full_hd_screen) {
  stage.resize(656, 400);
  stage.show_values(live);
  QApplication::processEvents();
  const auto named = [](const QWidget& one) {
    std::stringstream out;
    out << one.metaObject()->className() << ' ' << one.accessibleName().toStdString() << " at " << one.x() << ',' << one.y() << ' ' << one.width() << 'x' << one.height();
    return out.str();
  };
  std::vector<const QWidget*> shown;
  for (const QWidget* one : stage.findChildren<QWidget*>(Qt::FindDirectChildrenOnly))
    if (one->isVisible() && one->size() != stage.size() && !one->inherits("QFocusFrame") && one->property("kind") != QStringLiteral("pin")) shown.push_back(one);
  EXPECT_GE(shown.size(), 6U);  // tools, two gauges, depth hold, legend, coach
  for (std::size_t i = 0; i < shown.size(); ++i) {
    EXPECT_TRUE(stage.rect().contains(shown[i]->geometry())) << named(*shown[i]);
    for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(shown[i]->geometry().intersects(shown[j]->geometry())) << named(*shown[i]) << " covers " << named(*shown[j]);
  }
}

TEST_F(DrillGauges, the_spring_of_a_proxy_that_has_not_converged_is_not_shown_as_force) {
  live.output.deferred = true;
  live.push_n = 23.0;  // the device point is far ahead
  stage.show_values(live);
  EXPECT_DOUBLE_EQ(gauge("Force").value().value(), 0.8);
}

TEST_F(DrillGauges, last_values_of_an_attempt_that_stands_are_no_longer_shown) {
  EXPECT_GT(gauge("Force").value().value(), 0);
  EXPECT_TRUE(coach()->isVisible());
  live.phase = LoopPhase::paused;
  stage.show_values(live);
  EXPECT_DOUBLE_EQ(gauge("Force").value().value(), 0);
  EXPECT_FALSE(coach()->isVisible());
  live.phase = LoopPhase::held;
  live.device = Sample::Status::gone;
  stage.show_values(live);
  EXPECT_FALSE(gauge("Depth").value().has_value());
}

TEST_F(DrillGauges, the_cutaway_keeps_to_the_target_when_the_bur_leaves_it) {
  Outline target;
  target.shape = "channel";
  target.paths = {{{-4, 2, -1.8}, {4, 2, -1.8}}};
  target.width_mm = 1.6;
  target.depth_mm = 1.8;
  SectionPlace place(TargetLook(region_of(target), {0.2, 0.2}, nullptr), {{-10, -10, -10}, {10, 10, 0}});
  EXPECT_EQ(place.follow({40, 30, 5}), Vec3(0, 2, 0)) << "not there yet: the target's middle";
  EXPECT_EQ(place.follow({1.5, 2.2, -1}), Vec3(1.5, 2.2, 0)) << "where it works";
  EXPECT_EQ(place.follow({1.5, 2.2, 12}), Vec3(1.5, 2.2, 0)) << "lifted straight out";
  EXPECT_EQ(place.follow({1.5, -30, 12}), Vec3(1.5, 2.2, 0)) << "laid aside: as it was";
  SectionPlace free(TargetLook(Region{}, {}, nullptr), {{-10, -10, -10}, {10, 10, 0}});
  EXPECT_EQ(free.follow({0, -30, 3}), Vec3(0, 0, 0)) << "without a target: the specimen's middle";
}

TEST_F(DrillGauges, how_the_mirror_is_moved_stands_below_the_tools_while_it_is_held) {
  const auto hint = [this]() -> const QLabel* {
    for (const QLabel* label : stage.findChildren<QLabel*>())
      if (label->isVisible() && label->text().startsWith(QStringLiteral("Drag the mirror"))) return label;
    return nullptr;
  };
  EXPECT_EQ(hint(), nullptr);
  stage.press_key(Qt::Key_2, Qt::NoModifier);
  ASSERT_NE(hint(), nullptr);
  for (const Gauge* gauge : stage.findChildren<Gauge*>()) EXPECT_FALSE(hint()->geometry().intersects(gauge->geometry()));
  stage.resize(520, 340);  // there the tooltip says it
  EXPECT_EQ(hint(), nullptr);
  stage.resize(900, 600);
  EXPECT_NE(hint(), nullptr);
  stage.press_key(Qt::Key_3, Qt::NoModifier);
  EXPECT_EQ(hint(), nullptr) << "the cutaway puts the mirror away";
}

TEST_F(DrillGauges, the_cutaway_has_a_slider_that_moves_its_plane_towards_the_viewer) {
  std::optional<SectionWish> lid;
  QObject::connect(&stage, &DrillStage::sections_wanted, [&](const auto&, const std::optional<SectionWish>& wish) { lid = wish; });
  auto* cut = stage.findChild<CutSlider*>();
  EXPECT_FALSE(cut->isVisible());
  stage.press_key(Qt::Key_3, Qt::NoModifier);
  ASSERT_TRUE(lid && cut->isVisible());
  const Vec3 at_bur = lid->shift_mm;
  cut->slider()->setValue(12);
  EXPECT_DOUBLE_EQ(cut->nearer_mm(), 1.2);
  const Vec3 to_eye = -stage.view()->camera().forward();
  const Vec3 moved = lid->shift_mm - at_bur;
  EXPECT_NEAR(glm::length(moved), 1.2, 1e-9);
  EXPECT_GT(glm::dot(moved, to_eye), 0.0);
  EXPECT_DOUBLE_EQ(moved.z, 0.0) << "the plane is upright";
  stage.press_key(Qt::Key_3, Qt::NoModifier);
  stage.press_key(Qt::Key_3, Qt::NoModifier);
  EXPECT_EQ(lid->shift_mm, at_bur) << "opened again it goes through the bur";
}

TEST(ScorePanel, shows_what_is_removed_of_each_of_several_targets) {
  ScorePanel panel;
  panel.set_exercise(load_builtin("class-1-16").value(), {.target = true, .pulp = true});
  LiveView live;
  live.removed_of_percent = {45.2, 7.9};
  panel.show_values(live);
  const auto shown = [&panel](const QString& name) {
    for (const QLabel* label : panel.findChildren<QLabel*>())
      if (label->accessibleDescription() == name) return label->text();
    return QString();
  };
  EXPECT_EQ(shown(QStringLiteral("Mesial cavity")), format({45.2, {}, QStringLiteral("%"), 0}));
  EXPECT_EQ(shown(QStringLiteral("Distal cavity")), format({7.9, {}, QStringLiteral("%"), 0}));
  ScorePanel of_one;
  of_one.set_exercise(load_builtin("class-1-36").value(), {.target = true, .pulp = true});
  EXPECT_EQ(of_one.findChildren<Bar*>().size(), panel.findChildren<Bar*>().size() - 2);
}

TEST(ScorePanel, names_the_sides_of_the_section_as_the_compass_does) {
  const auto says = [](const Scenario& scenario, const QString& sides) {
    ScorePanel panel;
    panel.set_exercise(scenario, {.target = true, .pulp = true});
    for (const QLabel* label : panel.findChildren<QLabel*>())
      if (label->text() == sides) return true;
    return false;
  };
  EXPECT_TRUE(says(load_builtin("class-1-16").value(), u"buccal–palatal"_qs));
  EXPECT_TRUE(says(load_builtin("class-1-36").value(), u"buccal–lingual"_qs));
  Scenario imported = load_builtin("class-1-36").value();
  imported.specimen = {};
  imported.specimen.volume = "molar.nrrd";
  EXPECT_TRUE(says(imported, u"across"_qs)) << "nobody knows where its buccal side lies";
}

TEST(StopCard, names_the_cause_for_which_the_record_cannot_be_written) {
  const auto shown = [](const StorageFailure& failure) {
    DrillStage stage;
    LiveView live;
    live.recording = RecordingState::failed;
    live.recording_failure = failure;
    stage.show_values(live);
    QString text;
    for (const QLabel* label : stage.findChild<StopCard*>()->findChildren<QLabel*>()) text += label->text() + u' ';
    return text;
  };
  const QString full = shown({StorageError::disk_full, "/data/cusp.db", {}});
  EXPECT_TRUE(full.contains(u"The disk is full. Free some space for %1. What you drilled so far is kept while this window stays open. "
                            "Resume then writes it and goes on."_qs.arg(isolate(u"/data/cusp.db"_qs)))) << full.toStdString();
  for (const StorageError other : {StorageError::read_only, StorageError::busy, StorageError::io, StorageError::corrupt}) {
    const StorageFailure failure{other, "/data/cusp.db", {}};
    const QString text = shown(failure);
    EXPECT_TRUE(text.contains(describe(failure).what)) << text.toStdString();
    EXPECT_FALSE(text.contains(u"room on the disk"_qs) || text.contains(u"disk is full"_qs)) << text.toStdString();
    EXPECT_TRUE(text.contains(u"/data/cusp.db"_qs)) << text.toStdString();
    EXPECT_FALSE(text.contains(u"try again"_qs) || text.contains(u"Nothing was changed"_qs)) << "beside what the card says: " << text.toStdString();
  }
}

TEST(StopCard, is_read_out_with_what_to_do_next) {
  StopCard card;
  card.show_stop(StopCard::Stop::device_back, {}, Fault::none);
  EXPECT_EQ(card.accessibleDescription().toStdString(),
            "The device answers again. The force is off and the clock stands still. Take the handpiece, then resume.");
  card.show_stop(StopCard::Stop::fault, {}, Fault::jump);
  EXPECT_EQ(card.accessibleDescription().toStdString(), "The device jumped. The force is off and the clock stands still. Your work is kept.");
}

TEST(ScorePanel, shows_no_warmth_in_an_assessment) {
  ScorePanel panel;
  panel.set_exercise(load_builtin("class-1-36-wet").value(), {.pulp = true, .guidance = Guidance::silent});
  LiveView live;
  live.output.heat_k = 8.0f;
  panel.show_values(live);
  const HandpiecePanel& handpiece = *panel.handpiece();
  for (const QLabel* label : handpiece.findChildren<QLabel*>())
    EXPECT_FALSE(!label->isHidden() && label->text().contains(u"pulp"_qs)) << label->text().toStdString();
  EXPECT_FALSE(handpiece.spoken().contains(u"warmer"_qs)) << handpiece.spoken().toStdString();
  EXPECT_TRUE(handpiece.spoken().contains(u"Coolant is off"_qs));
}

TEST(Compass, points_mesially_as_the_tooth_of_its_quadrant_lies) {
  const auto letter_of = [](int fdi, Vec3 way) {
    for (const ToothSide& w : tooth_sides(fdi)) {
      if (w.way == way) return w.letter;
    }
    return QString();
  };
  // Towards the midline: facts/dental.md's quadrants, as scenarios/teeth lays its teeth (teeth_test holds the teeth to it).
  for (const int fdi : {16, 36}) EXPECT_EQ(letter_of(fdi, {1, 0, 0}), QStringLiteral("M")) << fdi;
  for (const int fdi : {26, 46}) {
    EXPECT_EQ(letter_of(fdi, {1, 0, 0}), QStringLiteral("D")) << fdi;
    EXPECT_EQ(letter_of(fdi, {-1, 0, 0}), QStringLiteral("M")) << fdi;
  }
  EXPECT_EQ(letter_of(16, {0, -1, 0}), QStringLiteral("P"));
  EXPECT_EQ(letter_of(36, {0, -1, 0}), QStringLiteral("L"));
}

TEST(DrillStage, speaks_of_no_target_where_there_is_none) {
  DrillStage stage;
  stage.set_exercise({}, TargetLook(Region{}, {}, nullptr), {.bounds = {Vec3(-5.0), Vec3(5.0)}, .by_mouse = true});
  stage.show_values({});
  EXPECT_FALSE(stage.spoken().contains(u"target"_qs)) << stage.spoken().toStdString();
  EXPECT_TRUE(stage.spoken().startsWith(u"Depth"_qs)) << stage.spoken().toStdString();
}

TEST(Compass, is_hidden_where_no_side_of_the_specimen_is_known) {
  DrillStage stage;
  auto* compass = stage.findChild<Compass*>();
  Scenario scenario;
  scenario.specimen.volume = "molar.nrrd";
  stage.set_exercise(scenario, TargetLook(Region{}, {}, nullptr), {.bounds = {Vec3(-5.0), Vec3(5.0)}, .by_mouse = true, .is_tooth = true});
  EXPECT_TRUE(compass->isHidden());
  scenario.specimen = {};
  scenario.specimen.generator = "tooth";
  scenario.specimen.fdi = 46;
  stage.set_exercise(scenario, TargetLook(Region{}, {}, nullptr), {.bounds = {Vec3(-5.0), Vec3(5.0)}, .by_mouse = true, .is_tooth = true});
  EXPECT_FALSE(compass->isHidden());
}

TEST(StopCard, a_device_that_answers_again_is_shown_as_back_without_its_cable) {
  DrillStage stage;
  stage.resize(800, 600);
  stage.show();
  const auto shown = [&stage](const char* text) {
    for (const QLabel* label : stage.findChildren<QLabel*>())
      if (label->isVisible() && label->text().contains(QLatin1String(text))) return true;
    return false;
  };
  LiveView live;
  live.phase = LoopPhase::held;
  live.fault = Fault::gone;
  live.device = Sample::Status::gone;
  stage.show_values(live);
  EXPECT_TRUE(shown("does not answer"));
  live.device = Sample::Status::fresh;
  stage.show_values(live);
  EXPECT_TRUE(shown("answers again"));
  EXPECT_FALSE(shown("cable"));
  live.fault = Fault::jump;
  stage.show_values(live);
  EXPECT_TRUE(shown("jumped"));
  live.fault = Fault::late;  // resumed and stopped again between two looks
  stage.show_values(live);
  EXPECT_TRUE(shown("too late"));
  live.silent = true;
  stage.show_values(live);
  EXPECT_TRUE(shown("driver of the device stands still"));
  live = {};
  stage.show_values(live);
  EXPECT_FALSE(shown("stands still"));
}

}  // namespace
}  // namespace cusp::test
