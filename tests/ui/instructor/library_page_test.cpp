// The library's page: what its filters leave, and what it says of the chosen exercise.

#include <gtest/gtest.h>

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>

#include "scenarios/library/library.h"
#include "tests/modules.h"
#include "tests/ui/desk_records.h"
#include "tests/ui/looks.h"
#include "ui/instructor/exercise_card.h"
#include "ui/instructor/library_page.h"
#include "ui/student/exercise_groups.h"
#include "ui/widgets/chip.h"
#include "ui/widgets/table.h"

namespace cusp::test {
namespace {

struct LibraryOf : ::testing::Test {
  DeskRecords records;
  TempFolder cache;
  Ports ports = Ports::of_the_system();
  Account berg;
  std::unique_ptr<LibraryPage> page;

  void SetUp() override {
    berg = *records.store().accounts.create(records.administrator().actor(), {"berg", "Mara Berg", Role::instructor, "correct horse", ""});
    page = std::make_unique<LibraryPage>(records.store(), berg.actor(), ports, records.file(), cache.path());
    page->resize(1080, 752);
    page->show();
  }
  int shown() const {
    int out = 0;
    for (int row = 0; row < page->model().rowCount(); ++row) out += !page->table()->isRowHidden(row);
    return out;
  }
  void choose(QComboBox& box, int value) { box.setCurrentIndex(box.findData(value)); }
  QStringList texts() const {
    QStringList out;
    for (const QLabel* label : page->findChild<ExerciseCard*>()->findChildren<QLabel*>())
      if (label->isVisible()) out << label->text();
    return out;
  }
};

TEST_F(LibraryOf, the_rows_of_a_group_and_state_are_found) {
  const int all = page->model().rowCount();
  EXPECT_EQ(all, static_cast<int>(builtin_scenarios().size()));
  choose(*page->groups(), static_cast<int>(ExerciseGroup::class_2));
  const int class_2 = shown();
  EXPECT_GT(class_2, 0);
  EXPECT_LT(class_2, all);
  EXPECT_EQ(group_of(page->model().row(page->table()->chosen_row()).shown()), ExerciseGroup::class_2) << "what is hidden is not chosen";
  choose(*page->states(), static_cast<int>(LibraryState::delivered));
  EXPECT_EQ(shown(), class_2) << "with a new database all come with the program";
  choose(*page->states(), static_cast<int>(LibraryState::draft));
  EXPECT_EQ(shown(), 0);
  EXPECT_FALSE(page->findChild<ExerciseCard*>()->isVisible());
  page->states()->setCurrentIndex(0);
  page->groups()->setCurrentIndex(0);
  EXPECT_EQ(shown(), all);
}

TEST_F(LibraryOf, what_comes_with_the_program_has_no_sign_and_no_draft_no_column) {
  const QModelIndex state = page->model().index(0, LibraryModel::kState);
  EXPECT_EQ(state.data(ChipRole).toInt(), static_cast<int>(Chip::Kind::plain));
  EXPECT_TRUE(page->table()->isColumnHidden(LibraryModel::kSaved));
}

TEST_F(LibraryOf, what_was_drilled_here_still_comes_with_the_program) {
  ASSERT_GT(load_builtin("class-1-36")->version, 1);
  records.attempt(records.student("4711", "Lena Brandt"), "class-1-36", 81, 60);
  const auto library = load_library(records.store(), berg.actor());
  ASSERT_TRUE(library);
  for (const LibraryRow& row : library->rows) EXPECT_EQ(state_of(row), LibraryState::delivered) << row.shown().key;
}

TEST_F(LibraryOf, the_chosen_exercise_says_what_it_is_and_who_uses_it) {
  page->search()->setText(QStringLiteral("Straight channel, level 1"));
  const QString all = texts().join(u'\n');
  EXPECT_TRUE(all.contains(QStringLiteral("Straight channel, level 1"))) << all.toStdString();
  EXPECT_TRUE(all.contains(QStringLiteral("pass mark 70"))) << all.toStdString();
  EXPECT_TRUE(all.contains(QStringLiteral("Burs: "))) << all.toStdString();
  EXPECT_TRUE(all.contains(QStringLiteral("No student has a graded attempt yet."))) << all.toStdString();
  EXPECT_FALSE(page->table()->isColumnHidden(LibraryModel::kGroup));
  page->resize(kPageAtHalfOfFullHd);
  EXPECT_TRUE(page->table()->isColumnHidden(LibraryModel::kGroup)) << "the names need the width";
  EXPECT_FALSE(texts().join(u'\n').contains(QStringLiteral("Burs: "))) << "the list needs the height";
}

}  // namespace
}  // namespace cusp::test
