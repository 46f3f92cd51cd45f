// What is shown of a file between stations that was read, and why one is refused where its place takes none.
#include <gtest/gtest.h>

#include "tests/modules.h"
#include "ui/text/exchange_text.h"

namespace cusp::test {
namespace {

const QString kFile = QStringLiteral("/media/stick/results");

QString refused(StorageError code, const char* where, const char* detail = "") { return describe_exchange_failure({code, where, detail}, kFile).what; }

TEST(ExchangeFailures, OfAPlaceAreNoneOfTheRecords) {
  EXPECT_EQ(refused(StorageError::read_only, "/media/stick/results", "Read-only file system").toStdString(), "This file cannot be opened.");
  EXPECT_EQ(refused(StorageError::not_found, "/media/stick", "folder").toStdString(), "There is no such folder.");
  EXPECT_EQ(refused(StorageError::not_found, "/media/stick/results").toStdString(), "This file is not there.");
}

TEST(ExchangeFailures, OfTheRecordsNameThese) {
  const StorageFailure of_records{StorageError::read_only, "/home/station.db", {}};
  EXPECT_EQ(describe_exchange_failure(of_records, kFile).line(), describe(of_records).line());
}

TEST(ExchangeFailures, OfRecordsThatAreHeldNameAWindowThatReadsAFileIn) {
  const QString more = describe(StorageFailure{StorageError::busy, "/home/station.db"}).more;
  EXPECT_TRUE(more.contains(QStringLiteral("reads in a file of another station"))) << more.toStdString();
}

TEST(ReadInText, NamesHowManyAccountsGaveWay) {
  ReadIn read;
  EXPECT_EQ(read_in_text(read).size(), 1);
  read.gave_way = {"1001", "1002"};
  const QStringList texts = read_in_text(read);
  ASSERT_EQ(texts.size(), 2);
  EXPECT_TRUE(texts[1].startsWith(u'2')) << texts[1].toStdString();
}

TEST(ReadInText, CallsAnAttemptThatWasHereNotNew) {
  ReadIn read;
  read.counts.sessions = 3;
  read.grown = 1;
  const QStringList texts = read_in_text(read);
  ASSERT_EQ(texts.size(), 2);
  EXPECT_EQ(texts[0].toStdString(), "New here: 2 attempts.");
  EXPECT_TRUE(texts[1].contains(QStringLiteral("gone on"))) << texts[1].toStdString();
}

}  // namespace
}  // namespace cusp::test
