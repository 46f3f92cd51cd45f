// Files on a disk that takes no more.

#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QPushButton>
#include <QTemporaryDir>

#include "tests/file_limit.h"
#include "tests/modules.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/save_csv.h"
#include "ui/widgets/save_bytes.h"

namespace cusp::test {
namespace {

QByteArray content_of(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

TEST(SaveBytes, ThatIsCutShortLeavesTheOldOneAndNamesTheCause) {
  const QTemporaryDir folder;
  const QString path = folder.filePath(QStringLiteral("list.csv"));
  ASSERT_TRUE(save_bytes(path, "old"));
  constexpr int kRoom = 4096;
  for (const int size : {2 * kRoom, 100 * kRoom}) {  // within QFile's buffer, and beyond it
    const auto written = with_files_up_to(kRoom, [&] { return save_bytes(path, QByteArray(size, 'x')); });
    ASSERT_FALSE(written) << size;
    EXPECT_EQ(written.error().toStdString(), "File too large") << size;
    EXPECT_EQ(content_of(path), "old") << size;
    EXPECT_EQ(QDir(folder.path()).entryList(QDir::Files).size(), 1) << size;
  }
  ASSERT_TRUE(save_bytes(path, QByteArray(100 * kRoom, 'x')));
  EXPECT_EQ(content_of(path).size(), 100 * kRoom);
}

TEST(SaveBytes, ForTheOwnerAloneAreSoWhereTheyReplaceAFileForAll) {
  const QTemporaryDir folder;
  const QString path = folder.filePath(QStringLiteral("slips.pdf"));
  ASSERT_TRUE(save_bytes(path, "old"));
  ASSERT_TRUE(QFile::setPermissions(path, QFile::permissions(path) | QFileDevice::ReadGroup | QFileDevice::ReadOther));
  ASSERT_TRUE(save_bytes(path, "new", Readers::owner));
  EXPECT_EQ(content_of(path), "new");
  EXPECT_EQ((QFile::permissions(path) & (QFileDevice::ReadGroup | QFileDevice::ReadOther)).toInt(), 0);
}

TEST(SaveBytes, OfAListThatIsCutShortIsReportedWithTheCause) {
  const QTemporaryDir folder;
  const QString path = folder.filePath(QStringLiteral("list.csv"));
  Ports ports = Ports::of_the_system();
  ports.pick_file = [&](QWidget*, const FileWish&, const std::function<void(const QString&)>& then) { then(path); };
  Band band;
  with_files_up_to(4096, [&] {
    save_csv(band, ports, {.title = {}, .name = {}, .make = [] { return CsvText{std::string(100'000, 'x'), QStringLiteral("Done.")}; }});
    return 0;
  });
  EXPECT_TRUE(band.text().contains(QStringLiteral("File too large"))) << band.text().toStdString();
  EXPECT_FALSE(QFile::exists(path));
}

}  // namespace
}  // namespace cusp::test
