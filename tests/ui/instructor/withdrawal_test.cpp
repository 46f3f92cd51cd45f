// The library's page takes a published version back from the students.

#include <gtest/gtest.h>

#include <filesystem>
#include <utility>

#include "scenarios/blocks/blocks.h"
#include "scenarios/format/content_hash.h"
#include "scenarios/format/write.h"
#include "scenarios/library/library.h"
#include "tests/modules.h"
#include "tests/scenarios/import/mesh_files.h"
#include "tests/ui/desk_records.h"
#include "tests/ui/publish_draft.h"
#include "ui/editor/editor_records.h"
#include "ui/instructor/import_page.h"
#include "ui/instructor/library_page.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/table.h"

namespace cusp::test {
namespace {

struct Withdrawals : ::testing::Test {
  DeskRecords records;
  TempFolder cache;
  Ports ports = Ports::of_the_system();
  Account instructor;
  bool answer = true;
  std::vector<Question> asked;
  std::vector<EditorStart> opened;
  std::unique_ptr<LibraryPage> page;

  void SetUp() override {
    instructor = *records.store().accounts.create(records.administrator().actor(),
                                                  {"berg", "Mara Berg", Role::instructor, "correct horse", ""});
    ports.now = [] { return QDateTime(QDate(2026, 11, 20), QTime(12, 0)); };
    ports.ask = [this](QWidget*, const Question& question, std::function<void(bool)> then) {
      asked.push_back(question);
      then(answer);
    };
  }
  /// Publishes through the editor's model, with facts of the block that it is on.
  ScenarioVersion publish_start(const EditorStart& start) {
    EditorModel model(start);
    model.set_facts(SpecimenFacts{{-10, -10, -10}, {10, 10, 0}, start.draft.specimen.voxel_mm, {Tissue::plastic}});
    std::optional<std::string> draft = start.kept;
    const auto version = publish_draft(records.store(), instructor.actor(), model, draft);
    EXPECT_TRUE(version.has_value());
    return *version;
  }
  Exercise here(ScenarioId id) {
    const auto list = load_exercises(records.store());
    const Exercise* found = list->find(id);
    return found ? *found : Exercise{};
  }
  /// channel-1 with another depth, as its version 4.
  ScenarioVersion publish_deeper() {
    EditorStart start = *open_for_editing(records.store(), instructor.actor(), here(load_builtin("channel-1")->id), records.file(), cache.path());
    start.draft.target.outline.depth_mm = 2.2;
    return publish_start(start);
  }
  const LibraryRow* show_and_choose(ScenarioId id) {
    page = std::make_unique<LibraryPage>(records.store(), instructor.actor(), ports, records.file(), cache.path());
    page->show();
    QObject::connect(page.get(), &LibraryPage::edit_wanted, [this](const EditorStart& start) { opened.push_back(start); });
    return row(id);
  }
  const LibraryRow* row(ScenarioId id) {
    for (int i = 0; i < page->model().rowCount(); ++i)
      if (page->model().row(i).shown().id == id) {
        page->table()->choose_row(i);
        return &page->model().row(i);
      }
    return nullptr;
  }
  QString state() const {
    return page->model().index(page->table()->chosen_row(), LibraryModel::kState).data().toString();
  }
};

TEST_F(Withdrawals, HappenAfterAQuestionAndBringTheVersionBeforeBack) {
  const ScenarioVersion version = publish_deeper();
  ASSERT_TRUE(show_and_choose(version.scenario)->withdrawable);
  answer = false;
  page->withdraw_chosen();
  ASSERT_EQ(asked.size(), 1u);
  EXPECT_TRUE(asked[0].what.contains(QStringLiteral("Withdraw version 4"))) << asked[0].what.toStdString();
  EXPECT_TRUE(asked[0].more.contains(QStringLiteral("version 3 again"))) << asked[0].more.toStdString();
  EXPECT_TRUE(asked[0].more.contains(QStringLiteral("Results and reports stay")));
  EXPECT_FALSE(*records.store().scenarios.withdrawn(version.id));
  answer = true;
  page->withdraw_chosen();
  EXPECT_TRUE(*records.store().scenarios.withdrawn(version.id));
  EXPECT_DOUBLE_EQ(here(version.scenario).scenario.target.outline.depth_mm, 2.0);
  EXPECT_EQ(row(version.scenario)->withdrawn, 4);
  EXPECT_EQ(state(), QStringLiteral("Version 4 withdrawn"));
  EXPECT_FALSE(row(version.scenario)->withdrawable) << "the program's own version cannot be withdrawn";
  EXPECT_TRUE(records.store().scenarios.version(version.id).has_value()) << "the version stays in the records";
}

TEST_F(Withdrawals, ThatAnotherDeskMadeMeanwhileAreNoFailure) {
  const ScenarioVersion version = publish_deeper();
  show_and_choose(version.scenario);
  ports.ask = [&](QWidget*, const Question&, const std::function<void(bool)>& then) {
    EXPECT_TRUE(records.store().scenarios.withdraw(instructor.actor(), version.id));
    then(true);
  };
  page->withdraw_chosen();
  EXPECT_TRUE(page->findChild<Band*>()->text().startsWith(QStringLiteral("Version 4 of "))) << page->findChild<Band*>()->text().toStdString();
  EXPECT_EQ(state(), QStringLiteral("Version 4 withdrawn"));
}

TEST_F(Withdrawals, AskAnewIfAnotherDeskWithdrewTheVersionBeforeMeanwhile) {
  EditorStart start = *exercise_on(dexterity_block(0.4), "Block from a scan", records.file());
  const ScenarioVersion first = publish_start(start);
  start = *open_for_editing(records.store(), instructor.actor(), here(first.scenario), records.file(), cache.path());
  start.draft.target.outline.depth_mm = 2.2;
  const ScenarioVersion second = publish_start(start);
  ASSERT_EQ(second.number, 2);
  show_and_choose(first.scenario);
  const auto answer_at_once = std::exchange(ports.ask, [&](QWidget*, const Question& question, const std::function<void(bool)>& then) {
    EXPECT_TRUE(question.more.contains(QStringLiteral("version 1 again"))) << question.more.toStdString();
    EXPECT_TRUE(records.store().scenarios.withdraw(instructor.actor(), first.id));
    then(true);
  });
  page->withdraw_chosen();
  EXPECT_FALSE(*records.store().scenarios.withdrawn(second.id)) << "nobody was asked whether students find none";
  EXPECT_TRUE(page->findChild<Band*>()->text().contains(QStringLiteral("changed meanwhile"))) << page->findChild<Band*>()->text().toStdString();
  ports.ask = answer_at_once;
  page->withdraw_chosen();
  ASSERT_EQ(asked.size(), 1u);
  EXPECT_TRUE(asked[0].more.contains(QStringLiteral("you keep it as a draft"))) << asked[0].more.toStdString();
  EXPECT_TRUE(*records.store().scenarios.withdrawn(second.id));
  ASSERT_NE(row(first.scenario), nullptr) << "else nobody could edit it again";
  EXPECT_EQ(state(), QStringLiteral("Withdrawn"));
}

TEST_F(Withdrawals, AskAnewIfTheListIsOlderThanTheNewestVersion) {
  const ScenarioVersion fourth = publish_deeper();
  show_and_choose(fourth.scenario);
  EditorStart start = *open_for_editing(records.store(), instructor.actor(), here(fourth.scenario), records.file(), cache.path());
  start.draft.target.outline.depth_mm = 2.1;
  const ScenarioVersion fifth = publish_start(start);
  page->withdraw_chosen();
  EXPECT_TRUE(asked.empty()) << "students would not find version 3 again";
  EXPECT_FALSE(*records.store().scenarios.withdrawn(fourth.id));
  page->withdraw_chosen();
  ASSERT_EQ(asked.size(), 1u);
  EXPECT_TRUE(asked[0].what.contains(QStringLiteral("Withdraw version 5"))) << asked[0].what.toStdString();
  EXPECT_TRUE(*records.store().scenarios.withdrawn(fifth.id));
}

TEST_F(Withdrawals, LeaveTheNumberTaken) {
  const ScenarioVersion version = publish_deeper();
  show_and_choose(version.scenario);
  page->withdraw_chosen();
  page->open_chosen();
  ASSERT_EQ(opened.size(), 1u);
  EXPECT_EQ(opened[0].published->version, 3);
  EXPECT_EQ(opened[0].draft.version, 5);
  EditorStart again = opened[0];
  again.draft.target.outline.depth_mm = 2.2;
  EXPECT_EQ(publish_start(again).number, 5) << "with the values of the withdrawn version";
  show_and_choose(version.scenario);
  EXPECT_EQ(state(), QStringLiteral("Published"));
}

TEST_F(Withdrawals, OfTheOnlyVersionKeepTheExerciseAsADraftThatCanBePublishedAgain) {
  const EditorStart first = *exercise_on(dexterity_block(0.4), "Block from a scan", records.file());
  const ScenarioVersion version = publish_start(first);
  std::filesystem::remove_all(first.folder);
  show_and_choose(version.scenario);
  page->withdraw_chosen();
  ASSERT_EQ(asked.size(), 1u);
  EXPECT_TRUE(asked[0].more.contains(QStringLiteral("no longer find"))) << asked[0].more.toStdString();
  EXPECT_TRUE(here(version.scenario).scenario.title.empty()) << "students find nothing";
  ASSERT_NE(row(version.scenario), nullptr);
  EXPECT_EQ(state(), QStringLiteral("Withdrawn"));
  page->withdraw_chosen();
  EXPECT_EQ(asked.size(), 1u) << "there is nothing left to withdraw";
  answer = false;
  page->discard_draft();
  ASSERT_EQ(asked.size(), 2u);
  EXPECT_FALSE(asked[1].more.contains(QStringLiteral("never published"))) << asked[1].more.toStdString();
  EXPECT_TRUE(asked[1].more.contains(QStringLiteral("Results and reports stay"))) << asked[1].more.toStdString();
  page->open_chosen();
  ASSERT_EQ(opened.size(), 1u);
  EXPECT_TRUE(std::filesystem::exists(std::filesystem::path(opened[0].folder) / "specimen.nrrd"));
  EXPECT_EQ(publish_start(opened[0]).number, 2);
  show_and_choose(version.scenario);
  EXPECT_EQ(state(), QStringLiteral("Published"));
}

TEST_F(Withdrawals, NameTheOpenAssignmentsOfTheVersion) {
  const ScenarioVersion version = publish_deeper();
  const auto cohort = records.store().cohorts.create(instructor.actor(), "Year 3");
  ASSERT_TRUE(records.store().assignments.create(instructor.actor(), {.version = version.id, .cohort = cohort->id}).has_value());
  show_and_choose(version.scenario);
  answer = false;
  page->withdraw_chosen();
  EXPECT_TRUE(asked[0].more.contains(QStringLiteral("1 open assignment"))) << asked[0].more.toStdString();
}

TEST_F(Withdrawals, AreNotOfferedForWhatComesWithTheProgram) {
  EXPECT_FALSE(show_and_choose(load_builtin("channel-1")->id)->withdrawable);
  page->withdraw_chosen();
  EXPECT_TRUE(asked.empty());
}

}  // namespace
}  // namespace cusp::test
