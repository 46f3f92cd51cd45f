// The landmarks of a tooth from a file: edits of the model, handles, names.

#include <gtest/gtest.h>

#include <QComboBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <algorithm>
#include <filesystem>
#include <functional>
#include <limits>

#include "scenarios/import/nrrd.h"
#include "tests/ui/editor/class_one.h"
#include "tests/ui/editor/some_landmarks.h"
#include "ui/editor/landmark_handles.h"
#include "ui/editor/landmark_names.h"
#include "ui/editor/landmarks_form.h"
#include "ui/editor/specimen_form.h"
#include "ui/widgets/parts.h"

namespace cusp::test {
namespace {

/// class-1-36 on a tooth from a file of 12 mm about the origin.
struct MarkedTooth : ::testing::Test {
  static EditorStart start() {
    EditorStart out = class_one();
    SpecimenSource source;
    source.volume = "tooth.nrrd";
    source.voxel_mm = out.draft.specimen.voxel_mm;
    source.landmarks = some_landmarks();
    out.draft.specimen = source;
    return out;
  }
  EditorModel model{start()};
  const Scenario before = model.scenario();
  void SetUp() override { model.set_facts(SpecimenFacts{Vec3(-6, -6, -14), Vec3(6, 6, 8), before.specimen.voxel_mm, {}}); }
  const Landmark& mark(std::size_t i) const { return model.landmarks().marks[i]; }
};

TEST_F(MarkedTooth, a_moved_landmark_is_set_and_undo_restores_the_exercise) {
  ASSERT_TRUE(model.move_landmark({1, 0}, {2.1, 2, 7}));
  EXPECT_EQ(mark(1).points_mm.front(), Vec3(2.1, 2, 7));
  EXPECT_EQ(mark(1).state, MarkState::set);
  EXPECT_EQ(mark(2), before.specimen.landmarks.marks[2]);
  model.stack().undo();
  EXPECT_TRUE(model.scenario() == before);
  model.stack().redo();
  EXPECT_EQ(mark(1).state, MarkState::set);
}

TEST_F(MarkedTooth, one_drag_of_a_landmark_is_one_step) {
  for (int i = 1; i <= 5; ++i) ASSERT_TRUE(model.move_landmark({0, 1}, {0.1 * i, 0, 6}));
  EXPECT_EQ(model.stack().count(), 1);
  model.end_gesture();
  ASSERT_TRUE(model.move_landmark({0, 1}, {0, 0, 6}));
  EXPECT_EQ(model.stack().count(), 2);
}

TEST_F(MarkedTooth, a_place_beside_the_tooth_and_no_number_are_refused) {
  for (const Vec3 bad : {Vec3(9, 0, 0), Vec3(0, 0, -40), Vec3(std::numeric_limits<double>::quiet_NaN(), 0, 0)}) {
    EXPECT_FALSE(model.move_landmark({1, 0}, bad));
    EXPECT_TRUE(model.scenario() == before);
  }
  EXPECT_FALSE(model.move_landmark({1, 1}, {0, 0, 0})) << "a tip has one point";
  EXPECT_FALSE(model.move_landmark({9, 0}, {0, 0, 0}));
  EXPECT_FALSE(model.accept_landmark(9));
  EXPECT_FALSE(model.remove_landmark(9));
  EXPECT_EQ(model.stack().count(), 0);
}

TEST_F(MarkedTooth, accepting_leaves_each_place_and_all_are_one_step) {
  ASSERT_TRUE(model.accept_landmark(2));
  EXPECT_EQ(mark(2).state, MarkState::set);
  EXPECT_EQ(mark(1).state, MarkState::proposed);
  ASSERT_TRUE(model.accept_landmarks());
  for (std::size_t i = 0; i < model.landmarks().marks.size(); ++i) {
    EXPECT_EQ(mark(i).state, MarkState::set);
    EXPECT_EQ(mark(i).points_mm, before.specimen.landmarks.marks[i].points_mm);
  }
  EXPECT_EQ(model.stack().count(), 2);
  model.stack().undo();
  model.stack().undo();
  EXPECT_TRUE(model.scenario() == before);
}

TEST_F(MarkedTooth, a_removed_landmark_is_gone_and_undo_brings_it_back) {
  model.choose_landmark({3, 2});
  ASSERT_TRUE(model.remove_landmark(3));
  EXPECT_EQ(model.landmarks().find(MarkKind::cej), nullptr);
  EXPECT_EQ(model.landmark(), (MarkPoint{2, 0})) << "the chosen one stays within the list";
  model.stack().undo();
  EXPECT_TRUE(model.scenario() == before);
}

TEST_F(MarkedTooth, a_closed_line_stays_closed) {
  EXPECT_EQ(movable_points(mark(3)), 3u);
  ASSERT_TRUE(model.move_landmark({3, 0}, {4.2, 0, 0.1}));
  EXPECT_EQ(mark(3).points_mm.front(), mark(3).points_mm.back());
  EXPECT_FALSE(model.move_landmark({3, 3}, {4, 0, 0}));
}

TEST_F(MarkedTooth, other_landmarks_make_no_other_specimen) {
  QSignalSpy grows(&model, &EditorModel::specimen_changed);
  ASSERT_TRUE(model.move_landmark({1, 0}, {2.1, 2, 7}));
  ASSERT_TRUE(model.accept_landmarks());
  EXPECT_EQ(grows.count(), 0);
  EXPECT_TRUE(model.facts().has_value());
}

TEST_F(MarkedTooth, what_is_set_stays_when_landmarks_are_proposed_anew_for_the_same_number) {
  ASSERT_TRUE(model.move_landmark({1, 0}, {2.1, 2, 7}));
  SpecimenLandmarks anew = some_landmarks();
  anew.marks.erase(anew.marks.begin());
  ASSERT_TRUE(model.take_proposed(anew));
  ASSERT_EQ(model.landmarks().marks.size(), 3u);
  const Landmark* tip = model.landmarks().find(MarkKind::cusp_tip, "MB");
  ASSERT_NE(tip, nullptr);
  EXPECT_EQ(tip->state, MarkState::set);
  EXPECT_EQ(tip->points_mm.front(), Vec3(2.1, 2, 7));
  anew.fdi = 46;
  ASSERT_TRUE(model.take_proposed(anew));
  EXPECT_EQ(model.landmarks().find(MarkKind::cusp_tip, "MB")->state, MarkState::proposed) << "of another tooth nothing stays";
}

TEST(Landmarks, of_a_grown_tooth_are_not_edited) {
  EditorModel model(class_one());
  EXPECT_FALSE(model.takes_landmarks());
  EXPECT_FALSE(model.take_proposed(some_landmarks()));
  EXPECT_FALSE(model.accept_landmarks());
  EXPECT_TRUE(model.landmarks().empty());
  EXPECT_EQ(model.stack().count(), 0);
}

TEST(Landmarks, are_proposed_for_the_tooth_that_the_exercise_moves_from) {
  EditorStart start = class_one();
  start.draft.specimen.fdi = 46;
  EditorModel model(start);
  const LandmarksForm form(model);
  SpecimenSource file;
  file.volume = "tooth.nrrd";
  file.voxel_mm = start.draft.specimen.voxel_mm;
  ASSERT_TRUE(model.set_specimen(file, start.draft.tissues));
  EXPECT_EQ(form.findChild<QComboBox*>()->currentData().toInt(), 46);
}

TEST(Landmarks, go_with_the_file_that_they_are_of) {
  EditorModel model(MarkedTooth::start());
  SpecimenSource grown = class_one().draft.specimen;
  grown.landmarks = some_landmarks();
  ASSERT_TRUE(model.set_specimen(grown, class_one().draft.tissues));
  EXPECT_TRUE(model.landmarks().empty());
}

TEST(LandmarkHandles, stand_at_places_and_ends_of_axes_and_at_the_chosen_point_of_a_line) {
  const SpecimenLandmarks marks = some_landmarks();
  EXPECT_EQ(handles_of_landmarks(marks, {1, 0}).size(), 4u);  // two ends, two tips
  const auto handles = handles_of_landmarks(marks, {3, 2});
  ASSERT_EQ(handles.size(), 5u);
  EXPECT_EQ(handles.back().at_mm, marks.marks[3].points_mm[2]);
  EXPECT_EQ(handles.back().path, 3u);
  for (const TargetHandle& handle : handles) EXPECT_TRUE(handle.is_place() && handle.is_round());
}

TEST(LandmarkHandles, lines_are_dashed_while_proposed) {
  SpecimenLandmarks marks = some_landmarks();
  marks.marks[3].state = MarkState::set;
  const auto lines = landmark_lines(marks);
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_GT(lines[0].style.dash_mm, 0.0f);
  EXPECT_EQ(lines[1].style.dash_mm, 0.0f);
}

TEST(LandmarkNames, say_kind_and_which) {
  const auto marks = some_landmarks().marks;
  EXPECT_EQ(landmark_name(marks[0]), QStringLiteral("Long axis"));
  EXPECT_EQ(landmark_name(marks[1]), QStringLiteral("Cusp tip, MB"));
  EXPECT_EQ(landmark_name({MarkKind::marginal_ridge, "distal marginal", {}, MarkState::set}), QStringLiteral("Marginal ridge, distal"));
  EXPECT_EQ(landmark_name({MarkKind::fissure, "supplementary 2", {}, MarkState::set}), QStringLiteral("Fissure, supplementary 2"));
  EXPECT_EQ(landmark_point_name(marks[0], 1), QStringLiteral("Occlusal end"));
  EXPECT_TRUE(landmark_point_name(marks[1], 0).isEmpty());
}

/// 4.4 mm wide: the two tips of some_landmarks() lie on it, the junction does not.
VoxelVolume narrow_crown() {
  VoxelVolume out(Grid{IVec3(30, 30, 44), 0.2, Vec3(-2.9, -2.9, -0.9)});
  for (int z = 4; z < 40; ++z)
    for (int y = 4; y < 26; ++y)
      for (int x = 4; x < 26; ++x) {
        out.s[out.grid.index({x, y, z})] = kSolid;
        out.tissue[out.grid.index({x, y, z})] = Tissue::enamel;
      }
  return out;
}

TEST(AnotherVolume, of_the_same_tooth_has_the_landmarks_that_lie_on_it_if_the_author_keeps_them) {
  const QTemporaryDir folder;
  const QString file = folder.filePath(QStringLiteral("better.nrrd"));
  ASSERT_TRUE(write_nrrd(narrow_crown(), file.toStdString()));
  for (const bool keeps : {true, false}) {
    EditorStart start = MarkedTooth::start();
    start.folder = folder.filePath(keeps ? QStringLiteral("kept") : QStringLiteral("left")).toStdString();
    EditorModel model(start);
    QStringList asked;
    Ports ports;
    ports.pick_file = [&](QWidget*, const FileWish&, const std::function<void(const QString&)>& then) { then(file); };
    ports.ask = [&](QWidget*, const Question& question, const std::function<void(bool)>& then) {
      asked << question.more;
      then(keeps);
    };
    SpecimenForm form(model, ports);
    for (QPushButton* button : form.findChildren<QPushButton*>())
      if (button->accessibleName() == QStringLiteral("Choose a volume…")) button->click();
    ASSERT_EQ(model.scenario().specimen.volume, "better.nrrd");
    ASSERT_EQ(asked.size(), 1);
    EXPECT_TRUE(asked.front().startsWith(QStringLiteral("3 of 4 "))) << asked.front().toStdString();
    SpecimenLandmarks on_it = some_landmarks();
    on_it.marks.pop_back();
    EXPECT_EQ(model.landmarks(), keeps ? on_it : SpecimenLandmarks{});
    EXPECT_EQ(model.stack().count(), 1);
    model.stack().undo();
    EXPECT_EQ(model.landmarks(), some_landmarks());
  }
}

TEST(AnotherVolume, with_a_tissue_that_would_count_as_a_neighbour_is_refused) {
  const QTemporaryDir folder;
  const QString file = folder.filePath(QStringLiteral("labels.nrrd"));
  VoxelVolume labels = narrow_crown();
  std::ranges::replace(labels.tissue, Tissue::enamel, Tissue{29});
  ASSERT_TRUE(write_nrrd(labels, file.toStdString()));
  EditorStart start = MarkedTooth::start();
  start.folder = folder.filePath(QStringLiteral("draft")).toStdString();
  EditorModel model(start);
  Ports ports;
  ports.pick_file = [&](QWidget*, const FileWish&, const std::function<void(const QString&)>& then) { then(file); };
  SpecimenForm form(model, ports);
  for (QPushButton* button : form.findChildren<QPushButton*>())
    if (button->accessibleName() == QStringLiteral("Choose a volume…")) button->click();
  EXPECT_EQ(model.stack().count(), 0);
  EXPECT_TRUE(form.findChild<Band*>()->text().contains(QStringLiteral("labels.nrrd"))) << form.findChild<Band*>()->text().toStdString();
  EXPECT_FALSE(std::filesystem::exists(start.folder)) << "nothing is copied";
}

}  // namespace
}  // namespace cusp::test
