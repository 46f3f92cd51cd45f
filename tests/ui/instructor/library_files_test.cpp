// The library's page and files: an exercise goes out as NAME.cusp and comes in as a draft.

#include <gtest/gtest.h>

#include <QComboBox>
#include <QDropEvent>
#include <QLabel>
#include <QMimeData>
#include <QSignalSpy>
#include <QTest>
#include <QUrl>
#include <filesystem>
#include <thread>

#include "scenarios/blocks/blocks.h"
#include "scenarios/format/write.h"
#include "scenarios/import/nrrd.h"
#include "scenarios/library/library.h"
#include "tests/file_limit.h"
#include "tests/modules.h"
#include "tests/scenarios/import/mesh_files.h"
#include "tests/ui/desk_records.h"
#include "tests/ui/instructor/library_files.h"
#include "ui/editor/editor_records.h"
#include "ui/instructor/exchange.h"
#include "ui/instructor/import_page.h"
#include "ui/instructor/library_page.h"
#include "ui/session/file_bytes.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/table.h"

namespace cusp::test {
namespace {

TEST_F(LibraryFiles, AnExerciseGoesToAnotherStationWithItsVolumeAndOpensInTheEditor) {
  const QString file = path("block");
  const Scenario sent = send_volume(file);
  EXPECT_TRUE(from.message().contains(QStringLiteral("block.cusp"))) << from.message().toStdString();
  to.open_file(file + QStringLiteral(".cusp"));
  ASSERT_EQ(to.opened.size(), 1u) << to.message().toStdString();
  Scenario wanted = sent;
  wanted.version = 1;
  EXPECT_EQ(to.opened[0].draft, wanted) << "with its id: nothing here has it";
  EXPECT_FALSE(to.opened[0].published.has_value());
  ASSERT_EQ(to.drafts().size(), 1u);
  EXPECT_EQ(to.opened[0].kept, to.drafts()[0].json);
  const auto volume = std::filesystem::path(to.opened[0].folder) / sent.specimen.volume;
  EXPECT_EQ(read_nrrd(volume)->s, dexterity_block(0.4).s);
  EXPECT_TRUE(to.asked.isEmpty());
}

TEST_F(LibraryFiles, AFileWhoseSuffixIsInCapitalsCanBeChosenAndOpened) {
  ASSERT_TRUE(write_exercise_file({from.changed(2.4), {}}, path("DEEPER.CUSP").toStdString()));
  to.ports.pick_file = [this](QWidget*, const FileWish& wish, const std::function<void(const QString&)>& then) {
    EXPECT_TRUE(wish.filter.contains(QStringLiteral("*.CUSP"))) << "a dialog of the desktop may tell cases apart: " << wish.filter.toStdString();
    then(path("DEEPER.CUSP"));
  };
  to.show();
  to.page->choose_file();
  to.worked();
  EXPECT_EQ(to.opened.size(), 1u) << to.message().toStdString();
}

TEST_F(LibraryFiles, WhatThePageSaidDoesNotOutliveAStayInTheEditor) {
  send_volume(path("block"));
  from.page->copy_chosen();
  EXPECT_TRUE(from.message().contains(QStringLiteral("nothing to copy"))) << from.message().toStdString();
  from.page->read_again();  // it may have been published meanwhile
  EXPECT_EQ(from.message(), QString());
}

TEST_F(LibraryFiles, WhatTheLibraryHasAlreadyIsChosenAndNothingIsMade) {
  from.choose(load_builtin("class-2-46-mo")->id);
  from.picked = path("one.cusp");
  from.save_chosen();
  for (QComboBox* box : to.page->findChildren<QComboBox*>()) box->setCurrentIndex(box->count() - 1);  // shows withdrawn ones alone
  to.open_file(from.picked);
  EXPECT_TRUE(to.message().contains(QStringLiteral("already"))) << to.message().toStdString();
  EXPECT_FALSE(to.page->table()->isRowHidden(to.page->table()->chosen_row())) << "behind a filter nobody sees it";
  EXPECT_EQ(to.page->model().row(to.page->table()->chosen_row()).shown().key, "class-2-46-mo");
  EXPECT_TRUE(to.drafts().empty());
  EXPECT_TRUE(to.opened.empty());
}

TEST_F(LibraryFiles, AnExerciseWithAnotherContentHereBecomesANewOneAfterAsking) {
  ASSERT_TRUE(write_exercise_file({from.changed(2.4), {}}, path("deeper.cusp").toStdString()));
  to.answer = false;
  to.open_file(path("deeper.cusp"));
  ASSERT_EQ(to.asked.size(), 1);
  EXPECT_TRUE(to.opened.empty());
  EXPECT_TRUE(to.drafts().empty());
  to.answer = true;
  to.open_file(path("deeper.cusp"));
  ASSERT_EQ(to.opened.size(), 1u);
  const Scenario& made = to.opened[0].draft;
  EXPECT_NE(made.id, load_builtin("channel-1")->id);
  EXPECT_DOUBLE_EQ(made.target.outline.depth_mm, 2.4);
  EXPECT_TRUE(made.title.at("en").ends_with("(copy)")) << made.title.at("en");
  EXPECT_TRUE(made.key.empty());
  EXPECT_EQ(made.version, 1);
  to.open_file(path("deeper.cusp"));
  EXPECT_EQ(to.asked.size(), 3) << "the copy has an id of its own: the file is as strange as before";
}

TEST_F(LibraryFiles, AFileIsTakenByDropping) {
  send_volume(path("block.cusp"));
  QMimeData data;
  data.setUrls({QUrl::fromLocalFile(path("block.cusp"))});
  QDragEnterEvent enter(QPoint(50, 50), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QCoreApplication::sendEvent(to.page.get(), &enter);
  ASSERT_TRUE(enter.isAccepted());
  QDropEvent drop(QPointF(50, 50), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QCoreApplication::sendEvent(to.page.get(), &drop);
  to.worked();
  EXPECT_EQ(to.opened.size(), 1u) << to.message().toStdString();
}

TEST_F(LibraryFiles, TheWindowDoesNotWaitForAFileAndOneIsOpenedAtATime) {
  send_volume(path("block.cusp"));
  to.page->open_file(path("block.cusp"));
  EXPECT_TRUE(to.page->working());
  EXPECT_TRUE(to.opened.empty());
  EXPECT_TRUE(to.message().contains(QStringLiteral("block.cusp is being read"))) << to.message().toStdString();
  to.page->open_file(path("block.cusp"));
  to.worked();
  EXPECT_EQ(to.opened.size(), 1u);
  EXPECT_EQ(to.drafts().size(), 1u);
}

TEST_F(LibraryFiles, AFileThatIsDroppedAgainWhileItsDraftIsMadeIsNoOtherFile) {
  ASSERT_TRUE(write_exercise_file({from.changed(2.4), {}}, path("deeper.cusp").toStdString()));
  to.ports.ask = [&](QWidget*, const Question& question, const std::function<void(bool)>& then) {
    to.asked << question.what;
    then(true);
    ASSERT_TRUE(to.page->working()) << "its draft is being made";
    if (to.asked.size() == 1) to.page->open_file(path("deeper.cusp"));
  };
  to.open_file(path("deeper.cusp"));
  EXPECT_EQ(to.asked.size(), 1) << to.asked.join(u'|').toStdString();
  EXPECT_EQ(to.opened.size(), 1u);
  EXPECT_EQ(to.drafts().size(), 1u);
}

TEST_F(LibraryFiles, AnotherFileThanTheOneThatIsReadIsNamedAndOfferedAgain) {
  send_volume(path("block.cusp"));
  ASSERT_TRUE(write_exercise_file({from.changed(2.4), {}}, path("deeper.cusp").toStdString()));
  std::function<void(bool)> then;
  to.ports.ask = [&](QWidget*, const Question& question, const std::function<void(bool)>& wanted) {
    to.asked << question.what;
    then = wanted;
  };
  to.page->open_file(path("block.cusp"));
  to.page->open_file(path("deeper.cusp"));
  ASSERT_EQ(to.asked, QStringList{QStringLiteral("deeper.cusp was not opened.")});
  to.worked();
  ASSERT_EQ(to.opened.size(), 1u) << to.message().toStdString();
  then(true);
  EXPECT_TRUE(to.page->working());
  to.worked();
  EXPECT_EQ(to.asked.size(), 2) << "the library has that exercise with another content";
}

TEST_F(LibraryFiles, AFileThatIsReadWhileAnotherPageCameDoesNotOpen) {
  send_volume(path("block.cusp"));
  to.page->open_file(path("block.cusp"));
  to.page->hide();
  to.worked();
  EXPECT_TRUE(to.opened.empty());
  EXPECT_TRUE(to.drafts().empty());
}

TEST_F(LibraryFiles, ADiscardedDraftLeavesTheVolumeOfAnotherInstructorsDraft) {
  send_volume(path("block.cusp"));
  to.open_file(path("block.cusp"));
  ASSERT_EQ(to.opened.size(), 1u) << to.message().toStdString();
  const auto volume = std::filesystem::path(to.opened[0].folder) / to.opened[0].draft.specimen.volume;
  const Account other = *to.records.store().accounts.create(to.records.administrator().actor(), {"falk", "Ida Falk", Role::instructor, "correct horse", ""});
  LibraryPage theirs(to.records.store(), other.actor(), to.ports, to.records.file(), to.cache.path());
  theirs.show();
  theirs.open_file(path("block.cusp"));
  ASSERT_TRUE(QTest::qWaitFor([&] { return !theirs.working(); }, 60'000));
  ASSERT_EQ(to.records.store().scenarios.drafts(other.actor())->size(), 1u);
  to.choose(to.opened[0].draft.id);
  to.page->discard_draft();
  EXPECT_TRUE(to.drafts().empty());
  EXPECT_TRUE(std::filesystem::exists(volume)) << "Ida Falk's draft needs it";
  theirs.table()->choose_row(0);
  theirs.discard_draft();
  EXPECT_FALSE(std::filesystem::exists(volume)) << "nobody needs it";
}

TEST_F(LibraryFiles, AFileThatTheDiskDoesNotTakeLeavesTheVolumeOfAnotherInstructorsDraft) {
  const QString file = path("block.cusp");
  send_volume(file);
  to.open_file(file);
  ASSERT_EQ(to.opened.size(), 1u) << to.message().toStdString();
  const std::filesystem::path in = to.opened[0].folder, volume = in / to.opened[0].draft.specimen.volume;
  const auto whole = std::filesystem::file_size(volume);
  ASSERT_GT(whole, 1000u);
  const Account other = *to.records.store().accounts.create(to.records.administrator().actor(), {"falk", "Ida Falk", Role::instructor, "correct horse", ""});
  const auto read = read_exercise_file(file.toStdString());
  ASSERT_TRUE(read);
  const auto taken = with_files_up_to(1000, [&] { return take_in(to.records.store(), other.actor(), *read, KeepId::yes, to.records.file()); });
  ASSERT_FALSE(taken);
  EXPECT_EQ(taken.error().code, StorageError::file_too_large);
  EXPECT_EQ(std::filesystem::file_size(volume), whole);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(in), {}), 1) << "a half file is left";
}

TEST_F(LibraryFiles, AnotherVolumeOfTheNameOfAnotherInstructorsVolumeLiesBesideIt) {
  const QString file = path("block.cusp");
  send_volume(file);
  to.open_file(file);
  ASSERT_EQ(to.opened.size(), 1u) << to.message().toStdString();
  const std::filesystem::path in = to.opened[0].folder, volume = in / to.opened[0].draft.specimen.volume;
  const Account other = *to.records.store().accounts.create(to.records.administrator().actor(), {"falk", "Ida Falk", Role::instructor, "correct horse", ""});
  auto edited = *read_exercise_file(file.toStdString());
  const auto first = edited.volume;
  edited.volume.push_back(std::byte{});
  const auto taken = take_in(to.records.store(), other.actor(), edited, KeepId::yes, to.records.file());
  ASSERT_TRUE(taken);
  EXPECT_EQ(*bytes_of(volume), first);
  EXPECT_EQ(taken->draft.id, to.opened[0].draft.id);
  EXPECT_NE(taken->draft.specimen.volume, to.opened[0].draft.specimen.volume);
  EXPECT_EQ(*bytes_of(in / taken->draft.specimen.volume), edited.volume);
}

TEST_F(LibraryFiles, VolumesOfOneNameThatManyWindowsTakeInAtOnceAreAllKept) {
  const QString file = path("block.cusp");
  send_volume(file);
  const auto sent = *read_exercise_file(file.toStdString());
  constexpr std::size_t kWindows = 6;
  std::vector<Actor> actors;
  std::vector<ExerciseFile> files(kWindows, sent);
  std::vector<std::filesystem::path> kept(kWindows);
  for (std::size_t i = 0; i < kWindows; ++i) {
    const std::string number = "window-" + std::to_string(i);
    actors.push_back(to.records.store().accounts.create(to.records.administrator().actor(), {number, number, Role::instructor, "correct horse", ""})->actor());
    files[i].volume.push_back(static_cast<std::byte>(i));
  }
  std::vector<std::thread> windows;
  for (std::size_t i = 0; i < kWindows; ++i) {
    windows.emplace_back([&, i] {
      auto store = Store::open(to.records.file());
      ASSERT_TRUE(store);
      const auto taken = take_in(**store, actors[i], files[i], KeepId::yes, to.records.file());
      ASSERT_TRUE(taken);
      kept[i] = std::filesystem::path(taken->folder) / taken->draft.specimen.volume;
    });
  }
  for (std::thread& window : windows) window.join();
  for (std::size_t i = 0; i < kWindows; ++i) EXPECT_EQ(*bytes_of(kept[i]), files[i].volume) << kept[i];
}

TEST_F(LibraryFiles, AVolumeThatGotANumberHereDoesNotMakeItsFileAStrangeOne) {
  const QString file = path("block.cusp");
  const Scenario sent = send_volume(file);
  const Account other = *to.records.store().accounts.create(to.records.administrator().actor(), {"falk", "Ida Falk", Role::instructor, "correct horse", ""});
  auto edited = *read_exercise_file(file.toStdString());
  edited.volume.push_back(std::byte{});
  ASSERT_TRUE(take_in(to.records.store(), other.actor(), edited, KeepId::yes, to.records.file()));
  to.open_file(file);
  ASSERT_EQ(to.opened.size(), 1u) << to.message().toStdString();
  ASSERT_NE(to.opened[0].draft.specimen.volume, sent.specimen.volume);
  to.open_file(file);
  EXPECT_TRUE(to.message().contains(QStringLiteral("already"))) << to.message().toStdString();
  EXPECT_TRUE(to.asked.isEmpty());
  EXPECT_EQ(to.drafts().size(), 1u);
}

TEST_F(LibraryFiles, ASecondFileIsNotDroppedInSilenceWhileOneIsWritten) {
  from.answer = false;
  from.choose(load_builtin("channel-1")->id);
  from.picked = path("one.cusp");
  from.page->save_chosen();
  from.picked = path("two.cusp");
  from.page->save_chosen();
  ASSERT_EQ(from.asked.size(), 1);
  EXPECT_TRUE(from.asked[0].contains(QStringLiteral("two.cusp was not written"))) << from.asked[0].toStdString();
  from.worked();
  EXPECT_TRUE(std::filesystem::exists(folder / "one.cusp"));
}

}  // namespace
}  // namespace cusp::test
