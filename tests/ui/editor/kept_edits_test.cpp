// What an author typed or chose just before the page acts: it is part of the exercise, or a message says why not.

#include <gtest/gtest.h>

#include <QComboBox>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>
#include <algorithm>
#include <filesystem>
#include <thread>

#include "scenarios/format/ranges.h"
#include "scenarios/format/read.h"
#include "scenarios/import/nrrd.h"
#include "scenarios/library/library.h"
#include "scenarios/specimens/specimens.h"
#include "tests/modules.h"
#include "tests/ui/editor/class_one.h"
#include "tests/ui/editor/editor_pages.h"
#include "ui/editor/shape_form.h"
#include "ui/editor/specimen_form.h"
#include "ui/editor/texts_form.h"
#include "ui/editor/tooth_form.h"
#include "ui/session/background_task.h"
#include "ui/widgets/number_field.h"
#include "ui/widgets/parts.h"

namespace cusp::test {
namespace {

/// A depth of 2.4 mm in the field with the focus, without the Return key.
struct TypedNumber : EditorPages {
  std::unique_ptr<EditorPage> page;
  NumberField* depth = nullptr;
  void SetUp() override {
    EditorPages::SetUp();
    page = open();
    page->activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(page.get()));
    depth = named<NumberField>(*page, "Depth");
    ASSERT_NE(depth, nullptr);
    depth->setFocus();
    depth->selectAll();
    QTest::keyClicks(depth, QStringLiteral("2,4"));
    ASSERT_DOUBLE_EQ(depth_mm(page->model().scenario()), 2.0) << "a half-typed number is none";
  }
  static double depth_mm(const Scenario& s) { return s.target.outline.depth_mm; }
  double kept_depth_mm() {
    const auto draft = records.store().scenarios.draft(instructor.actor(), page->model().scenario().id);
    return draft && *draft ? depth_mm(*read_scenario((*draft)->json)) : 0;
  }
};

SpecimenSource small_block() {
  SpecimenSource out;
  out.generator = "block";
  out.voxel_mm = 0.4;
  return out;
}

void press_choose_volume(const EditorPage& page) {
  for (QPushButton* b : page.findChildren<QPushButton*>())
    if (b->accessibleName() == QStringLiteral("Choose a volume…")) b->click();
}

TEST_F(TypedNumber, is_tried_out) {
  double tried_mm = 0;
  QObject::connect(page.get(), &EditorPage::try_out_wanted, page.get(), [&](const SessionPlan& plan) { tried_mm = depth_mm(plan.scenario); });
  page->try_out();
  EXPECT_DOUBLE_EQ(tried_mm, 2.4);
  EXPECT_TRUE(depth->hasFocus());
}

TEST_F(TypedNumber, is_kept_when_the_page_leaves) {
  page->leave();
  EXPECT_DOUBLE_EQ(kept_depth_mm(), 2.4);
}

TEST_F(TypedNumber, is_kept_when_the_window_closes) {
  page->keep_before_closing();
  EXPECT_DOUBLE_EQ(kept_depth_mm(), 2.4);
}

TEST_F(TypedNumber, is_kept_by_the_key_that_saves) {
  QTest::keyClick(depth, Qt::Key_S, Qt::ControlModifier);
  EXPECT_DOUBLE_EQ(kept_depth_mm(), 2.4);
}

TEST_F(TypedNumber, is_kept_by_the_key_that_saves_with_a_word_on_a_briefing_that_is_not) {
  auto* edit = named<QPlainTextEdit>(*page, "Briefing, English");
  ASSERT_NE(edit, nullptr);
  edit->clear();
  QTest::keyClick(depth, Qt::Key_S, Qt::ControlModifier);
  EXPECT_DOUBLE_EQ(kept_depth_mm(), 2.4);
  EXPECT_TRUE(std::ranges::any_of(page->findChildren<Band*>(), [&](const Band* band) {
    return band->isVisibleTo(page.get()) && band->text().contains(QStringLiteral("without the briefing"));
  }));
}

TEST_F(EditorPages, what_is_edited_while_a_version_is_published_is_kept_when_the_window_closes) {
  auto page = open();
  page->model().set_depth_mm(1.5);
  page->model().now_tried(page->model().scenario());
  const ScenarioId id = page->model().scenario().id;
  ASSERT_TRUE(open_sheet(*page));
  sheet_of(*page)->publish()->click();
  page->model().set_depth_mm(1.7);
  page->keep_before_closing();
  page.reset();
  std::thread(wait_for_dropped_tasks).join();
  EXPECT_EQ(records.store().scenarios.versions(id)->size(), 2u);
  const auto drafts = records.store().scenarios.drafts(instructor.actor());
  ASSERT_EQ(drafts->size(), 1u) << "the draft, or a copy of it if the version stood first";
  EXPECT_DOUBLE_EQ(read_scenario(drafts->front().json)->target.outline.depth_mm, 1.7);
}

TEST_F(EditorPages, a_new_exercise_is_kept_before_its_first_edit) {
  EditorStart start = coarse();
  start.published.reset();
  start.draft.id = ScenarioId::make();
  start.draft.key.clear();
  start.folder = drafts_folder(records.file(), start.draft.id).string();
  const auto page = open(start);
  EXPECT_TRUE(QTest::qWaitFor([&] { return !records.store().scenarios.drafts(instructor.actor())->empty(); }, kGrowsWithinMs));
  EXPECT_EQ(page->model().stack().count(), 0);
}

TEST_F(EditorPages, a_page_that_could_not_publish_before_it_left_stays_after_the_next_version) {
  EditorStart start = coarse();
  const auto volume = make_specimen(start.draft.specimen, {});
  ASSERT_TRUE(volume.has_value());
  start.draft.specimen = {};
  start.draft.specimen.volume = "block.nrrd";
  start.draft.specimen.voxel_mm = volume->grid.voxel_mm;
  const std::filesystem::path there = std::filesystem::path(start.folder) / "block.nrrd";
  std::filesystem::create_directories(start.folder);
  ASSERT_TRUE(write_nrrd(*volume, there));
  const auto page = open(start);
  QSignalSpy back(page.get(), &EditorPage::back_wanted);
  page->model().now_tried(page->model().scenario());
  ASSERT_TRUE(open_sheet(*page));
  std::filesystem::remove(there);
  sheet_of(*page)->publish()->click();
  page->leave();
  EXPECT_EQ(back.count(), 0) << "once the version stands";
  ASSERT_TRUE(QTest::qWaitFor([&] { return std::ranges::any_of(page->findChildren<Band*>(), &Band::isVisible); }, kGrowsWithinMs));
  ASSERT_TRUE(write_nrrd(*volume, there));
  ASSERT_TRUE(open_sheet(*page));
  ASSERT_TRUE(publish_by_sheet(*page));
  EXPECT_EQ(back.count(), 0);
}

TEST_F(EditorPages, a_volume_is_taken_whatever_its_file_is_called) {
  const auto page = open();
  const auto volume = make_specimen(small_block(), {});
  ASSERT_TRUE(volume.has_value());
  file = folder.filePath(QStringLiteral(".Zähne 12:30.nrrd"));
  ASSERT_TRUE(write_nrrd(*volume, file.toStdString()));
  press_choose_volume(*page);
  EXPECT_EQ(page->model().scenario().specimen.volume, "Zähne 12_30.nrrd");
}

TEST_F(EditorPages, a_corrected_volume_keeps_the_figures_that_the_author_set_for_its_tissues) {
  const auto page = open();
  const auto volume = make_specimen(small_block(), {});
  ASSERT_TRUE(volume.has_value());
  file = folder.filePath(QStringLiteral("block.nrrd"));
  ASSERT_TRUE(write_nrrd(*volume, file.toStdString()));
  press_choose_volume(*page);
  const auto& tissues = page->model().scenario().tissues;
  ASSERT_EQ(tissues.size(), 1u);
  ASSERT_TRUE(page->model().set_tissue_figures(0, 1.25, 4.5));
  press_choose_volume(*page);
  EXPECT_EQ(page->model().scenario().specimen.volume, "block-2.nrrd");
  ASSERT_EQ(tissues.size(), 1u);
  EXPECT_EQ(tissues[0].stiffness_n_per_mm, 1.25);
  EXPECT_EQ(tissues[0].speed_mm_s, 4.5);
}

TEST_F(EditorPages, a_volume_of_a_fineness_that_no_exercise_holds_is_refused_with_its_figure) {
  const auto page = open();
  const Scenario before = page->model().scenario();
  auto volume = make_specimen(small_block(), {});
  ASSERT_TRUE(volume.has_value());
  volume->grid.voxel_mm = 0.03;
  file = folder.filePath(QStringLiteral("micro.nrrd"));
  ASSERT_TRUE(write_nrrd(*volume, file.toStdString()));
  press_choose_volume(*page);
  EXPECT_EQ(page->model().scenario(), before);
  QString text;
  for (const Band* band : page->findChildren<Band*>()) text += band->text();
  EXPECT_TRUE(text.contains(QStringLiteral("0.030"))) << text.toStdString();
  EXPECT_TRUE(text.contains(QStringLiteral("Make it anew"))) << "the import takes a specimen as it stands";
  EXPECT_FALSE(std::filesystem::exists(std::filesystem::path(page->model().folder()) / "micro.nrrd"));
}

TEST(Fineness, that_is_refused_is_shown_with_the_digits_that_tell_it_from_the_range) {
  EXPECT_TRUE(fineness_refusal(0.0398).contains(QStringLiteral("0.0398"))) << fineness_refusal(0.0398).toStdString();
  EXPECT_TRUE(fineness_refusal(1.0002).contains(QStringLiteral("1.0002"))) << fineness_refusal(1.0002).toStdString();
  EXPECT_TRUE(fineness_refusal(0.04).isEmpty());
}

TEST_F(EditorPages, a_volume_of_the_finest_voxels_is_taken_as_a_file_holds_them_in_32_bits) {
  const auto page = open();
  VoxelVolume volume(Grid{IVec3(40, 40, 40), 0.04f, Vec3(0.0)});  // 0.0399999991
  for (const IVec3 v : {IVec3(10, 10, 10), IVec3(29, 29, 29)}) {
    volume.tissue[volume.grid.index(v)] = Tissue::enamel;
    volume.s[volume.grid.index(v)] = kSolid;
  }
  file = folder.filePath(QStringLiteral("micro.nrrd"));
  ASSERT_TRUE(write_nrrd(volume, file.toStdString()));
  press_choose_volume(*page);
  EXPECT_EQ(page->model().scenario().specimen.volume, "micro.nrrd");
  EXPECT_EQ(page->model().scenario().specimen.voxel_mm, 0.04);
  EXPECT_TRUE(page->model().set_title("en", QStringLiteral("Scanned tooth")));
}

TEST(Briefing, that_is_longer_than_an_exercise_holds_stays_with_a_message_until_it_is_shortened) {
  EditorModel model(class_one());
  TextsForm form(model);
  form.show();
  QPlainTextEdit* edit = nullptr;
  for (QPlainTextEdit* one : form.findChildren<QPlainTextEdit*>())
    if (one->accessibleName().contains(QStringLiteral("English"))) edit = one;
  ASSERT_NE(edit, nullptr);
  const auto message = [&] {
    QStringList out;
    for (const QLabel* label : form.findChildren<QLabel*>())
      if (label->isVisible() && label->text().contains(QStringLiteral("characters"))) out << label->text();
    return out.join(u'\n');
  };
  const std::string before = model.scenario().briefing.at("en");
  const QString longer(static_cast<int>(kMostTextCharacters) + 1, u'ä');
  edit->setPlainText(longer);
  EXPECT_EQ(model.scenario().briefing.at("en"), before);
  EXPECT_TRUE(message().contains(QStringLiteral("4001"))) << message().toStdString();
  ASSERT_TRUE(model.set_depth_mm(1.3));
  EXPECT_EQ(edit->toPlainText(), longer) << "an edit elsewhere takes nothing away";
  edit->setPlainText(longer.chopped(1));
  EXPECT_EQ(model.scenario().briefing.at("en"), longer.chopped(1).toStdString());
  EXPECT_EQ(message(), QString());
}

TEST(Briefing, in_english_that_is_cleared_stays_in_the_exercise_with_a_message) {
  EditorModel model(class_one());
  TextsForm form(model);
  form.show();
  const auto cleared = [&](const char* name) {
    auto* edit = named<QPlainTextEdit>(form, name);
    if (edit != nullptr) edit->clear();
    return edit;
  };
  const auto says = [&] {
    return std::ranges::any_of(form.findChildren<QLabel*>(), [](const QLabel* label) {
      return label->isVisible() && label->text().contains(QStringLiteral("keeps the one from before"));
    });
  };
  const std::string before = model.scenario().briefing.at("en");
  ASSERT_NE(cleared("Briefing, Deutsch"), nullptr);
  EXPECT_FALSE(says()) << "an exercise may be without it";
  auto* edit = cleared("Briefing, English");
  ASSERT_NE(edit, nullptr);
  EXPECT_EQ(model.scenario().briefing.at("en"), before);
  EXPECT_TRUE(says());
  edit->setPlainText(QStringLiteral("Cut a channel."));
  EXPECT_EQ(model.scenario().briefing.at("en"), "Cut a channel.");
  EXPECT_FALSE(says());
}

TEST_F(EditorPages, leaving_asks_while_the_exercise_cannot_hold_the_briefing_that_is_typed) {
  QStringList asked;
  bool answer = false;
  ports.ask = [&](QWidget*, const Question& question, const std::function<void(bool)>& then) {
    asked << question.what;
    then(answer);
  };
  const auto page = open();
  QSignalSpy back(page.get(), &EditorPage::back_wanted);
  auto* edit = named<QPlainTextEdit>(*page, "Briefing, English");
  ASSERT_NE(edit, nullptr);
  const QString before = edit->toPlainText();
  edit->setPlainText(QString(static_cast<int>(kMostTextCharacters) + 1, u'ä'));
  page->leave();
  EXPECT_EQ(asked, QStringList{QStringLiteral("Leave without the briefing?")});
  EXPECT_EQ(back.count(), 0);
  answer = true;
  page->leave();
  EXPECT_EQ(back.count(), 1);
  edit->setPlainText(before);
  page->leave();
  EXPECT_EQ(back.count(), 2);
  EXPECT_EQ(asked.size(), 2) << "the exercise holds it";
}

LesionSource proximal(const char* site) {
  LesionSource out;
  out.kind = "proximal";
  out.site = site;
  return out;
}

/// Returns the tooth with them.
SpecimenSource give_lesions(EditorModel& model, std::vector<LesionSource> lesions) {
  SpecimenSource tooth = model.scenario().specimen;
  tooth.lesions = std::move(lesions);
  EXPECT_TRUE(model.set_tooth(tooth, QStringLiteral("lesions")));
  model.end_gesture();
  return tooth;
}

TEST(ToothForm, offers_each_tooth_its_own_kinds_of_carious_lesions) {
  EditorModel model(class_one());
  const SpecimenSource molar = give_lesions(model, {proximal("mesial")});
  ToothForm form(model);
  const auto kinds = [&] {
    QStringList out;
    for (const QComboBox* box : form.findChildren<QComboBox*>())
      if (box->accessibleName() == QStringLiteral("Kind of carious lesion 1"))
        for (int i = 0; i < box->count(); ++i) out << box->itemData(i).toString();
    return out;
  };
  const QStringList of_a_molar = kinds();
  EXPECT_TRUE(of_a_molar.contains(QStringLiteral("fissure")));
  SpecimenSource incisor = molar;
  incisor.fdi = 11;
  ASSERT_TRUE(model.set_tooth(incisor, QStringLiteral("fdi")));
  model.end_gesture();
  EXPECT_FALSE(kinds().contains(QStringLiteral("fissure"))) << kinds().join(u' ').toStdString();
  model.stack().undo();
  EXPECT_EQ(kinds(), of_a_molar);
}

TEST(ToothForm, gives_no_number_that_was_typed_for_a_removed_carious_lesion_to_the_next_one) {
  EditorModel model(class_one());
  const LesionSource distal = proximal("distal");
  give_lesions(model, {proximal("mesial"), distal});
  ToothForm form(model);
  form.show();
  form.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&form));
  auto* width = named<NumberField>(form, "Width of carious lesion 1");
  ASSERT_NE(width, nullptr);
  width->setFocus();
  width->selectAll();
  QTest::keyClicks(width, QStringLiteral("3"));
  QTest::mouseClick(named<QToolButton>(form, "Remove carious lesion 1"), Qt::LeftButton);
  width->clearFocus();
  EXPECT_EQ(model.scenario().specimen.lesions, std::vector<LesionSource>{distal});
}

TEST(ShapeForm, changes_one_number_of_a_point_and_leaves_the_other_to_its_last_digit) {
  EditorModel model(class_one());
  ASSERT_TRUE(model.set_point_mm(0, 0, 0.1234, 0.5678));
  model.end_gesture();
  ShapeForm form(model);
  for (NumberField* field : form.findChildren<NumberField*>())
    if (field->accessibleName() == QStringLiteral("Along the arch")) field->setValue(0.4);
  const Vec3 p = model.outline().paths[0][0];
  EXPECT_DOUBLE_EQ(p.x, 0.4);
  EXPECT_DOUBLE_EQ(p.y, 0.5678);
}

}  // namespace
}  // namespace cusp::test
