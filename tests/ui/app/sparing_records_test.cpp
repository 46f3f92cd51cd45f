// The file picker of the desktop: nothing is saved over the records.
#include <gtest/gtest.h>

#include <QTemporaryDir>
#include <QWidget>
#include <fstream>

#include "tests/modules.h"
#include "ui/app/sparing_records.h"

namespace cusp::test {
namespace {

struct SparingRecordsTest : ::testing::Test {
  QTemporaryDir folder;
  QWidget window;
  QStringList answers, questions;  // of the picker, first to last; and what was asked
  bool again = true;
  QString path(const char* name) const { return folder.filePath(QString::fromUtf8(name)); }
  /// What the caller of the picker gets; empty: nothing.
  QString picked(bool saving) {
    Ports answered;
    answered.pick_file = [this](QWidget*, const FileWish&, const std::function<void(const QString&)>& then) { then(answers.takeFirst()); };
    answered.ask = [this](QWidget*, const Question& question, const std::function<void(bool)>& then) {
      questions += question.what;
      then(again);
    };
    QString got;
    const Ports ports = sparing_records(answered, path("cusp.db").toStdString());
    ports.pick_file(&window, {.title = {}, .name = {}, .filter = {}, .saving = saving}, [&](const QString& file) { got = file; });
    return got;
  }
};

TEST_F(SparingRecordsTest, a_name_of_the_records_is_refused_and_another_one_taken) {
  answers = {path("cusp.db"), path("cusp.db.key"), path("attempts.csv")};
  EXPECT_EQ(picked(true), path("attempts.csv"));
  EXPECT_EQ(questions, QStringList({QStringLiteral("cusp.db belongs to the records."), QStringLiteral("cusp.db.key belongs to the records.")}));
}

TEST_F(SparingRecordsTest, the_records_of_another_station_are_spared_too) {
  for (const char* name : {"office.db", "office.db.key"}) std::ofstream(path(name).toStdString()) << "records";
  answers = {path("office.db")};
  again = false;
  EXPECT_EQ(picked(true), QString());
  EXPECT_EQ(questions.size(), 1);
}

TEST_F(SparingRecordsTest, a_file_of_the_records_may_be_opened) {
  answers = {path("cusp.db")};
  EXPECT_EQ(picked(false), path("cusp.db"));
  EXPECT_TRUE(questions.isEmpty());
}

}  // namespace
}  // namespace cusp::test
