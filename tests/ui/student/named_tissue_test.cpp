// How the start page names a tissue of an author's own volume.
#include <gtest/gtest.h>

#include <QLabel>
#include <algorithm>
#include <filesystem>

#include "tests/modules.h"
#include "tests/ui/published_block.h"
#include "tests/ui/student/start_page_cards.h"

namespace cusp::test {
namespace {

TEST_F(StartPageCards, advice_names_a_tissue_as_the_volume_does) {
  const std::filesystem::path folder = cache.path().toStdString();
  Store& store = records.store();
  ASSERT_NO_FATAL_FAILURE(publish_named_block(store, examiner, folder));
  Grade grade = sample_grade(80);
  grade.criteria[1].id = "removed_16";
  grade.criteria[1].reason_code = "too_much";
  records.graded_attempt(lena, "channel-1", grade, 300);
  const StartPage start(store, lena, pictures, now, "pointer", folder);
  const QList<QLabel*> labels = start.findChildren<QLabel*>();
  EXPECT_TRUE(std::ranges::any_of(labels, [](const QLabel* label) { return label->text().contains(QStringLiteral("<b>pulp stone removed:</b>")); }));
}

}  // namespace
}  // namespace cusp::test
