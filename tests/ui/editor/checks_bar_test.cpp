// The editor's bar of checks.

#include <gtest/gtest.h>

#include <QLabel>
#include <QToolButton>
#include <algorithm>
#include <vector>

#include "tests/modules.h"
#include "tests/ui/editor/editor_pages.h"
#include "ui/editor/check_messages.h"
#include "ui/editor/editor_page.h"

namespace cusp::test {
namespace {

TEST_F(EditorPages, all_that_the_checks_find_can_be_read_one_after_the_other) {
  const auto page = open();
  ASSERT_TRUE(page->model().set_leeway(0.1, 0.2));  // both finer than the tooth
  const std::vector<Finding> found = page->model().findings();
  ASSERT_GE(found.size(), 2u);
  auto* next = named<QToolButton>(*page, "Next check");
  ASSERT_TRUE(next != nullptr && next->isVisible());
  const auto shows = [&](const QString& text) {
    const QList<QLabel*> labels = page->findChildren<QLabel*>();
    return std::ranges::any_of(labels, [&](const QLabel* label) { return label->text() == text; });
  };
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_TRUE(shows(check_message(found[i], &page->model().scenario().target))) << found[i].code;
    EXPECT_TRUE(shows(QStringLiteral("%1 of %2 things to look at").arg(i + 1).arg(found.size())));
    next->click();
  }
  EXPECT_TRUE(shows(check_message(found[0], &page->model().scenario().target))) << "after the last comes the first";
  page->model().stack().undo();
  EXPECT_EQ(next->isVisible(), page->model().findings().size() > 1);
}

}  // namespace
}  // namespace cusp::test
