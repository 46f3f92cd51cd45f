// What the page Help says of marking.
#include <gtest/gtest.h>

#include <QLabel>

#include "tests/modules.h"
#include "ui/app/help_page.h"
#include "ui/student/briefing.h"

namespace cusp::test {
namespace {

TEST(HelpPage, says_of_time_that_it_earns_points_where_the_briefing_lists_it) {
  const HelpPage page(Role::student);
  int sentences = 0;
  for (const QLabel* label : page.findChildren<QLabel*>()) {
    EXPECT_FALSE(label->text().contains(QStringLiteral("Time earns no points")));
    sentences += label->text().startsWith(QStringLiteral("Time earns points only")) && label->text().contains(Briefing::tr("What earns points"));
  }
  EXPECT_EQ(sentences, 1);
}

}  // namespace
}  // namespace cusp::test
