// CTs and label maps on the import page.

#include <QSlider>
#include <cmath>

#include "tests/ui/instructor/import_page_fixture.h"
#include "ui/editor/editor_model.h"
#include "ui/instructor/slice_view.h"
#include "ui/widgets/busy.h"

namespace cusp::test {
namespace {

TEST_F(ImportPageTest, a_label_map_of_a_wrong_unit_is_questioned_once_it_is_made) {
  // 16 voxels of 10 mm each: a tooth of 120 mm.
  std::string data(16 * 16 * 16, '\0');
  for (int z = 2; z < 14; ++z)
    for (int y = 5; y < 11; ++y)
      for (int x = 5; x < 11; ++x) data[static_cast<std::size_t>(x + 16 * (y + 16 * z))] = 2;
  write_text(folder / "map.nrrd", "NRRD0005\ntype: uint8\ndimension: 3\nsizes: 16 16 16\nspacings: 5 5 10\nencoding: raw\n\n" + data);
  open({file("map.nrrd")});
  make();
  EXPECT_TRUE(texts().contains(QStringLiteral("longer than any tooth"))) << texts().toStdString();
  EXPECT_FALSE(keep()->isEnabled());
  QPushButton* tenth = nullptr;
  for (QPushButton* b : page->findChildren<QPushButton*>())
    if (b->text().contains(QStringLiteral("0.1")) && b->text().contains(QStringLiteral("12.0"))) tenth = b;
  ASSERT_NE(tenth, nullptr);
  tenth->click();
  ASSERT_TRUE(QTest::qWaitFor([&] { return page->preview()->volume() == nullptr; }, kPatienceMs)) << "it would be another specimen";
  make();
  EXPECT_NEAR(page->preview()->size_mm().z, 12.0, 0.01);
  EXPECT_NEAR(page->preview()->volume()->grid.voxel_mm, 0.5, 1e-9) << "its own voxels, a tenth as long";
  EXPECT_TRUE(keep()->isEnabled());
}

/// A block of label 2 of 16 voxels an edge in one of 24.
std::string block_in_24() {
  std::string data(24 * 24 * 24, '\0');
  for (int z = 4; z < 20; ++z)
    for (int y = 4; y < 20; ++y)
      for (int x = 4; x < 20; ++x) data[static_cast<std::size_t>(x + 24 * (y + 24 * z))] = 2;
  return data;
}
const std::string kHeadOf24 = "NRRD0005\ntype: uint8\ndimension: 3\nsizes: 24 24 24\nencoding: raw\nspacings: 500 500 500\n";

TEST_F(ImportPageTest, micrometres_that_are_called_millimetres_are_asked_about_before_the_import) {
  write_text(folder / "um.nrrd", kHeadOf24 + "\n" + block_in_24());
  open({file("um.nrrd")});
  EXPECT_TRUE(texts().contains(QStringLiteral("longer than any tooth"))) << texts().toStdString();
  EXPECT_FALSE(button(QStringLiteral("Make a specimen"))->isEnabled());
  QPushButton* thousandth = nullptr;
  for (QPushButton* b : page->findChildren<QPushButton*>())
    if (b->text().contains(QStringLiteral("0.001"))) thousandth = b;
  ASSERT_NE(thousandth, nullptr);
  thousandth->click();
  ASSERT_TRUE(QTest::qWaitFor([&] { return button(QStringLiteral("Make a specimen"))->isEnabled(); }, kPatienceMs));
  make();
  EXPECT_NEAR(page->preview()->volume()->grid.voxel_mm, 0.5, 1e-9) << "500 mm were cut to the range of the field before";
  EXPECT_NEAR(page->preview()->size_mm().z, 8.0, 1e-6);
  EXPECT_TRUE(texts().contains(QStringLiteral("mirror image"))) << "it names no space: " << texts().toStdString();
}

TEST_F(ImportPageTest, leaving_asks_once_files_were_read) {
  QStringList asked;
  bool answer = false;
  ports.ask = [&](QWidget*, const Question& question, const std::function<void(bool)>& then) {
    asked << question.what;
    then(answer);
  };
  int left = 0;
  QObject::connect(page.get(), &ImportPage::back_wanted, [&] { ++left; });
  QPushButton* back = button(QStringLiteral("Library"));
  ASSERT_NE(back, nullptr);
  back->click();
  EXPECT_EQ(left, 1);
  EXPECT_TRUE(asked.isEmpty()) << "nothing is begun";
  write_text(folder / "um.nrrd", kHeadOf24 + "\n" + block_in_24());
  open({file("um.nrrd")});
  back->click();
  EXPECT_EQ(asked, QStringList{QStringLiteral("Leave the import?")});
  EXPECT_EQ(left, 1);
  answer = true;
  back->click();
  EXPECT_EQ(left, 2);
}

TEST_F(ImportPageTest, the_focus_stays_on_the_button_of_a_turn_and_of_a_step_that_failed) {
  write_text(folder / "cusp-drafts", "no folder");
  const std::string ball = binary_stl(sphere("a", {0, 0, 0}, 5.0, 2));
  write_text(folder / "a.stl", ball);
  open({file("a.stl")});
  std::filesystem::remove(folder / "a.stl");
  QPushButton* make_button = button(QStringLiteral("Make a specimen"));
  make_button->setFocus();
  make_button->click();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !page->busy(); }, kPatienceMs));
  EXPECT_EQ(page->focusWidget(), make_button);
  write_text(folder / "a.stl", ball);
  make();
  QPushButton* tip = button(QStringLiteral("Tip back"));
  tip->setFocus();
  turn(QStringLiteral("Tip back"));
  EXPECT_EQ(page->focusWidget(), tip);
  EXPECT_TRUE(button(QStringLiteral("Tip left"))->isEnabled());
  keep()->setFocus();
  keep_it();
  EXPECT_FALSE(started.has_value());
  EXPECT_EQ(page->focusWidget(), keep());
}

TEST_F(ImportPageTest, the_fineness_of_a_volume_follows_the_unit_that_is_chosen) {
  write_text(folder / "v.nrrd", kHeadOf24 + "space units: \"?\" \"?\" \"?\"\n\n" + block_in_24());
  open({file("v.nrrd")});
  for (QComboBox* b : page->findChildren<QComboBox*>())
    if (const int um = b->findText(QStringLiteral("Micrometre")); um >= 0) b->setCurrentIndex(um);
  make();
  EXPECT_NEAR(page->preview()->volume()->grid.voxel_mm, 0.5, 1e-9);
  write_text(folder / "a.stl", binary_stl(sphere("a", {0, 0, 0}, 5.0, 2)));
  open({file("a.stl")});
  make();
  EXPECT_NEAR(page->preview()->volume()->grid.voxel_mm, 0.1, 1e-9) << "a mesh has no voxels of its own";
}

TEST_F(ImportPageTest, a_scan_that_is_finer_than_an_exercise_can_be_becomes_one_that_takes_edits) {
  write_text(folder / "micro.nrrd",
             "NRRD0005\ntype: uint8\ndimension: 3\nsizes: 200 16 16\nspacings: 0.03 0.03 0.03\nencoding: raw\n\n" + std::string(51'200, '\2'));
  open({file("micro.nrrd")});
  make();
  EXPECT_NEAR(page->preview()->volume()->grid.voxel_mm, 0.04, 1e-9);
  keep_it();
  ASSERT_TRUE(started);
  EXPECT_TRUE(EditorModel(*started).set_title("en", QStringLiteral("Scanned tooth")));
}

TEST_F(ImportPageTest, a_specimen_that_is_finer_than_an_exercise_can_be_is_refused_with_its_figure) {
  VoxelVolume volume(Grid{IVec3(40, 40, 40), 0.03, Vec3(0.0)});
  for (int z = 10; z < 30; ++z) {
    const std::size_t at = volume.grid.index({20, 20, z});
    volume.tissue[at] = Tissue::enamel;
    volume.s[at] = kSolid;
  }
  ASSERT_TRUE(write_nrrd(volume, folder / "own.nrrd"));
  open({file("own.nrrd")});
  EXPECT_FALSE(button(QStringLiteral("Make a specimen"))->isEnabled()) << "it is taken as it stands, and no exercise holds it";
  EXPECT_TRUE(texts().contains(QStringLiteral("0.030"))) << texts().toStdString();
  volume.grid.voxel_mm = 0.04f;  // 0.0399999991, as a file holds it in 32 bits
  ASSERT_TRUE(write_nrrd(volume, folder / "own.nrrd"));
  open({file("own.nrrd")});
  make();
  keep_it();
  ASSERT_TRUE(started);
  EXPECT_TRUE(EditorModel(*started).set_title("en", QStringLiteral("Scanned tooth")));
}

TEST_F(ImportPageTest, a_tissue_that_the_author_named_stands_by_that_name) {
  VoxelVolume volume(Grid{IVec3(40, 40, 40), 0.25, Vec3(0.0)});
  for (int z = 10; z < 30; ++z)
    for (int y = 10; y < 30; ++y)
      for (int x = 10; x < 30; ++x) {
        const std::size_t at = volume.grid.index({x, y, z});
        volume.tissue[at] = Tissue{16};
        volume.s[at] = kSolid;
      }
  volume.names[16] = "pulp stone";
  ASSERT_TRUE(write_nrrd(volume, folder / "own.nrrd"));
  open({file("own.nrrd")});
  make();
  EXPECT_TRUE(texts().contains(QStringLiteral("pulp stone"))) << texts().toStdString();
}

TEST_F(ImportPageTest, a_tissue_of_the_author_with_the_code_of_a_grown_tooth_s_is_refused_by_its_name) {
  VoxelVolume volume(Grid{IVec3(40, 40, 40), 0.25, Vec3(0.0)});
  for (int z = 10; z < 30; ++z)
    for (int y = 10; y < 30; ++y)
      for (int x = 10; x < 30; ++x) {
        const std::size_t at = volume.grid.index({x, y, z});
        volume.tissue[at] = Tissue{31};
        volume.s[at] = kSolid;
      }
  volume.names[31] = "pulp stone";
  ASSERT_TRUE(write_nrrd(volume, folder / "own.nrrd"));
  open({file("own.nrrd")});
  button(QStringLiteral("Make a specimen"))->click();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !page->busy(); }, kPatienceMs));
  EXPECT_EQ(page->preview()->volume(), nullptr);
  const QString shown = page->findChild<Band*>()->text();
  for (const char* part : {"own.nrrd", "pulp stone", "16 to 28"}) EXPECT_TRUE(shown.contains(QLatin1String(part))) << shown.toStdString();
}

TEST_F(ImportPageTest, the_size_of_a_large_volume_can_be_confirmed) {
  write_text(folder / "map.nrrd", "NRRD0005\ntype: uint8\ndimension: 3\nsizes: 30 8 8\nspacings: 5 5 5\nencoding: raw\n\n" + std::string(1920, '\2'));
  open({file("map.nrrd")});
  make();
  EXPECT_FALSE(keep()->isEnabled());
  button_from(QStringLiteral("It is "))->click();
  ASSERT_TRUE(QTest::qWaitFor([&] { return keep()->isEnabled(); }, kPatienceMs));
  EXPECT_NE(page->preview()->volume(), nullptr) << "what was made stays";
}

TEST_F(ImportPageTest, volumes_that_are_dropped_together_are_refused_with_a_way_out) {
  for (const char* name : {"a.nrrd", "b.nrrd"}) write_text(folder / name, kHeadOf24 + "\n" + block_in_24());
  open({file("a.nrrd"), file("b.nrrd")});
  const QString text = page->findChild<Band*>()->text();
  EXPECT_TRUE(text.contains(QStringLiteral("not opened together"))) << text.toStdString();
  EXPECT_TRUE(text.contains(QStringLiteral(".nrrd"))) << text.toStdString();
  EXPECT_FALSE(text.contains(QStringLiteral("not read here")));
}

TEST_F(ImportPageTest, a_ct_shows_its_tissues_live_and_keeps_no_name) {
  write_ct();
  open({file("ct")});
  ASSERT_NE(page->volume(), nullptr) << texts().toStdString();
  EXPECT_TRUE(texts().contains(QStringLiteral("28 slices"))) << texts().toStdString();
  EXPECT_TRUE(texts().contains(QStringLiteral("are resampled to cubes of")));
  SliceView* view = page->volume()->view();
  const auto coloured = [&] {
    const QImage picture = view->picture();
    int n = 0;
    for (int y = 0; y < picture.height(); ++y)
      for (int x = 0; x < picture.width(); ++x) {
        const QColor c = picture.pixelColor(x, y);
        n += c.red() != c.green() || c.green() != c.blue();
      }
    return n;
  };
  const int before = coloured();
  EXPECT_GT(before, 200);
  EXPECT_LT(before, 40 * 40);
  QDoubleSpinBox* first = nullptr;
  for (QDoubleSpinBox* b : page->findChildren<QDoubleSpinBox*>())
    if (b->accessibleName() == QStringLiteral("Least value of range 1")) first = b;
  ASSERT_NE(first, nullptr);
  EXPECT_GT(first->value(), -900.0);
  EXPECT_LT(first->value(), 1300.0);
  first->setValue(2700.0);
  EXPECT_LT(coloured(), before);
  first->setValue(500.0);
  EXPECT_EQ(coloured(), before);
  picture("ct");
  auto* slider = view->findChild<QSlider*>();
  slider->setValue(0);
  EXPECT_LT(coloured(), before);
  for (QCheckBox* b : page->findChildren<QCheckBox*>()) b->setChecked(true);
  make();
  EXPECT_TRUE(texts().contains(QStringLiteral("Nothing about the patient was read."))) << texts().toStdString();
  keep_it();
  ASSERT_TRUE(started.has_value());
  EXPECT_EQ(started->draft.title.at("en"), "CT");
  EXPECT_EQ(started->draft.protected_parts, std::vector<Protected>{Tissue::pulp}) << "the hollow";
}

TEST_F(ImportPageTest, ranges_of_grey_between_0_and_1_part_the_tissues) {
  // A µCT in attenuations: air, dentine to a radius of 9, enamel to one of 5.
  std::string data;
  for (int z = 0; z < 24; ++z)
    for (int y = 0; y < 24; ++y)
      for (int x = 0; x < 24; ++x) {
        const double r = std::hypot(x - 12.0, y - 12.0, z - 12.0);
        const float v = r > 9.0 ? 0.05f : r > 5.0 ? 0.35f : 0.62f;
        data.append(reinterpret_cast<const char*>(&v), sizeof v);
      }
  write_text(folder / "mu.nrrd", "NRRD0005\ntype: float\ndimension: 3\nsizes: 24 24 24\nspacings: 0.5 0.5 0.5\nendian: little\nencoding: raw\n\n" + data);
  open({file("mu.nrrd")});
  ASSERT_NE(page->volume(), nullptr) << texts().toStdString();
  const ImageTissues t = page->volume()->tissues();
  ASSERT_EQ(t.thresholds.size(), 2u);
  EXPECT_GT(t.thresholds[0].first, 0.05);
  EXPECT_LT(t.thresholds[0].first, 0.35);
  EXPECT_GT(t.thresholds[1].first, 0.35);
  EXPECT_LT(t.thresholds[1].first, 0.62);
  make();
  EXPECT_NEAR(page->preview()->size_mm().z, 9.0, 0.8) << "and not the whole box of 12 mm";
}

TEST_F(ImportPageTest, a_chosen_slice_of_the_smaller_series_is_not_called_the_largest) {
  write_ct();
  DicomWish scout;
  scout.columns = scout.rows = 8;
  scout.series = "9.9";
  scout.values.assign(64, 7);
  write_text(folder / "ct/scout.dcm", dicom_file(scout));
  open({file("ct/scout.dcm")});
  ASSERT_NE(page->volume(), nullptr) << texts().toStdString();
  EXPECT_TRUE(texts().contains(QStringLiteral("holds 2 series"))) << texts().toStdString();
  EXPECT_FALSE(texts().contains(QStringLiteral("largest of 2")));
}

TEST_F(ImportPageTest, slices_are_numbered_as_those_of_the_file) {
  write_text(folder / "long.nrrd", "NRRD0005\ntype: uint8\ndimension: 3\nsizes: 8 8 400\nspacings: 1 1 0.1\nencoding: raw\n\n" + std::string(25600, '\2'));
  open({file("long.nrrd")});
  ASSERT_NE(page->volume(), nullptr) << texts().toStdString();
  page->volume()->view()->findChild<QSlider*>()->setValue(10);  // every third is shown
  EXPECT_TRUE(texts().contains(QStringLiteral("Slice 31 of 400"))) << texts().toStdString();
}

TEST_F(ImportPageTest, reading_can_be_stopped_and_leaves_nothing) {
  write_ct();
  page->open_files({file("ct")});
  ASSERT_TRUE(page->busy());
  EXPECT_FALSE(button(QStringLiteral("Choose a file…"))->isEnabled());
  Q_EMIT page->findChild<Busy*>()->cancelled();
  EXPECT_FALSE(page->busy());
  EXPECT_TRUE(page->files().empty());
  EXPECT_TRUE(page->findChild<Band*>()->text().contains(QStringLiteral("stopped")));
  EXPECT_TRUE(button(QStringLiteral("Choose a file…"))->isEnabled());
  open({file("ct")});  // and it can be begun again
  EXPECT_NE(page->volume(), nullptr);
}

TEST_F(ImportPageTest, a_label_map_offers_its_numbers_with_the_tissues_they_most_likely_mean) {
  std::string data(512, '\1');
  data[0] = 2;
  data[1] = 77;
  write_text(folder / "map.nrrd", "NRRD0005\ntype: uint8\ndimension: 3\nsizes: 8 8 8\nspacings: 1 1 1\nencoding: raw\n\n" + data);
  open({file("map.nrrd")});
  ASSERT_NE(page->volume(), nullptr) << texts().toStdString();
  const ImageTissues t = page->volume()->tissues();
  EXPECT_EQ(t.labels, (std::vector<std::pair<std::uint32_t, Tissue>>{{1, Tissue::enamel}, {2, Tissue::dentine}}));
  EXPECT_TRUE(texts().contains(QStringLiteral("510 voxels")));
}

}  // namespace
}  // namespace cusp::test
