// The editor's page over real records, without OpenGL: keys, numbers, handles, checks, try-out, publishing.

#include <gtest/gtest.h>

#include <QAccessible>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalSpy>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>

#include "scenarios/burs/bur_catalogue.h"
#include "scenarios/format/write.h"
#include "scenarios/library/library.h"
#include "tests/modules.h"
#include "tests/ui/editor/editor_pages.h"
#include "ui/editor/editor_page.h"
#include "ui/editor/editor_records.h"
#include "ui/editor/handle_knob.h"
#include "ui/editor/specimen_form.h"
#include "ui/editor/target_view.h"
#include "ui/instructor/import_page.h"
#include "ui/instructor/library_page.h"
#include "ui/text/language.h"
#include "ui/view/tooth_view.h"
#include "ui/widgets/number_field.h"
#include "ui/widgets/table.h"

namespace cusp::test {
namespace {

TEST_F(EditorPages, a_number_changes_the_target_and_undo_takes_it_back) {
  const auto page = open();
  auto* depth = named<QDoubleSpinBox>(*page, "Depth");
  ASSERT_NE(depth, nullptr);
  depth->setValue(2.35);
  EXPECT_DOUBLE_EQ(page->model().scenario().target.outline.depth_mm, 2.35);
  auto* publish = named<QPushButton>(*page, "Publish version 4");
  ASSERT_NE(publish, nullptr);
  EXPECT_TRUE(publish->isEnabled());
  page->activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(page.get()));
  depth->setFocus();  // the box's own undo of digits stays out of the way
  QTest::keyClick(depth, Qt::Key_Z, Qt::ControlModifier);
  // A button pressed by its key shows that for a moment before it acts.
  EXPECT_TRUE(QTest::qWaitFor([&] { return !page->model().stack().canUndo(); }));
  EXPECT_DOUBLE_EQ(page->model().scenario().target.outline.depth_mm, 2.0);
  EXPECT_DOUBLE_EQ(depth->value(), 2.0);
  EXPECT_EQ(page->focusWidget(), depth);
  EXPECT_FALSE(publish->isEnabled());
}

TEST_F(EditorPages, a_number_that_cannot_be_taken_leaves_the_target_and_shows_why_at_the_field) {
  const auto page = open();
  auto* depth = named<NumberField>(*page, "Depth");
  ASSERT_NE(depth, nullptr);
  const auto type = [&](const QString& text) {
    depth->selectAll();
    QTest::keyClicks(depth, text);
    QTest::keyClick(depth, Qt::Key_Return);
    return page->model().scenario().target.outline.depth_mm;
  };
  EXPECT_DOUBLE_EQ(type(QStringLiteral("1,5")), 1.5);
  EXPECT_DOUBLE_EQ(type(QStringLiteral("-3")), 1.5);
  EXPECT_TRUE(depth->note()->isVisibleTo(page.get())) << "below its row";
  EXPECT_DOUBLE_EQ(type(QStringLiteral("1e9")), 1.5);
  EXPECT_TRUE(depth->message().contains(QStringLiteral("1e9")));
  page->model().stack().undo();
  EXPECT_TRUE(depth->message().isEmpty()) << "another value stands there now";
}

TEST_F(EditorPages, a_shape_chosen_in_the_library_is_taken_however_it_was_pressed) {
  const auto page = open();
  named<QPushButton>(*page, "Box")->setChecked(true);  // as a screen reader presses it
  EXPECT_EQ(page->model().scenario().target.outline.shape, "box");
  EXPECT_EQ(knobs_of(*page->stage()).size(), 4u);
  page->model().stack().undo();
  EXPECT_TRUE(named<QPushButton>(*page, "Channel")->isChecked());
  EXPECT_EQ(page->model().stack().count(), 1);
}

TEST_F(EditorPages, every_handle_has_a_name_and_answers_to_the_arrow_keys) {
  const auto page = open();
  const auto knobs = knobs_of(*page->stage());
  ASSERT_EQ(knobs.size(), 4u);
  for (HandleKnob* knob : knobs) {
    EXPECT_FALSE(knob->accessibleName().isEmpty());
    EXPECT_FALSE(knob->accessibleDescription().isEmpty());
    EXPECT_GE(knob->width(), 12);
  }
  HandleKnob* depth = knobs.back();
  EXPECT_EQ(depth->accessibleName().toStdString(), "Depth");
  QTest::keyClick(depth, Qt::Key_Down);
  EXPECT_DOUBLE_EQ(page->model().scenario().target.outline.depth_mm, 2.05);
  QTest::keyClick(depth, Qt::Key_Up, Qt::ShiftModifier);
  EXPECT_DOUBLE_EQ(page->model().scenario().target.outline.depth_mm, 2.04);
  EXPECT_EQ(page->model().stack().count(), 2);
  QTest::keyClick(knobs[2], Qt::Key_Right);
  EXPECT_DOUBLE_EQ(page->model().scenario().target.outline.width_mm, 1.65);
  // And to a screen reader's actions, the same step each.
  const auto act = [](HandleKnob* knob, const QString& name) {
    QAccessible::queryAccessibleInterface(knob)->actionInterface()->doAction(name);
  };
  act(depth, QAccessibleActionInterface::increaseAction());
  EXPECT_DOUBLE_EQ(page->model().scenario().target.outline.depth_mm, 2.09);
  act(knobs[2], QAccessibleActionInterface::decreaseAction());
  EXPECT_DOUBLE_EQ(page->model().scenario().target.outline.width_mm, 1.6);
}

TEST_F(EditorPages, dragging_a_handle_is_one_step_and_follows_the_hand) {
  const auto page = open();
  TargetView* stage = page->stage();
  HandleKnob* end = knobs_of(*stage)[0];
  const Vec3 before = end->handle().at_mm;
  const auto target_px = stage->view()->project(before + Vec3(0.5, 0.3, 0));
  ASSERT_TRUE(target_px.has_value());
  const QPoint middle(end->width() / 2, end->height() / 2);
  QTest::mousePress(end, Qt::LeftButton, {}, middle);
  for (int i = 1; i <= 4; ++i) {
    // The handle moves along: the hand is where it is on the stage.
    const QPointF from = *stage->view()->project(before);
    const QPointF at = from + (*target_px - from) * i / 4.0;
    const QPointF local = at - QPointF(end->pos());
    QMouseEvent move(QEvent::MouseMove, local, end->mapToGlobal(local), Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(end, &move);
  }
  QTest::mouseRelease(end, Qt::LeftButton, {}, middle);
  const Vec3 after = page->model().scenario().target.outline.paths[0][0];
  // A pixel is about 0.03 mm here, and the press lies within one of the handle's middle.
  EXPECT_NEAR(after.x, before.x + 0.5, 0.06);
  EXPECT_NEAR(after.y, before.y + 0.3, 0.06);
  EXPECT_EQ(page->model().stack().count(), 1);
  page->model().stack().undo();
  EXPECT_TRUE(page->model().unchanged());
}

TEST_F(EditorPages, a_reader_meets_a_handle_as_something_that_slides_and_has_a_value) {
  const auto page = open();
  QAccessibleInterface* depth = QAccessible::queryAccessibleInterface(knobs_of(*page->stage()).back());
  ASSERT_NE(depth, nullptr);
  EXPECT_EQ(depth->role(), QAccessible::Slider);
  EXPECT_EQ(depth->text(QAccessible::Name).toStdString(), "Depth");
  EXPECT_TRUE(depth->text(QAccessible::Value).contains(QStringLiteral("2.00")));
}

TEST_F(EditorPages, publish_and_try_out_are_off_while_a_check_fails_and_the_reason_is_shown) {
  const auto page = open();
  named<QDoubleSpinBox>(*page, "Measured from height")->setValue(5);
  EXPECT_FALSE(named<QPushButton>(*page, "Publish version 4")->isEnabled());
  EXPECT_FALSE(named<QPushButton>(*page, "Try out")->isEnabled());
  bool shown = false;
  for (QLabel* label : page->findChildren<QLabel*>()) shown = shown || label->text().startsWith(QStringLiteral("The target reaches out"));
  EXPECT_TRUE(shown);
}

TEST_F(EditorPages, a_try_out_is_of_the_draft_is_kept_nowhere_and_leaves_everything_as_it_was) {
  const auto page = open();
  page->model().set_depth_mm(2.2);
  const Scenario draft = page->model().scenario();
  QSignalSpy wanted(page.get(), &EditorPage::try_out_wanted);
  named<QPushButton>(*page, "Try out")->click();
  ASSERT_EQ(wanted.count(), 1);
  const SessionPlan plan = wanted[0][0].value<SessionPlan>();
  EXPECT_TRUE(plan.scenario == draft);
  EXPECT_TRUE(plan.database.empty());
  EXPECT_EQ(plan.kind, SessionKind::try_out);
  ASSERT_NE(plan.specimen, nullptr);  // the one that stands there: nothing is grown again
  EXPECT_TRUE(page->model().scenario() == draft);
  EXPECT_EQ(page->model().stack().count(), 1);
  EXPECT_TRUE(records.store().scenarios.library()->empty());
}

TEST_F(EditorPages, the_reference_operator_tries_the_draft_out_with_one_click_and_its_report_is_asked_for) {
  const auto page = open();
  page->model().set_depth_mm(1.6);
  const Scenario draft = page->model().scenario();
  EXPECT_FALSE(page->model().tried());
  auto* reference = named<QPushButton>(*page, "Try out by the reference operator");
  ASSERT_NE(reference, nullptr);
  QSignalSpy wanted(page.get(), &EditorPage::result_wanted);
  reference->click();
  EXPECT_FALSE(reference->isEnabled()) << "one at a time";
  ASSERT_TRUE(wanted.wait(kGrowsWithinMs));
  const auto result = wanted[0][0].value<std::shared_ptr<const SessionResult>>();
  EXPECT_TRUE(result->scenario == draft);
  EXPECT_TRUE(result->grade.passed) << result->grade.score;
  EXPECT_TRUE(result->session.is_nil());
  EXPECT_TRUE(page->model().tried());
  EXPECT_TRUE(QTest::qWaitFor([&] { return reference->isEnabled(); }, kGrowsWithinMs));
  EXPECT_TRUE(records.store().scenarios.library()->empty());
}

TEST_F(EditorPages, an_edit_ends_the_reference_operator_for_its_cuts_are_of_the_exercise_before) {
  const auto page = open();
  auto* reference = named<QPushButton>(*page, "Try out by the reference operator");
  QSignalSpy wanted(page.get(), &EditorPage::result_wanted);
  reference->click();
  page->model().set_depth_mm(1.6);
  EXPECT_TRUE(reference->isEnabled());
  reference->click();
  ASSERT_TRUE(wanted.wait(kGrowsWithinMs));
  EXPECT_EQ(wanted[0][0].value<std::shared_ptr<const SessionResult>>()->scenario.target.outline.depth_mm, 1.6);
}

TEST_F(EditorPages, a_try_out_by_hand_ends_the_reference_operator_whose_report_would_cover_it) {
  const auto page = open();
  auto* reference = named<QPushButton>(*page, "Try out by the reference operator");
  reference->click();
  ASSERT_FALSE(reference->isEnabled());
  named<QPushButton>(*page, "Try out")->click();
  EXPECT_TRUE(reference->isEnabled());
}

TEST_F(EditorPages, leaving_keeps_the_draft_and_publishing_takes_it_away) {
  auto page = open();
  QSignalSpy back(page.get(), &EditorPage::back_wanted);
  page->model().set_depth_mm(2.2);
  page->leave();
  EXPECT_EQ(back.count(), 1);
  EXPECT_EQ(records.store().scenarios.drafts(instructor.actor())->size(), 1u);
  page->model().now_tried(page->model().scenario());
  named<QPushButton>(*page, "Publish version 4")->click();
  ASSERT_TRUE(QTest::qWaitFor([&] { return sheet_of(*page) != nullptr; }, kGrowsWithinMs));
  EXPECT_FALSE(records.store().scenarios.drafts(instructor.actor())->empty()) << "nothing is published before it is answered";
  ASSERT_TRUE(publish_by_sheet(*page));
  EXPECT_TRUE(records.store().scenarios.drafts(instructor.actor())->empty());
  EXPECT_EQ(records.store().scenarios.library()->size(), 1u);
  EXPECT_NE(named<QPushButton>(*page, "Publish version 5"), nullptr);
}

TEST_F(EditorPages, criteria_and_burs_are_added_and_removed) {
  const auto page = open();
  const std::size_t criteria = page->model().scenario().rubric.criteria.size(), burs = page->model().scenario().instruments.size();
  named<QPushButton>(*page, "Add a criterion")->click();
  EXPECT_EQ(page->model().scenario().rubric.criteria.size(), criteria + 1);
  named<QPushButton>(*page, "Remove Target removed")->click();
  EXPECT_EQ(page->model().scenario().rubric.criteria.size(), criteria);
  named<QPushButton>(*page, "Add a bur")->click();
  EXPECT_EQ(page->model().scenario().instruments.size(), burs + 1);
  QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);  // the rows before
  auto* diameter = named<QDoubleSpinBox>(*page, "Diameter of bur 2");
  diameter->setValue(1.1);
  EXPECT_EQ(diameter->accessibleName(), QStringLiteral("Diameter of bur Ø 1.1")) << "the field stays, in focus";
  EXPECT_FALSE(diameter->isHidden());
  const auto& left = page->model().scenario().instruments;
  EXPECT_EQ(std::ranges::count(left, std::string("Ø 1.1"), &Bur::name), 1);
  EXPECT_FALSE(named<QCheckBox>(*page, "Opening the pulp fails the attempt") && named<QCheckBox>(*page, "Opening the pulp fails the attempt")->isEnabled());
}

TEST_F(EditorPages, a_bur_of_another_shape_comes_from_the_catalogue_and_keeps_its_size) {
  const auto page = open();
  auto* shapes = named<QComboBox>(*page, "Shape of the bur to add");
  auto* sizes = named<QComboBox>(*page, "Bur to add");
  ASSERT_NE(shapes, nullptr);
  EXPECT_EQ(static_cast<std::size_t>(shapes->count()), bur_shapes().size());
  shapes->setCurrentIndex(shapes->findText(QStringLiteral("Straight fissure")));
  ASSERT_EQ(sizes->count(), 3);
  sizes->setCurrentIndex(1);
  named<QPushButton>(*page, "Add a bur")->click();
  EXPECT_EQ(page->model().scenario().instruments.back(), catalogue_bur("57")->bur);
  EXPECT_EQ(sizes->count(), 2) << "one of each number";
  EXPECT_EQ(named<QDoubleSpinBox>(*page, "Diameter of bur 57"), nullptr) << "its head has the catalogue's size";
  EXPECT_FALSE(page->model().set_bur_radius_mm(page->model().scenario().instruments.size() - 1, 0.6));
}

TEST_F(EditorPages, carious_lesions_neighbours_and_gums_are_set_at_the_tooth_seen_at_once_and_undone) {
  EditorStart start = coarse();
  start.published = *load_builtin("class-1-36");
  start.published->specimen.voxel_mm = 0.4;
  start.draft = *start.published;
  start.draft.version = start.published->version + 1;
  const auto opened = open(start);
  EditorPage& page = *opened;
  QSignalSpy ready(&page, &EditorPage::ready);
  const auto source = [&]() -> const SpecimenSource& { return page.model().scenario().specimen; };
  named<QPushButton>(page, "Add a carious lesion")->click();
  ASSERT_EQ(source().lesions.size(), 1u);
  EXPECT_EQ(source().lesions[0].site, "central");
  auto* width = named<QDoubleSpinBox>(page, "Width of carious lesion 1");
  ASSERT_NE(width, nullptr);
  width->setValue(2.0);
  EXPECT_DOUBLE_EQ(source().lesions[0].radius_mm, 1.0);
  named<QDoubleSpinBox>(page, "Softness of carious lesion 1")->setValue(60);
  EXPECT_DOUBLE_EQ(source().lesions[0].softness, 0.6);
  for (QCheckBox* box : page.findChildren<QCheckBox*>()) {
    if (box->text() == QStringLiteral("Gums")) box->setChecked(true);
    if (box->text() == QStringLiteral("The rest of the jaw")) box->setChecked(true);
  }
  EXPECT_EQ(source().around, (std::vector<std::string>{"neighbours", "gingiva", "jaw"}));
  EXPECT_FALSE(page.grown());
  ASSERT_TRUE(ready.wait(kGrowsWithinMs));
  EXPECT_EQ(page.grown()->source, source());
  EXPECT_FALSE(has_error(page.model().findings()));
  const auto& there = page.grown()->facts.tissues;
  EXPECT_NE(std::ranges::find(there, Tissue::carious_dentine), there.end());
  EXPECT_NE(std::ranges::find(there, Tissue::gingiva), there.end());
  page.model().stack().setIndex(0);
  EXPECT_TRUE(page.model().unchanged());
  EXPECT_TRUE(QTest::qWaitFor([&] { return named<QDoubleSpinBox>(page, "Width of carious lesion 1") == nullptr; }));
}

TEST_F(EditorPages, no_form_is_wider_than_its_panel) {
  const auto page = open();
  int forms = 0;
  for (const QScrollArea* area : page->findChildren<QScrollArea*>()) {
    if (!area->widget() || area->horizontalScrollBarPolicy() != Qt::ScrollBarAlwaysOff) continue;
    ++forms;
    // 248 px at the left, 304 at the right, each less its line.
    const bool shapes = area->widget()->property("kind") == QStringLiteral("bar_side");
    const int width = shapes ? 248 - 12 : qobject_cast<SpecimenForm*>(area->widget()) ? 248 : 304;  // the shapes beside a scroll bar
    EXPECT_LT(area->widget()->minimumSizeHint().width(), width) << area->widget()->metaObject()->className();
  }
  EXPECT_EQ(forms, 8);
}

TEST_F(EditorPages, every_control_has_a_name) {
  const auto page = open();
  for (QWidget* w : page->findChildren<QWidget*>()) {
    if (!(w->focusPolicy() & Qt::TabFocus) || qobject_cast<QTabWidget*>(w)) continue;
    if (w->window() != page->window() || w->objectName().startsWith(QStringLiteral("qt_"))) continue;  // Qt's own parts
    const auto* button = qobject_cast<QAbstractButton*>(w);
    EXPECT_TRUE(!w->accessibleName().isEmpty() || (button && !button->text().isEmpty()))
        << w->metaObject()->className() << " in " << w->parentWidget()->metaObject()->className();
  }
}

TEST_F(EditorPages, a_file_that_is_no_volume_is_refused_with_a_message) {
  const auto page = open();
  file = folder.filePath(QStringLiteral("broken.nrrd"));
  QFile broken(file);
  ASSERT_TRUE(broken.open(QIODevice::WriteOnly));
  broken.write("not a volume");
  broken.close();
  const Scenario before = page->model().scenario();
  named<QComboBox>(*page, "Kind")->setCurrentIndex(3);
  for (QPushButton* b : page->findChildren<QPushButton*>()) {
    if (b->accessibleName() == QStringLiteral("Choose a volume…")) b->click();
  }
  EXPECT_TRUE(page->model().scenario() == before);
  bool shown = false;
  for (QLabel* label : page->findChildren<QLabel*>()) shown = shown || label->text().contains(QStringLiteral("This file cannot be read"));
  EXPECT_TRUE(shown);
}

TEST_F(EditorPages, the_library_finds_an_exercise_by_name_or_tooth_and_opens_the_first) {
  LibraryPage page(records.store(), instructor.actor(), ports, records.file(), folder.path().toStdString());
  page.show();
  QSignalSpy wanted(&page, &LibraryPage::edit_wanted);
  const auto shown = [&] {
    int count = 0;
    for (int row = 0; row < page.model().rowCount(); ++row) count += page.table()->isRowHidden(row) ? 0 : 1;
    return count;
  };
  page.search()->setText(QStringLiteral("class ii mo,"));
  EXPECT_EQ(shown(), 1);
  QTest::keyClick(page.search(), Qt::Key_Return);
  ASSERT_EQ(wanted.count(), 1);
  EXPECT_EQ(wanted[0][0].value<EditorStart>().draft.key, "class-2-46-mo");
  page.search()->setText(QStringLiteral("no such thing"));
  EXPECT_EQ(shown(), 0);
  QTest::keyClick(page.search(), Qt::Key_Return);
  EXPECT_EQ(wanted.count(), 1);
  page.search()->clear();
  EXPECT_EQ(shown(), page.model().rowCount());
}

TEST_F(EditorPages, a_draft_is_discarded_only_after_asking_and_what_is_published_stays) {
  ASSERT_TRUE(records.store().scenarios.save_draft(instructor.actor(), coarse().draft.id, canonical_json(coarse().draft), {}).has_value());
  bool answer = false;
  ports.ask = [&answer](QWidget*, const Question&, std::function<void(bool)> then) { then(answer); };
  LibraryPage page(records.store(), instructor.actor(), ports, records.file(), folder.path().toStdString());
  page.show();
  int drafted = page.model().rowCount() - 1;
  while (drafted >= 0 && !page.model().row(drafted).draft) --drafted;
  ASSERT_GE(drafted, 0);
  page.table()->choose_row(drafted);
  page.discard_draft();
  EXPECT_EQ(records.store().scenarios.drafts(instructor.actor())->size(), 1u);
  answer = true;
  page.discard_draft();
  EXPECT_TRUE(records.store().scenarios.drafts(instructor.actor())->empty());
  EXPECT_EQ(page.model().rowCount(), static_cast<int>(builtin_scenarios().size()));
}

}  // namespace
}  // namespace cusp::test
