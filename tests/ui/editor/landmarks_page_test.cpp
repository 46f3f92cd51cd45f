// The landmarks of a tooth from a file on the editor's page: their form, and their handles in the view.

#include <QComboBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QThreadPool>
#include <QTreeWidget>
#include <algorithm>
#include <filesystem>

#include "scenarios/import/nrrd.h"
#include "scenarios/specimens/specimens.h"
#include "tests/ui/editor/editor_pages.h"
#include "tests/ui/editor/some_landmarks.h"
#include "tests/ui/looks.h"
#include "ui/editor/form_parts.h"
#include "ui/editor/landmark_names.h"
#include "ui/editor/landmarks_form.h"
#include "ui/view/tooth_view.h"
#include "ui/widgets/busy.h"
#include "ui/widgets/parts.h"

namespace cusp::test {
namespace {

/// The average tooth 36, grown once.
const VoxelVolume& voxels_of_36() {
  static const VoxelVolume volume = [] {
    SpecimenSource source;
    source.generator = "tooth";
    source.fdi = 36;
    source.voxel_mm = 0.2;
    return *make_specimen(source, {});
  }();
  return volume;
}

constexpr int kRestMs = 400;  // from one picture of the tooth to the next, if another comes

struct LandmarksOnThePage : EditorPages {
  EditorStart of_file(const VoxelVolume& volume) const {
    EditorStart start = coarse();
    std::filesystem::create_directories(start.folder);
    EXPECT_TRUE(write_nrrd(volume, std::filesystem::path(start.folder) / "tooth.nrrd").has_value());
    SpecimenSource source;
    source.volume = "tooth.nrrd";
    source.voxel_mm = volume.grid.voxel_mm;
    start.draft.specimen = source;
    start.draft.tissues = usual_tissues(facts_of(volume).tissues);
    return start;
  }
  /// The page with the form of the tooth open, once the tooth stands in the view.
  std::unique_ptr<EditorPage> open_form(const EditorStart& start) {
    auto page = open(start);
    QSignalSpy shown(page->stage()->view(), &ToothView::feed_shown);
    const QString name = EditorPage::tr("Change the tooth");
    for (QPushButton* button : page->findChildren<QPushButton*>())
      if (button->accessibleName() == name) button->click();
    EXPECT_TRUE(QTest::qWaitFor([&] { return !page->stage()->view()->store().empty(); }, kGrowsWithinMs));
    while (shown.wait(kRestMs)) continue;
    return page;
  }
  std::unique_ptr<EditorPage> open_marked() {
    EditorStart start = of_file(voxels_of_36());
    start.draft.specimen.landmarks = some_landmarks();
    return open_form(start);
  }
  static QTreeWidget* list_of(EditorPage& page) { return named<QTreeWidget>(page, "Landmarks"); }
  static HandleKnob* knob_of(const EditorPage& page, const char* name) {
    for (HandleKnob* knob : page.stage()->findChildren<HandleKnob*>())
      if (!knob->isHidden() && knob->accessibleName() == QLatin1String(name)) return knob;
    return nullptr;
  }
  static const SpecimenLandmarks& landmarks_of(EditorPage& page) { return page.model().landmarks(); }
  static QString message_of(EditorPage& page) { return page.findChild<LandmarksForm*>()->findChild<Band*>()->text(); }
};

TEST_F(LandmarksOnThePage, are_proposed_listed_and_shown_on_the_tooth) {
  const auto page = open_form(of_file(voxels_of_36()));
  QTreeWidget* list = list_of(*page);
  ASSERT_NE(list, nullptr);
  EXPECT_FALSE(list->isVisible());
  auto* tooth = named<QComboBox>(*page, "Number of the tooth");
  ASSERT_NE(tooth, nullptr);
  tooth->setCurrentIndex(tooth->findData(36));
  const Scenario before = page->model().scenario();
  named<QPushButton>(*page, "Propose landmarks")->click();
  EXPECT_FALSE(named<QPushButton>(*page, "Propose landmarks")->isEnabled());
  ASSERT_TRUE(QTest::qWaitFor([&] { return !landmarks_of(*page).marks.empty(); }, kGrowsWithinMs));
  EXPECT_EQ(landmarks_of(*page).fdi, 36);
  EXPECT_TRUE(list->isVisible());
  ASSERT_EQ(list->topLevelItemCount(), static_cast<int>(landmarks_of(*page).marks.size()));
  for (int row = 0; row < list->topLevelItemCount(); ++row) {
    EXPECT_EQ(list->topLevelItem(row)->text(0), landmark_name(landmarks_of(*page).marks[static_cast<std::size_t>(row)]));
    EXPECT_EQ(list->topLevelItem(row)->data(1, Qt::AccessibleTextRole).toString(), QStringLiteral("proposed"));
  }
  EXPECT_NE(knob_of(*page, "Cusp tip, MB"), nullptr);
  EXPECT_TRUE(page->grown()) << "the tooth does not grow anew";
  page->model().stack().undo();
  EXPECT_TRUE(page->model().scenario() == before);
  EXPECT_FALSE(list->isVisible());
}

TEST_F(LandmarksOnThePage, a_volume_without_a_tooth_gets_a_message_and_no_landmarks) {
  VoxelVolume block(Grid{IVec3(60, 50, 40), 0.2, Vec3(-5, -5, -4)});
  for (int z = 4; z < 36; ++z)
    for (int y = 4; y < 46; ++y)
      for (int x = 4; x < 46; ++x) {
        block.s[block.grid.index({x, y, z})] = kSolid;
        block.tissue[block.grid.index({x, y, z})] = Tissue::plastic;
      }
  const auto page = open_form(of_file(block));
  named<QPushButton>(*page, "Propose landmarks")->click();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !message_of(*page).isEmpty(); }, kGrowsWithinMs));
  EXPECT_TRUE(message_of(*page).contains(QStringLiteral("No landmark can be proposed."))) << message_of(*page).toStdString();
  EXPECT_TRUE(landmarks_of(*page).empty());
  EXPECT_TRUE(named<QPushButton>(*page, "Propose landmarks")->isEnabled());
}

TEST_F(LandmarksOnThePage, a_search_that_is_cancelled_changes_nothing) {
  const auto page = open_form(of_file(voxels_of_36()));
  const Scenario before = page->model().scenario();
  named<QPushButton>(*page, "Propose landmarks")->click();
  Q_EMIT page->findChild<LandmarksForm*>()->findChild<Busy*>()->cancelled();
  EXPECT_TRUE(named<QPushButton>(*page, "Propose landmarks")->isEnabled());
  ASSERT_TRUE(QThreadPool::globalInstance()->waitForDone(kGrowsWithinMs));
  QCoreApplication::processEvents();
  EXPECT_TRUE(page->model().scenario() == before);
}

TEST_F(LandmarksOnThePage, a_page_that_closes_ends_the_search) {
  auto page = open_form(of_file(voxels_of_36()));
  named<QPushButton>(*page, "Propose landmarks")->click();
  page.reset();
  ASSERT_TRUE(QThreadPool::globalInstance()->waitForDone(kGrowsWithinMs));
  QCoreApplication::processEvents();  // what the pool has posted finds nobody
}

TEST_F(LandmarksOnThePage, a_drag_moves_a_tip_along_the_tooth_as_one_step) {
  const auto page = open_marked();
  page->model().choose_landmark({1, 0});
  HandleKnob* knob = knob_of(*page, "Cusp tip, MB");
  ASSERT_NE(knob, nullptr);
  const Scenario before = page->model().scenario();
  const QPoint middle = knob->rect().center(), start = knob->pos();
  QTest::mousePress(knob, Qt::LeftButton, {}, middle);
  for (int i = 1; i <= 3; ++i) QTest::mouseMove(knob, middle + QPoint(8, 3));
  QTest::mouseRelease(knob, Qt::LeftButton, {}, knob->rect().center());
  const Landmark& tip = landmarks_of(*page).marks[1];
  EXPECT_EQ(tip.state, MarkState::set);
  EXPECT_NE(tip.points_mm, before.specimen.landmarks.marks[1].points_mm);
  EXPECT_GT((knob->pos() - start).x(), 5);
  EXPECT_EQ(page->model().stack().count(), 1);
  const auto under = page->stage()->view()->pick(*page->stage()->view()->project(tip.points_mm.front()));
  ASSERT_TRUE(under.has_value());
  EXPECT_LT(glm::length(under->at_mm - tip.points_mm.front()), 0.05) << "it lies on the surface, to a step of 0.01 mm";
  page->model().stack().undo();
  EXPECT_TRUE(page->model().scenario() == before);
}

TEST_F(LandmarksOnThePage, an_arrow_key_moves_the_end_of_an_axis_and_delete_removes_it) {
  const auto page = open_marked();
  HandleKnob* knob = knob_of(*page, "Long axis: Occlusal end");
  ASSERT_NE(knob, nullptr);
  QTest::keyClick(knob, Qt::Key_Right);
  const Landmark axis = landmarks_of(*page).marks[0];
  EXPECT_EQ(axis.state, MarkState::set);
  EXPECT_NEAR(glm::length(axis.points_mm[1] - Vec3(0, 0, 6)), 0.05, 1e-9);
  EXPECT_EQ(axis.points_mm[0], Vec3(0, 0, -8));
  QTest::keyClick(knob, Qt::Key_Left);
  EXPECT_NEAR(glm::length(landmarks_of(*page).marks[0].points_mm[1] - Vec3(0, 0, 6)), 0.0, 1e-9);
  EXPECT_TRUE(knob->accessibleDescription().contains(QStringLiteral("set"))) << knob->accessibleDescription().toStdString();
  QTest::keyClick(knob, Qt::Key_Delete);
  EXPECT_EQ(landmarks_of(*page).find(MarkKind::long_axis), nullptr);
}

TEST_F(LandmarksOnThePage, a_number_moves_the_chosen_one_and_one_beside_the_tooth_shows_why_not) {
  const auto page = open_marked();
  list_of(*page)->setCurrentItem(list_of(*page)->topLevelItem(2));
  EXPECT_EQ(page->model().landmark(), (MarkPoint{2, 0}));
  auto* height = named<NumberBox>(*page, "Landmark: Height");
  ASSERT_NE(height, nullptr);
  EXPECT_DOUBLE_EQ(height->value(), 6.5);
  height->setValue(6.4);
  EXPECT_EQ(landmarks_of(*page).marks[2].points_mm.front(), Vec3(-2, -2, 6.4));
  EXPECT_EQ(list_of(*page)->topLevelItem(2)->data(1, Qt::AccessibleTextRole).toString(), QStringLiteral("set"));
  const Scenario before = page->model().scenario();
  height->setValue(80);
  EXPECT_TRUE(page->model().scenario() == before);
  EXPECT_DOUBLE_EQ(height->value(), 6.4);
  EXPECT_FALSE(height->message().isEmpty());
}

TEST_F(LandmarksOnThePage, are_accepted_one_by_one_or_all_and_removed) {
  const auto page = open_marked();
  list_of(*page)->setCurrentItem(list_of(*page)->topLevelItem(1));
  auto* accept = named<QPushButton>(*page, "Accept");
  auto* all = named<QPushButton>(*page, "Accept all");
  accept->click();
  EXPECT_EQ(landmarks_of(*page).marks[1].state, MarkState::set);
  EXPECT_FALSE(accept->isEnabled());
  EXPECT_TRUE(all->isEnabled());
  all->click();
  EXPECT_FALSE(all->isEnabled());
  EXPECT_EQ(std::ranges::count(landmarks_of(*page).marks, MarkState::set, &Landmark::state), 4);
  named<QPushButton>(*page, "Remove the landmark")->click();
  ASSERT_EQ(list_of(*page)->topLevelItemCount(), 3);
  EXPECT_EQ(list_of(*page)->topLevelItem(1)->text(0), QStringLiteral("Cusp tip, DL"));
}

TEST_F(LandmarksOnThePage, a_grown_tooth_has_no_form_of_them) {
  EditorStart start = coarse();
  start.draft = *load_builtin("class-1-36");
  start.draft.specimen.voxel_mm = 0.3;
  start.published = start.draft;
  const auto page = open_form(start);
  const auto* form = page->findChild<LandmarksForm*>();
  ASSERT_NE(form, nullptr);
  EXPECT_FALSE(form->isVisible());
  for (const HandleKnob* knob : knobs_of(*page->stage())) EXPECT_NE(knob->handle().kind, TargetHandle::Kind::landmark);
}

TEST_F(LandmarksOnThePage, the_target_comes_back_when_the_form_closes) {
  const auto page = open_marked();
  for (const HandleKnob* knob : knobs_of(*page->stage())) EXPECT_EQ(knob->handle().kind, TargetHandle::Kind::landmark);
  named<QPushButton>(*page, "Back")->click();
  const auto knobs = knobs_of(*page->stage());
  ASSERT_FALSE(knobs.empty());
  for (const HandleKnob* knob : knobs) EXPECT_NE(knob->handle().kind, TargetHandle::Kind::landmark);
}

TEST_F(LandmarksOnThePage, the_form_fits_its_panel_in_each_look) {
  in_each_look([&](const QString& look) {
    const auto page = open_form([&] {
      EditorStart start = of_file(voxels_of_36());
      start.draft.specimen.landmarks = some_landmarks();
      start.draft.specimen.landmarks.marks[2].state = MarkState::set;
      return start;
    }());
    page->model().choose_landmark({1, 0});
    const auto* form = page->findChild<LandmarksForm*>();
    EXPECT_LT(form->minimumSizeHint().width(), 248 - 24) << look.toStdString();
    expect_buttons_fit(*form, look);
    leave_picture(*page, QStringLiteral("landmarks-") + look);
  });
  install_language(*qApp, QStringLiteral("en"));
  apply_theme(*qApp, ColourScheme::light, 100);
}

}  // namespace
}  // namespace cusp::test
