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

TEST(HelpPage, lists_the_keys_that_nothing_else_on_the_screen_shows) {
  const HelpPage page(Role::student);
  QStringList texts;
  for (const QLabel* label : page.findChildren<QLabel*>()) texts += label->text();
  EXPECT_TRUE(texts.contains(QStringLiteral("have the values read aloud (screen reader)")));
  EXPECT_TRUE(texts.contains(QStringLiteral("hide the panel at the right, show it")));
  EXPECT_TRUE(texts.contains(QStringLiteral("find an exercise by its name")));
}

}  // namespace
}  // namespace cusp::test
