// What a file between stations is refused with where its place takes none.
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

}  // namespace
}  // namespace cusp::test
