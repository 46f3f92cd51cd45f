/// The import page of tests, with a folder for its files.
#pragma once

#include <gtest/gtest.h>

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QRegularExpression>
#include <QTest>

#include "scenarios/import/nrrd.h"
#include "tests/modules.h"
#include "tests/scenarios/import/image_files.h"
#include "ui/instructor/import_forms.h"
#include "ui/instructor/import_page.h"
#include "ui/instructor/import_preview.h"
#include "ui/widgets/parts.h"

namespace cusp::test {

inline constexpr int kPatienceMs = 60'000;  // for a child process on a busy machine; an answer takes a second

/// CT number of a voxel of a scanned tooth: enamel over dentine about a hollow, and a speck beside it.
inline int tooth_at(IVec3 v) {
  const double x = (v.x - 20.0) / 13.0, y = (v.y - 20.0) / 11.0, z = (v.z - 14.0) / 12.0;
  const double r = x * x + y * y + z * z;
  if (v.x > 36 && v.y > 36) return 900;
  if (r > 1.0) return -1000 + (v.x * 7 + v.y * 13 + v.z * 5) % 60;
  if (r < 0.06) return 40;
  return r > 0.6 && z > 0.1 ? 2600 : 1300;
}

struct ImportPageTest : ::testing::Test {
  TempFolder folder;
  Ports ports = Ports::of_the_system();
  std::unique_ptr<ImportPage> page = std::make_unique<ImportPage>(ports, folder / "cusp.db");
  std::optional<EditorStart> started;

  ImportPageTest() {
    page->resize(1080, 900);
    page->show();
    QObject::connect(page.get(), &ImportPage::edit_wanted, [this](const EditorStart& s) { started = s; });
  }
  void open(const QStringList& files) {
    page->open_files(files);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !page->busy(); }, kPatienceMs));
  }
  QString file(const std::string& name) const { return QString::fromStdString((folder / name).string()); }
  QString texts() const {
    QString all;
    for (const QLabel* label : page->findChildren<QLabel*>())
      if (label->isVisibleTo(page.get())) all += label->text() + u'\n';
    return all;
  }
  QPushButton* button(const QString& text) const {
    for (QPushButton* b : page->findChildren<QPushButton*>())
      if (b->text().trimmed() == text) return b;
    return nullptr;
  }
  QComboBox* box(const QString& name) const {
    for (QComboBox* b : page->findChildren<QComboBox*>())
      if (b->accessibleName() == name) return b;
    return nullptr;
  }
  /// Found by the beginning of its text.
  QPushButton* button_from(const QString& text) const {
    for (QPushButton* b : page->findChildren<QPushButton*>())
      if (b->text().startsWith(text) && b->isVisibleTo(page.get())) return b;
    return nullptr;
  }
  void make() {
    button(QStringLiteral("Make a specimen"))->click();
    ASSERT_TRUE(QTest::qWaitFor([&] { return !page->busy(); }, kPatienceMs));
    ASSERT_NE(page->preview()->volume(), nullptr) << page->findChild<Band*>()->text().toStdString();
  }
  void turn(const QString& text) {
    button(text)->click();
    ASSERT_TRUE(QTest::qWaitFor([&] { return !page->preview()->turning(); }, kPatienceMs));
  }
  QPushButton* keep() const { return button(QStringLiteral("Keep it and make an exercise")); }
  void keep_it() {
    keep()->click();
    ASSERT_TRUE(page->busy());
    ASSERT_TRUE(QTest::qWaitFor([&] { return !page->busy(); }, kPatienceMs));
  }
  void choose(const QString& name, Tissue tissue) const {
    QComboBox* b = box(name);
    ASSERT_NE(b, nullptr) << name.toStdString();
    b->setCurrentIndex(b->findData(static_cast<int>(tissue)));
  }
  void write_ct() const {
    std::filesystem::create_directory(folder / "ct");
    for (int n = 0; n < 28; ++n) {
      DicomWish w;
      w.columns = w.rows = 40;
      w.position = {0, 0, 0.5 * n};
      w.across_mm = w.down_mm = 0.3;
      w.thickness_mm = 0.5;
      w.number = n + 1;
      w.values = values_of({40, 40, 1}, [&](IVec3 v) { return tooth_at({v.x, v.y, n}); });
      write_text(folder / ("ct/" + std::to_string(28 - n)), dicom_file(w));
    }
  }
  void picture(const std::string& name) const {
    const QByteArray to = qgetenv("CUSP_PICTURES");
    if (to.isEmpty()) return;
    QTest::qWait(50);
    EXPECT_TRUE(page->grab().save(QString::fromUtf8(to) + u'/' + QString::fromStdString(name) + QStringLiteral(".png")));
  }
};

}  // namespace cusp::test
