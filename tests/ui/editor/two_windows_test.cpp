// One draft in two windows, each with a store of its own as two processes have: the second one to save gets the choice.
#include <gtest/gtest.h>

#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>

#include "scenarios/format/read.h"
#include "scenarios/library/library.h"
#include "tests/modules.h"
#include "tests/ui/desk_records.h"
#include "ui/editor/editor_page.h"
#include "ui/editor/editor_records.h"
#include "tests/ui/editor/editor_pages.h"
#include "tests/ui/whole_texts.h"
#include "ui/instructor/library_page.h"
#include "ui/text/language.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/table.h"
#include "ui/widgets/theme.h"

namespace cusp::test {
namespace {

struct TwoWindows : ::testing::Test {
  test::DeskRecords records;
  std::unique_ptr<Store> other;
  Ports ports = Ports::of_the_system();
  QStringList asked;
  bool answer = true;
  Account instructor;
  std::unique_ptr<EditorPage> first, second;

  void SetUp() override {
    instructor = *records.store().accounts.create(records.administrator().actor(),
                                             {"berg", "Mara Berg", Role::instructor, "correct horse", ""});
    auto opened = Store::open(records.file());
    ASSERT_TRUE(opened.has_value());
    other = std::move(*opened);
    ports.ask = [this](QWidget*, const Question& question, std::function<void(bool)> then) {
      asked << question.act;
      then(answer);
    };
    first = open(records.store());
    second = open(*other);
    first->model().set_depth_mm(2.4);
    ASSERT_TRUE(save(*first));
    second->model().set_width_mm(1.9);
  }
  std::unique_ptr<EditorPage> open(Store& store) {
    EditorStart start;
    start.published = *load_builtin("channel-1");
    start.published->specimen.voxel_mm = 0.4;  // so that it grows at once
    start.draft = *start.published;
    start.draft.version = start.published->version + 1;
    start.folder = drafts_folder(records.file(), start.draft.id).string();
    if (const auto draft = store.scenarios.draft(instructor.actor(), start.draft.id); draft && *draft) {
      start.kept = (*draft)->json;
      start.draft = *read_scenario((*draft)->json);
    }
    auto page = std::make_unique<EditorPage>(store, instructor.actor(), ports, start);
    page->show();
    return page;
  }
  /// By leaving, as Alt+Left does; false where the page stays.
  static bool save(EditorPage& page) {
    QSignalSpy left(&page, &EditorPage::back_wanted);
    page.leave();
    return left.count() == 1;
  }
  static Band* warning(EditorPage& page) {
    for (Band* band : page.findChildren<Band*>())
      if (!band->isHidden() && band->text().contains(QStringLiteral("nother window"))) return band;
    return nullptr;
  }
  static QPushButton* button(EditorPage& page, const char* text) {
    for (QPushButton* b : page.findChildren<QPushButton*>())
      if (b->text() == QLatin1String(text) && b->isVisibleTo(&page)) return b;
    return nullptr;
  }
  std::vector<Scenario> drafts() {
    std::vector<Scenario> out;
    const auto kept = records.store().scenarios.drafts(instructor.actor());
    for (const ScenarioDraft& d : *kept) out.push_back(*read_scenario(d.json));
    return out;
  }
};

TEST_F(TwoWindows, the_second_to_save_is_warned_and_nothing_is_written) {
  EXPECT_FALSE(save(*second));
  ASSERT_NE(warning(*second), nullptr);
  ASSERT_EQ(drafts().size(), 1u);
  EXPECT_DOUBLE_EQ(drafts()[0].target.outline.depth_mm, 2.4);
  EXPECT_DOUBLE_EQ(second->model().scenario().target.outline.width_mm, 1.9) << "what was done here stands";
  EXPECT_FALSE(save(*second)) << "until one chooses";
  EXPECT_TRUE(asked.isEmpty());
}

TEST_F(TwoWindows, the_three_ways_stand_whole_in_1280_by_800_pixels_at_200_percent_in_german) {
  install_language(*qApp, QStringLiteral("de"));
  apply_theme(*qApp, ColourScheme::light, 200);
  second = open(*other);
  second->resize(1280, 800);
  first->model().set_depth_mm(2.6);
  ASSERT_TRUE(save(*first));
  second->model().set_width_mm(1.9);
  ASSERT_FALSE(save(*second));
  const Band* band = nullptr;
  for (const Band* one : second->findChildren<Band*>())
    if (one->isVisible() && one->findChildren<QPushButton*>().size() == 3) band = one;
  ASSERT_NE(band, nullptr);
  const auto whole = [&] {
    for (const QPushButton* one : band->findChildren<QPushButton*>())
      if (clipped(*one) || !band->rect().contains(one->geometry())) return false;
    return true;
  };
  EXPECT_TRUE(QTest::qWaitFor(whole));
  EXPECT_EQ(second->size(), QSize(1280, 800)) << "the band pushes nothing beyond the window";
  for (const QLabel* text : band->findChildren<QLabel*>()) EXPECT_FALSE(clipped(*text)) << described(*text);
  apply_theme(*qApp, ColourScheme::light, 100);
  install_language(*qApp, QStringLiteral("en"));
}

TEST_F(TwoWindows, mine_is_kept_as_a_copy_and_theirs_stays) {
  save(*second);
  QSignalSpy copied(second.get(), &EditorPage::copied);
  button(*second, "Keep mine as a copy")->click();
  ASSERT_EQ(copied.count(), 1);
  const auto all = drafts();
  ASSERT_EQ(all.size(), 2u);
  const Scenario& mine = all[0].target.outline.width_mm == 1.9 ? all[0] : all[1];
  const Scenario& theirs = all[0].target.outline.width_mm == 1.9 ? all[1] : all[0];
  EXPECT_DOUBLE_EQ(mine.target.outline.width_mm, 1.9);
  EXPECT_NE(mine.id, theirs.id);
  EXPECT_TRUE(mine.title.at("en").ends_with("(copy)"));
  EXPECT_DOUBLE_EQ(theirs.target.outline.depth_mm, 2.4);
  EXPECT_EQ(theirs.id, second->model().scenario().id);
}

TEST_F(TwoWindows, theirs_is_seen_and_undo_brings_mine_back) {
  save(*second);
  button(*second, "See theirs")->click();
  EXPECT_EQ(second->model().scenario(), first->model().scenario());
  EXPECT_TRUE(save(*second));
  second->model().stack().undo();
  EXPECT_DOUBLE_EQ(second->model().scenario().target.outline.width_mm, 1.9);
  EXPECT_DOUBLE_EQ(second->model().scenario().target.outline.depth_mm, 2.0);
  // Who continues from there has seen what is replaced; and now the first window is the second to save.
  EXPECT_TRUE(save(*second));
  first->model().set_depth_mm(2.6);
  EXPECT_FALSE(save(*first));
}

TEST_F(TwoWindows, theirs_is_replaced_only_after_asking) {
  save(*second);
  answer = false;
  button(*second, "Replace theirs")->click();
  EXPECT_DOUBLE_EQ(drafts()[0].target.outline.depth_mm, 2.4);
  answer = true;
  button(*second, "Replace theirs")->click();
  EXPECT_EQ(asked, QStringList({QStringLiteral("Replace theirs"), QStringLiteral("Replace theirs")}));
  EXPECT_DOUBLE_EQ(drafts()[0].target.outline.width_mm, 1.9);
  EXPECT_DOUBLE_EQ(drafts()[0].target.outline.depth_mm, 2.0);
  EXPECT_EQ(warning(*second), nullptr);
  EXPECT_TRUE(save(*second));
}

TEST_F(TwoWindows, a_window_that_changed_nothing_is_left_in_peace) {
  auto third = open(*other);
  first->model().set_depth_mm(2.5);
  ASSERT_TRUE(save(*first));
  EXPECT_TRUE(save(*third));
  EXPECT_DOUBLE_EQ(drafts()[0].target.outline.depth_mm, 2.5);
}

TEST_F(TwoWindows, a_window_that_is_closed_before_one_chose_leaves_both) {
  second->keep_before_closing();
  ASSERT_EQ(drafts().size(), 2u);
}

TEST_F(TwoWindows, a_draft_that_was_published_in_the_other_window_is_named_and_undoing_all_deletes_nothing) {
  QSignalSpy ready(first.get(), &EditorPage::ready);
  ASSERT_TRUE(first->grown() || ready.wait(60'000));
  ASSERT_TRUE(open_sheet(*first));
  ASSERT_TRUE(publish_by_sheet(*first));
  EXPECT_EQ(asked, QStringList{QStringLiteral("Publish untried")});
  EXPECT_TRUE(drafts().empty());
  EXPECT_TRUE(save(*second)) << "none was kept when it was opened, and none is now";
  QSignalSpy grown(second.get(), &EditorPage::ready);
  ASSERT_TRUE(second->grown() || grown.wait(60'000));
  ASSERT_TRUE(open_sheet(*second));
  PublishSheet* sheet = sheet_of(*second);
  ASSERT_NE(sheet, nullptr);
  EXPECT_EQ(sheet->publish()->text(), QStringLiteral("Publish version 5"));
  const Band* band = sheet->findChild<Band*>();
  ASSERT_NE(band, nullptr);
  EXPECT_TRUE(band->text().contains(QStringLiteral("Another window has published version 4")));
  sheet->reject();
  EXPECT_EQ(records.store().scenarios.versions(second->model().scenario().id)->size(), 2u);
  ASSERT_TRUE(open_sheet(*second));
  ASSERT_TRUE(publish_by_sheet(*second));
  EXPECT_EQ(records.store().scenarios.versions(second->model().scenario().id)->size(), 3u);
}

TEST_F(TwoWindows, undoing_everything_here_drops_no_draft_of_the_other_window) {
  second->model().stack().undo();
  EXPECT_TRUE(save(*second));
  EXPECT_EQ(drafts().size(), 1u);
}

TEST_F(TwoWindows, a_draft_that_changed_since_the_list_was_read_is_not_discarded) {
  LibraryPage library(records.store(), instructor.actor(), ports, records.file(), records.file().parent_path());
  library.show();
  for (int i = 0; i < library.model().rowCount(); ++i)
    if (library.model().row(i).draft) library.table()->choose_row(i);
  first->model().set_depth_mm(2.7);
  ASSERT_TRUE(save(*first));
  library.discard_draft();
  ASSERT_EQ(drafts().size(), 1u);
  EXPECT_DOUBLE_EQ(drafts()[0].target.outline.depth_mm, 2.7);
  library.discard_draft();
  EXPECT_TRUE(drafts().empty());
}

}  // namespace
}  // namespace cusp::test
