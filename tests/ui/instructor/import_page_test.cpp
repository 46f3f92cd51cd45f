// The import page over real files and a real child process. With CUSP_PICTURES=FOLDER it leaves pictures of itself there.

#include <QDropEvent>
#include <QMimeData>
#include <QTemporaryDir>
#include <QUrl>

#include "scenarios/import/quarter_turn.h"
#include "scenarios/import/worker.h"
#include "tests/ui/instructor/import_page_fixture.h"
#include "ui/instructor/import_drop.h"
#include "ui/instructor/size_picture.h"
#include "ui/widgets/busy.h"
#include "ui/text/language.h"

namespace cusp::test {
namespace {

TEST_F(ImportPageTest, lists_what_it_takes_and_imports_nothing_without_files) {
  EXPECT_TRUE(texts().contains(QStringLiteral("Drop files here")));
  EXPECT_FALSE(button(QStringLiteral("Make a specimen"))->isVisibleTo(page.get()));
  EXPECT_EQ(page->meshes(), nullptr);
}

TEST_F(ImportPageTest, while_there_is_no_file_the_page_is_a_place_to_drop_one) {
  const auto* drop = page->findChild<ImportDrop*>();
  EXPECT_TRUE(drop->isVisible());
  EXPECT_GT(drop->height(), page->height() / 2);
  EXPECT_EQ(page->focusProxy(), drop->button());
  write_text(folder / "a.stl", binary_stl(sphere("a", {0, 0, 0}, 5.0, 2)));
  open({file("a.stl")});
  EXPECT_FALSE(drop->isVisible());
  button(QStringLiteral("Begin anew"))->click();
  EXPECT_TRUE(drop->isVisible());
}

TEST_F(ImportPageTest, the_focus_goes_from_a_chosen_file_to_the_next_one_and_not_to_the_way_back) {
  page->setFocus();
  write_text(folder / "a.stl", binary_stl(sphere("a", {0, 0, 0}, 5.0, 2)));
  open({file("a.stl")});
  EXPECT_EQ(page->focusWidget(), button(QStringLiteral("Add a file…")));
  button(QStringLiteral("Begin anew"))->click();
  write_text(folder / "b.stl", "no mesh");
  open({file("b.stl")});
  EXPECT_EQ(page->focusWidget(), page->findChild<ImportDrop*>()->button());
}

TEST_F(ImportPageTest, the_focus_is_on_cancel_while_a_file_is_read) {
  page->setFocus();
  write_text(folder / "a.stl", binary_stl(sphere("a", {0, 0, 0}, 5.0, 2)));
  page->open_files({file("a.stl")});
  ASSERT_TRUE(page->busy());
  auto* busy = page->findChild<Busy*>();
  busy->show();
  Q_EMIT busy->shown();
  EXPECT_EQ(page->focusWidget(), busy->findChild<QPushButton*>()) << "on the way back Enter would leave the page";
  ASSERT_TRUE(QTest::qWaitFor([&] { return !page->busy(); }, kPatienceMs));
  EXPECT_EQ(page->focusWidget(), button(QStringLiteral("Add a file…")));
}

TEST_F(ImportPageTest, a_mesh_is_drawn_to_scale_beside_a_molar) {
  write_text(folder / "a.stl", binary_stl(sphere("a", {0, 0, 0}, 5.0, 3)));  // 10 mm across
  open({file("a.stl")});
  const auto* picture = page->findChild<SizePicture*>();
  ASSERT_TRUE(picture->isVisible());
  EXPECT_TRUE(picture->accessibleDescription().contains(QStringLiteral("10.0 × 10.0 × 10.0"))) << picture->accessibleDescription().toStdString();
  const double beside_a_tooth = picture->px_per_mm();
  for (QComboBox* b : page->findChildren<QComboBox*>())
    if (const int inch = b->findText(QStringLiteral("Inch")); inch >= 0) b->setCurrentIndex(inch);
  // 254 mm high instead of the molar's 21.5.
  EXPECT_NEAR(picture->px_per_mm() / beside_a_tooth, 21.5 / 254.0, 0.01);
}

TEST_F(ImportPageTest, nested_meshes_of_several_files_become_an_exercise_on_their_tissues) {
  write_text(folder / "crown.stl", binary_stl(sphere("solid", {0, 0, 0}, 0.4, 3)));
  write_text(folder / "pulp.stl", binary_stl(sphere("solid", {0, 0, 0}, 0.15, 3)));
  open({file("crown.stl")});
  open({file("pulp.stl")});  // joins the first
  ASSERT_NE(page->meshes(), nullptr);
  EXPECT_EQ(page->files().size(), 2u);
  EXPECT_EQ(box(QStringLiteral("What pulp is made of"))->currentData().toInt(), static_cast<int>(Tissue::pulp)) << "its name says so";
  EXPECT_EQ(box(QStringLiteral("What crown is made of"))->currentIndex(), 0) << "several parts, and no telling name";
  choose(QStringLiteral("What crown is made of"), Tissue::dentine);
  // 0.8 units long: centimetres are the first that make a tooth of it.
  EXPECT_TRUE(texts().contains(QStringLiteral("8.0 × 8.0 × 8.0"))) << texts().toStdString();
  QPushButton* make = button(QStringLiteral("Make a specimen"));
  ASSERT_TRUE(make->isEnabled());
  EXPECT_FALSE(keep()->isVisibleTo(page.get()));
  this->make();
  EXPECT_FALSE(started.has_value()) << "first it is looked at";
  EXPECT_TRUE(texts().contains(QRegularExpression(QStringLiteral("pulp\\W* lies inside \\W*crown")))) << texts().toStdString();
  EXPECT_TRUE(texts().contains(QRegularExpression(QStringLiteral("the innermost wins: \\W*pulp\\W* > \\W*crown")))) << texts().toStdString();
  keep_it();
  ASSERT_TRUE(started.has_value());
  EXPECT_EQ(started->draft.title.at("en"), "crown");
  EXPECT_EQ(started->draft.protected_parts, std::vector<Protected>{Tissue::pulp});
  const auto volume = read_nrrd(std::filesystem::path(started->folder) / started->draft.specimen.volume);
  ASSERT_TRUE(volume);
  EXPECT_DOUBLE_EQ(volume->grid.voxel_mm, 0.1);
}

TEST_F(ImportPageTest, a_lone_mesh_is_enamel_until_somebody_chooses) {
  write_text(folder / "cube.stl", binary_stl(sphere("a", {0, 0, 0}, 5.0, 2)));
  open({file("cube.stl")});
  EXPECT_EQ(box(QStringLiteral("What cube is made of"))->currentData().toInt(), static_cast<int>(Tissue::enamel));
  EXPECT_TRUE(button(QStringLiteral("Make a specimen"))->isEnabled());
}

TEST_F(ImportPageTest, a_part_takes_the_tissue_of_its_name_once_it_is_mended) {
  Mesh open_ball = sphere("Dentin", {10, 0, 0}, 4.0, 3);
  open_ball.triangles.erase(open_ball.triangles.begin() + 5);
  write_obj(folder / "m.obj", {open_ball, sphere("Schmelz", {10, 0, 0}, 5.0, 2)});
  open({file("m.obj")});
  const auto is = [&](const char* name) { return static_cast<Tissue>(box(QStringLiteral("What %1 is made of").arg(QString::fromUtf8(name)))->currentData().toInt()); };
  EXPECT_EQ(is("Schmelz"), Tissue::enamel);
  page->findChild<QCheckBox*>()->setChecked(false);
  EXPECT_EQ(is("Dentin"), Tissue::empty);
  page->findChild<QCheckBox*>()->setChecked(true);
  EXPECT_EQ(is("Dentin"), Tissue::dentine);
}

TEST_F(ImportPageTest, an_open_mesh_shows_its_gaps_in_millimetres_and_is_mended_when_asked) {
  Mesh open_ball = sphere("crown", {10, 0, 0}, 4.0, 3);
  open_ball.triangles.erase(open_ball.triangles.begin() + 5);
  write_obj(folder / "m.obj", {open_ball, sphere("core", {10, 0, 0}, 1.0, 2)});
  open({file("m.obj")});
  EXPECT_TRUE(texts().contains(QStringLiteral("1 gap of "))) << texts().toStdString();
  EXPECT_TRUE(texts().contains(QRegularExpression(QStringLiteral("at \\W*\\(-?\\d+\\.\\d; ")))) << texts().toStdString();
  QComboBox* crown = box(QStringLiteral("What crown is made of"));
  EXPECT_TRUE(crown->isEnabled());
  const auto mend = page->findChildren<QCheckBox*>();
  ASSERT_EQ(mend.size(), 1);
  choose(QStringLiteral("What crown is made of"), Tissue::enamel);
  mend[0]->setChecked(false);
  EXPECT_FALSE(crown->isEnabled());
  EXPECT_EQ(crown->currentIndex(), 0) << "what cannot be used is not chosen";
  mend[0]->setChecked(true);
  choose(QStringLiteral("What crown is made of"), Tissue::enamel);
  make();
  EXPECT_FALSE(started.has_value()) << "the page reports first what was done";
  EXPECT_TRUE(texts().contains(QStringLiteral("hole of "))) << texts().toStdString();
  keep_it();
  EXPECT_TRUE(started.has_value());
}

TEST_F(ImportPageTest, a_tooth_that_is_inside_out_beside_another_is_turned) {
  write_text(folder / "teeth.stl", binary_stl(joined(sphere("a", {0, 0, 0}, 4.0, 3), inside_out(sphere("b", {12, 0, 0}, 3.0, 3)))));
  open({file("teeth.stl")});
  make();
  EXPECT_NEAR(page->preview()->size_mm().x, 19.0, 0.3) << "both stand";
  EXPECT_TRUE(texts().contains(QStringLiteral("were turned round"))) << texts().toStdString();
}

TEST_F(ImportPageTest, a_seam_that_joining_closes_leaves_its_mesh_usable) {
  Mesh one = sphere("crown", {0, 0, 0}, 5.0, 3), other = one;
  const auto half = static_cast<std::ptrdiff_t>(one.triangles.size() / 2);
  one.triangles.erase(one.triangles.begin() + half, one.triangles.end());
  other.triangles.erase(other.triangles.begin(), other.triangles.begin() + half);
  for (Vec3& p : other.points) p.x += 5e-4;  // joined are points nearer than 1.7e-3
  write_text(folder / "crown.stl", binary_stl(joined(one, other)));
  open({file("crown.stl")});
  EXPECT_TRUE(texts().contains(QStringLiteral("gap"))) << texts().toStdString();
  EXPECT_TRUE(box(QStringLiteral("What crown is made of"))->isEnabled());
  make();
  EXPECT_NEAR(page->preview()->size_mm().z, 10.0, 0.3);
}

TEST_F(ImportPageTest, keeping_can_be_stopped_and_leaves_no_draft) {
  write_text(folder / "a.stl", binary_stl(sphere("a", {0, 0, 0}, 5.0, 2)));
  open({file("a.stl")});
  choose(QStringLiteral("What a is made of"), Tissue::enamel);
  make();
  keep()->click();
  Q_EMIT page->findChild<Busy*>()->cancelled();
  QThreadPool::globalInstance()->waitForDone();
  QApplication::processEvents();
  EXPECT_FALSE(page->busy());
  EXPECT_FALSE(started.has_value());
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder / "")) EXPECT_NE(entry.path().filename(), "specimen.nrrd");
}

TEST_F(ImportPageTest, a_unit_that_makes_no_tooth_is_asked_again) {
  write_text(folder / "a.stl", binary_stl(sphere("a", {0, 0, 0}, 5.0, 2)));
  open({file("a.stl")});
  EXPECT_FALSE(texts().contains(QStringLiteral("Is the unit right?")));
  for (QComboBox* b : page->findChildren<QComboBox*>())
    if (const int metre = b->findText(QStringLiteral("Metre")); metre >= 0) b->setCurrentIndex(metre);
  EXPECT_TRUE(texts().contains(QStringLiteral("longer than any tooth"))) << texts().toStdString();
}

TEST_F(ImportPageTest, a_tooth_of_155_mm_is_questioned_and_the_answer_is_a_button) {
  write_text(folder / "a.stl", binary_stl(sphere("a", {0, 0, 0}, 77.5, 3)));
  open({file("a.stl")});
  choose(QStringLiteral("What a is made of"), Tissue::dentine);
  EXPECT_TRUE(texts().contains(QRegularExpression(QStringLiteral("It is \\W*15[45]\\.\\d.mm\\W* long: longer than any tooth")))) << texts().toStdString();
  QPushButton* make_button = button(QStringLiteral("Make a specimen"));
  EXPECT_FALSE(make_button->isEnabled()) << "until it is answered";
  QPushButton* tenth = nullptr;
  for (QPushButton* b : page->findChildren<QPushButton*>())
    if (b->text().contains(QStringLiteral("0.1")) && b->text().contains(QStringLiteral("15.5"))) tenth = b;
  ASSERT_NE(tenth, nullptr);
  picture("questioned");
  tenth->click();
  ASSERT_TRUE(QTest::qWaitFor([&] { return make_button->isEnabled(); }, kPatienceMs));
  EXPECT_FALSE(texts().contains(QStringLiteral("Is the unit right?")));
  make();
  EXPECT_NEAR(page->preview()->size_mm().z, 15.5, 0.2);
  EXPECT_TRUE(keep()->isEnabled());
}

TEST_F(ImportPageTest, a_tooth_of_1_3_mm_is_questioned_and_may_be_one_all_the_same) {
  write_text(folder / "a.stl", binary_stl(sphere("a", {0, 0, 0}, 0.65, 3)));
  open({file("a.stl")});
  choose(QStringLiteral("What a is made of"), Tissue::dentine);
  // Centimetres are the first unit that makes a tooth of it; what it would be in millimetres stands beside.
  EXPECT_TRUE(texts().contains(QStringLiteral("If its unit were a millimetre, it would be"))) << texts().toStdString();
  for (QComboBox* b : page->findChildren<QComboBox*>())
    if (const int mm = b->findText(QStringLiteral("Millimetre")); mm >= 0) b->setCurrentIndex(mm);
  EXPECT_TRUE(texts().contains(QStringLiteral("shorter than any tooth"))) << texts().toStdString();
  QPushButton* all_the_same = button_from(QStringLiteral("It is "));
  ASSERT_NE(all_the_same, nullptr);
  all_the_same->click();
  QPushButton* make_button = button(QStringLiteral("Make a specimen"));
  ASSERT_TRUE(QTest::qWaitFor([&] { return make_button->isEnabled(); }, kPatienceMs));
  make();
  EXPECT_TRUE(keep()->isEnabled()) << "it is not asked twice";
}

TEST_F(ImportPageTest, what_was_made_is_turned_before_it_is_kept) {
  write_obj(folder / "a.obj", {lopsided("body")});
  open({file("a.obj")});
  choose(QStringLiteral("What body is made of"), Tissue::dentine);
  make();
  const auto upright = page->preview()->volume();
  EXPECT_LT(glm::length(page->preview()->size_mm() - Vec3(6.5, 4.0, 4.0)), 0.15);
  turn(QStringLiteral("Tip left"));
  EXPECT_LT(glm::length(page->preview()->size_mm() - Vec3(4.0, 4.0, 6.5)), 0.15);
  const VoxelVolume left = quarter_turned(*upright, 1, 1);
  EXPECT_TRUE(page->preview()->volume()->s == left.s);
  turn(QStringLiteral("Tip right"));
  EXPECT_TRUE(page->preview()->volume()->s == upright->s) << "and back";
  turn(QStringLiteral("Turn right"));
  turn(QStringLiteral("Tip back"));
  const VoxelVolume wanted = quarter_turned(quarter_turned(*upright, 2, 1), 0, 1);
  keep_it();
  ASSERT_TRUE(started.has_value());
  const auto kept = read_nrrd(std::filesystem::path(started->folder) / started->draft.specimen.volume);
  ASSERT_TRUE(kept);
  EXPECT_TRUE(kept->grid.size == wanted.grid.size && kept->s == wanted.s && kept->tissue == wanted.tissue);
}

TEST_F(ImportPageTest, what_was_made_is_forgotten_when_anything_that_it_depends_on_changes) {
  write_obj(folder / "a.obj", {lopsided("body")});
  open({file("a.obj")});
  choose(QStringLiteral("What body is made of"), Tissue::dentine);
  make();
  ASSERT_TRUE(keep()->isVisibleTo(page.get()));
  choose(QStringLiteral("What body is made of"), Tissue::enamel);
  EXPECT_EQ(page->preview()->volume(), nullptr);
  EXPECT_FALSE(keep()->isVisibleTo(page.get()));
  EXPECT_TRUE(button(QStringLiteral("Make a specimen"))->isEnabled());
}

TEST_F(ImportPageTest, a_shell_and_an_overlap_are_reported_before_anything_is_kept) {
  write_obj(folder / "incisor.obj", {prism("Enamel", {4.0, 0.0, 6.0, true}), prism("Dentine", {3.0, -10.0, 5.0}), prism("Pulp", {1.0, -9.0, 3.0})});
  open({file("incisor.obj")});
  for (QDoubleSpinBox* b : page->findChildren<QDoubleSpinBox*>())
    if (b->accessibleName() == QStringLiteral("Widest hole that is closed")) b->setValue(12.0);
  choose(QStringLiteral("What Enamel is made of"), Tissue::enamel);
  choose(QStringLiteral("What Dentine is made of"), Tissue::dentine);
  choose(QStringLiteral("What Pulp is made of"), Tissue::pulp);
  make();
  EXPECT_TRUE(texts().contains(QStringLiteral("was an open shell"))) << texts().toStdString();
  EXPECT_TRUE(texts().contains(QRegularExpression(QStringLiteral("Dentine\\W* and \\W*Enamel\\W* overlap by")))) << texts().toStdString();
  picture("shell");
}

TEST_F(ImportPageTest, a_file_that_cannot_be_read_is_reported_and_leaves_the_page_as_it_was) {
  write_text(folder / "bad.stl", "solid nothing");
  open({file("bad.stl")});
  EXPECT_TRUE(page->findChild<Band*>()->text().contains(QStringLiteral("cannot be read"))) << page->findChild<Band*>()->text().toStdString();
  EXPECT_TRUE(page->files().empty());
  open({file("gone.nrrd")});
  EXPECT_TRUE(page->findChild<Band*>()->text().contains(QStringLiteral("gone.nrrd")));
}

TEST_F(ImportPageTest, a_file_that_joins_others_leaves_what_was_chosen_for_them) {
  write_text(folder / "crown.stl", binary_stl(sphere("a", {0, 0, 0}, 0.4, 2)));
  write_text(folder / "root.stl", binary_stl(sphere("a", {0, 0, 0.5}, 0.3, 2)));
  write_text(folder / "bad.stl", "solid nothing");
  open({file("crown.stl")});
  choose(QStringLiteral("What crown is made of"), Tissue::dentine);
  QComboBox* unit = nullptr;
  for (QComboBox* b : page->findChildren<QComboBox*>())
    if (b->findText(QStringLiteral("Inch")) >= 0) unit = b;
  ASSERT_NE(unit, nullptr);
  unit->setCurrentText(QStringLiteral("Inch"));
  for (const char* next : {"root.stl", "bad.stl"}) {
    open({file(next)});
    EXPECT_EQ(page->files().size(), 2u) << next;
    QComboBox* crown = box(QStringLiteral("What crown is made of"));
    ASSERT_NE(crown, nullptr) << next;
    EXPECT_EQ(crown->currentData().toInt(), static_cast<int>(Tissue::dentine)) << next;
    EXPECT_EQ(unit->currentText(), QStringLiteral("Inch")) << next;
  }
  EXPECT_TRUE(page->findChild<Band*>()->text().contains(QStringLiteral("cannot be read")));
  page->open_files({file("bad.stl")});
  Q_EMIT page->findChild<Busy*>()->cancelled();
  EXPECT_EQ(page->files().size(), 2u) << "stopped";
  EXPECT_NE(page->meshes(), nullptr);
}

TEST_F(ImportPageTest, a_chosen_tissue_outlasts_a_unit_in_which_a_gap_is_too_wide) {
  Mesh open_ball = sphere("part", {0, 0, 0}, 4.0, 3);
  open_ball.triangles.erase(open_ball.triangles.begin() + 5);
  write_obj(folder / "m.obj", {open_ball, sphere("core", {0, 0, 0}, 1.0, 2)});
  open({file("m.obj")});
  choose(QStringLiteral("What part is made of"), Tissue::bone);
  for (const char* unit : {"Metre", "Millimetre"})
    for (QComboBox* b : page->findChildren<QComboBox*>())
      if (const int n = b->findText(QString::fromLatin1(unit)); n >= 0) b->setCurrentIndex(n);
  EXPECT_EQ(box(QStringLiteral("What part is made of"))->currentData().toInt(), static_cast<int>(Tissue::bone));
}

TEST_F(ImportPageTest, files_can_be_dropped) {
  write_text(folder / "a.ply", ply_file(sphere("a", {0, 0, 0}, 5.0, 2), PlyData::binary));
  QMimeData data;
  data.setUrls({QUrl::fromLocalFile(file("a.ply"))});
  QDragEnterEvent enter(QPoint(5, 5), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(page.get(), &enter);
  EXPECT_TRUE(enter.isAccepted());
  QDropEvent drop(QPointF(5, 5), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(page.get(), &drop);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !page->busy(); }, kPatienceMs));
  EXPECT_NE(page->meshes(), nullptr);
  QMimeData text;
  text.setText(QStringLiteral("text"));
  QDragEnterEvent refused(QPoint(5, 5), Qt::CopyAction, &text, Qt::LeftButton, Qt::NoModifier);
  refused.ignore();
  QApplication::sendEvent(page.get(), &refused);
  EXPECT_FALSE(refused.isAccepted());
}

TEST_F(ImportPageTest, german_fits_in_light_and_dark) {
  Mesh open_ball = sphere("Schmelzkappe", {10, 0, 0}, 4.0, 3);
  open_ball.triangles.erase(open_ball.triangles.begin() + 5);
  Mesh twisted = sphere("Wurzelzement und Desmodont der distobukkalen Wurzel", {10, 0, 0}, 2.0, 3);
  std::swap(twisted.triangles[9][0], twisted.triangles[9][1]);
  write_obj(folder / "m.obj", {open_ball, twisted, sphere("Pulpa", {10, 0, 0}, 1.0, 2)});
  write_ct();
  for (const bool dark : {false, true}) {
    install_language(*qApp, QStringLiteral("de"));
    apply_theme(*qApp, dark ? ColourScheme::dark : ColourScheme::light, 100);
    page = std::make_unique<ImportPage>(ports, folder / "cusp.db");
    page->resize(1080, 860);
    page->show();
    picture(dark ? "empty-dark" : "empty-light");
    open({file("m.obj")});
    picture(dark ? "mesh-de-dark" : "mesh-de-light");
    // A line may break; nothing may lie beyond the window.
    for (const QLabel* label : page->findChildren<QLabel*>()) {
      if (!label->isVisible()) continue;
      EXPECT_LE(label->mapTo(page.get(), QPoint(label->width(), 0)).x(), page->width()) << label->text().toStdString();
      EXPECT_GE(label->height(), label->heightForWidth(label->width()) > 0 ? label->heightForWidth(label->width()) : 0) << label->text().toStdString();
    }
    QComboBox* crown = page->meshes()->findChildren<QComboBox*>().front();
    crown->setCurrentIndex(crown->findData(static_cast<int>(Tissue::enamel)));
    page->resize(1080, 1240);
    for (QPushButton* b : page->findChildren<QPushButton*>())
      if (b->objectName() == u"make"_qs) b->click();
    ASSERT_TRUE(QTest::qWaitFor([&] { return !page->busy(); }, kPatienceMs));
    ASSERT_NE(page->preview()->volume(), nullptr);
    picture(dark ? "made-de-dark" : "made-de-light");
    page->open_files({file("ct")});
    ASSERT_TRUE(QTest::qWaitFor([&] { return !page->busy(); }, kPatienceMs));
    picture(dark ? "ct-de-dark" : "ct-de-light");
  }
  install_language(*qApp, QStringLiteral("en"));
  apply_theme(*qApp, ColourScheme::light, 100);
}

}  // namespace
}  // namespace cusp::test

int main(int argc, char** argv) {
  if (const auto status = cusp::scenarios::import_child_main(argc, argv)) return *status;
  const QTemporaryDir home;
  for (const char* name : {"XDG_CONFIG_HOME", "XDG_CACHE_HOME", "XDG_DATA_HOME"}) qputenv(name, home.path().toUtf8());
  if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
  qputenv("LC_ALL", "C.UTF-8");
  QApplication app(argc, argv);
  cusp::ui::install_language(app, QStringLiteral("en"));
  cusp::ui::apply_theme(app, cusp::ui::ColourScheme::light, 100);
  ::testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
