// The editor's audit page, with a runner that answers at once.

#include <gtest/gtest.h>

#include <QCheckBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <atomic>
#include <cmath>
#include <thread>

#include "scenarios/library/library.h"
#include "tests/modules.h"
#include "ui/editor/audit_page.h"
#include "ui/text/audit_text.h"
#include "ui/widgets/busy.h"

namespace cusp::test {
namespace {

constexpr int kAnswersWithinMs = 30'000;  // waited for, never decided by

EditorStart draft() {
  EditorStart start;
  start.draft = *load_builtin("channel-1");
  start.draft.phenomena = {"friction", "heat"};
  ++start.draft.version;
  return start;
}

ModelResult of(const Model& model, const std::vector<AuditOperator>& operators, double score) {
  ModelResult out;
  out.cost.us_a_tick = 10.0 + 4.0 * static_cast<double>(model.scenario.phenomena.size());
  out.cost.us_more = out.cost.us_a_tick - 18.0;
  out.cost.bytes = 20'000'000;
  for (const AuditOperator& scripted : operators) {
    ModelAttempt attempt;
    attempt.by = scripted;
    attempt.grade.score = score;
    out.attempts.push_back(attempt);
  }
  return out;
}

/// Friction counts for nothing, heat for five points, voxels for half a point each 0.1 mm more.
AuditRunner at_once(const std::string&) {
  return [](const AuditRun& run, const AuditWatch& watch) -> Result<std::vector<std::optional<ModelResult>>, AuditFailure> {
    std::vector<std::optional<ModelResult>> out;
    for (const Model& m : run.models) {
      if (!watch(0.5)) return fail(AuditError::cancelled, {});
      const bool heat = std::ranges::find(m.scenario.phenomena, "heat") != m.scenario.phenomena.end();
      out.push_back(of(m, run.operators, (heat ? 90.0 : 85.0) - 5 * m.scenario.specimen.voxel_mm));
    }
    return out;
  };
}

QString texts(const QWidget& page) {
  QString out;
  for (const QLabel* label : page.findChildren<QLabel*>()) out += label->text() + u'\n';
  return out;
}

QPushButton* button(const QWidget& page, const char* text) {
  for (QPushButton* b : page.findChildren<QPushButton*>())
    if (b->text().trimmed() == QLatin1String(text)) return b;
  ADD_FAILURE() << text;
  return nullptr;
}

bool measure(AuditPage& page) {
  page.show();
  button(page, "Measure")->click();
  return QTest::qWaitFor([&] { return page.report() != nullptr; }, kAnswersWithinMs);
}

TEST(AuditPage, shows_what_each_choice_costs_and_uses_the_leanest_with_one_step_of_undo) {
  EditorModel model(draft());
  AuditPage page(model, at_once);
  page.show();
  EXPECT_FALSE(button(page, "Use the leanest")->isVisible());
  button(page, "Measure")->click();
  EXPECT_FALSE(button(page, "Measure")->isEnabled());
  ASSERT_TRUE(QTest::qWaitFor([&] { return page.report() != nullptr; }, kAnswersWithinMs));
  EXPECT_TRUE(button(page, "Measure")->isEnabled());
  const QString all = texts(page);
  EXPECT_TRUE(all.contains(QStringLiteral("Friction left out")));
  EXPECT_TRUE(all.contains(QStringLiteral("not needed")));
  EXPECT_TRUE(all.contains(QStringLiteral("Heat left out")));
  ASSERT_TRUE(button(page, "Use the leanest")->isVisible() && button(page, "Use the leanest")->isEnabled());

  const Scenario before = model.scenario();
  button(page, "Use the leanest")->click();
  EXPECT_EQ(model.scenario(), page.report()->leanest);
  EXPECT_EQ(model.scenario().phenomena, std::vector<std::string>{"heat"});
  EXPECT_DOUBLE_EQ(model.scenario().specimen.voxel_mm, 0.15);
  EXPECT_FALSE(button(page, "Use the leanest")->isEnabled()) << "it is used";
  EXPECT_EQ(model.stack().count(), 1);
  model.stack().undo();
  EXPECT_EQ(model.scenario(), before);
  EXPECT_TRUE(button(page, "Use the leanest")->isEnabled());
}

TEST(AuditPage, lists_what_will_be_measured_before_anything_is) {
  EditorModel model(draft());
  AuditPage page(model, at_once);
  page.show();
  for (const Choice& choice : choices_of(model.scenario())) EXPECT_TRUE(texts(page).contains(choice_name(choice))) << choice_name(choice).toStdString();
  EXPECT_TRUE(texts(page).contains(QStringLiteral("Heat left out")));
  model.set_phenomenon("heat", EditorModel::Listed::no);
  model.end_gesture();
  EXPECT_FALSE(texts(page).contains(QStringLiteral("Heat left out"))) << "the list follows the exercise";
}

TEST(AuditPage, what_was_measured_of_another_exercise_cannot_be_used) {
  EditorModel model(draft());
  AuditPage page(model, at_once);
  ASSERT_TRUE(measure(page));
  model.set_depth_mm(1.7);
  EXPECT_FALSE(button(page, "Use the leanest")->isEnabled());
  EXPECT_TRUE(texts(page).contains(QStringLiteral("changed since")));
}

TEST(AuditPage, what_was_measured_can_be_used_once_it_is_published) {
  EditorModel model(draft());
  AuditPage page(model, at_once);
  ASSERT_TRUE(measure(page));
  model.now_published(model.scenario());
  EXPECT_FALSE(texts(page).contains(QStringLiteral("changed since")));
  ASSERT_TRUE(button(page, "Use the leanest")->isEnabled());
  button(page, "Use the leanest")->click();
  EXPECT_EQ(model.scenario().phenomena, std::vector<std::string>{"heat"});
}

TEST(AuditText, names_why_half_the_voxels_do_not_hold) {
  AuditReport report;
  report.scenario = report.leanest = draft().draft;
  report.tolerance_points = 2;
  GradeChange& half = report.at_half_voxel.emplace();
  half.score = 0.4;
  half.passes_alike = false;
  EXPECT_EQ(leanest_sentence(report), QStringLiteral("Half the voxels change whether an attempt passes, or a critical event."));
  half.passes_alike = true;
  half.score = 3;
  EXPECT_EQ(leanest_sentence(report), QStringLiteral("Half the voxels change a score by 3.0 points, more than the 2 that the exercise allows."));
  report.leanest.phenomena = {"heat"};
  EXPECT_TRUE(leanest_sentence(report).contains(QStringLiteral("Half the voxels"))) << "a leaner model in voxels that do not hold";
}

TEST(AuditPage, names_the_rest_by_what_the_share_took) {
  const QChar space(0x00A0);
  EXPECT_EQ(share_and_rest(0.02, 30), QStringLiteral("2%1%").arg(space)) << "too little has run";
  EXPECT_EQ(share_and_rest(0.3, 2), QStringLiteral("30%1%").arg(space));
  EXPECT_EQ(share_and_rest(0.25, 60), QStringLiteral("25%1%, about 3 min left").arg(space));
  EXPECT_EQ(share_and_rest(0.9, 60), QStringLiteral("90%1%, less than a minute left").arg(space));
}

TEST(AuditPage, an_audit_that_is_stopped_leaves_the_page_as_it_was) {
  EditorModel model(draft());
  std::atomic<bool> began{false}, ended{false};
  AuditPage page(model, [&](const std::string&) -> AuditRunner {
    return [&](const AuditRun&, const AuditWatch& watch) -> Result<std::vector<std::optional<ModelResult>>, AuditFailure> {
      began = true;
      while (watch(0.1)) std::this_thread::yield();
      ended = true;
      return fail(AuditError::cancelled, {});
    };
  });
  page.show();
  button(page, "Measure")->click();
  ASSERT_TRUE(QTest::qWaitFor([&] { return began.load(); }, kAnswersWithinMs));
  auto* busy = page.findChild<Busy*>();
  ASSERT_NE(busy, nullptr);
  Q_EMIT busy->cancelled();
  EXPECT_TRUE(button(page, "Measure")->isEnabled());
  ASSERT_TRUE(QTest::qWaitFor([&] { return ended.load(); }, kAnswersWithinMs));
  EXPECT_EQ(page.report(), nullptr);
  EXPECT_FALSE(button(page, "Use the leanest")->isVisible());
}

TEST(AuditPage, a_measurement_that_is_stopped_leaves_the_report_before_to_the_exercise_that_it_measured) {
  EditorModel model(draft());
  bool waits = false;
  AuditPage page(model, [&](const std::string& folder) -> AuditRunner {
    if (!waits) return at_once(folder);
    return [](const AuditRun&, const AuditWatch& watch) -> Result<std::vector<std::optional<ModelResult>>, AuditFailure> {
      while (watch(0.1)) std::this_thread::yield();
      return fail(AuditError::cancelled, {});
    };
  });
  ASSERT_TRUE(measure(page));
  ASSERT_TRUE(button(page, "Use the leanest")->isEnabled());
  model.set_depth_mm(1.7);
  model.end_gesture();
  waits = true;
  button(page, "Measure")->click();
  EXPECT_FALSE(button(page, "Use the leanest")->isEnabled());
  auto* busy = page.findChild<Busy*>();
  ASSERT_NE(busy, nullptr);
  Q_EMIT busy->cancelled();
  EXPECT_FALSE(button(page, "Use the leanest")->isEnabled()) << "it would set the tooth of another exercise";
  EXPECT_TRUE(texts(page).contains(QStringLiteral("changed since")));
}

TEST(AuditPage, an_exercise_that_cannot_be_played_is_reported) {
  EditorModel model(draft());
  AuditPage page(model, [](const std::string&) -> AuditRunner {
    return [](const AuditRun&, const AuditWatch&) -> Result<std::vector<std::optional<ModelResult>>, AuditFailure> {
      return fail(AuditError::unplayable, "scene");
    };
  });
  page.show();
  button(page, "Measure")->click();
  ASSERT_TRUE(QTest::qWaitFor([&] { return button(page, "Measure")->isEnabled(); }, kAnswersWithinMs));
  EXPECT_TRUE(texts(page).contains(QStringLiteral("cannot be played")));
}

}  // namespace
}  // namespace cusp::test
