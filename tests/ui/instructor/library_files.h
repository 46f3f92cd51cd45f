/// Two stations with their library's pages, and a folder between them.
#pragma once

#include <gtest/gtest.h>

#include <QTest>
#include <functional>
#include <memory>
#include <vector>

#include "scenarios/blocks/blocks.h"
#include "scenarios/format/write.h"
#include "scenarios/library/library.h"
#include "tests/modules.h"
#include "tests/scenarios/import/mesh_files.h"
#include "tests/ui/desk_records.h"
#include "ui/editor/editor_records.h"
#include "ui/instructor/exchange.h"
#include "ui/instructor/import_page.h"
#include "ui/instructor/library_page.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/table.h"

namespace cusp::test {

/// A station with its library's page.
struct LibraryStation {
  DeskRecords records;
  TempFolder cache;
  Ports ports = Ports::of_the_system();
  Account instructor;
  bool answer = true;
  QStringList asked;
  QString picked;
  std::vector<EditorStart> opened;
  std::unique_ptr<LibraryPage> page;

  LibraryStation() {
    instructor = *records.store().accounts.create(records.administrator().actor(),
                                                  {"berg", "Mara Berg", Role::instructor, "correct horse", ""});
    ports.ask = [this](QWidget*, const Question& question, std::function<void(bool)> then) {
      asked << question.what;
      then(answer);
    };
    ports.pick_file = [this](QWidget*, const FileWish&, std::function<void(const QString&)> then) { then(picked); };
    show();
  }
  void show() {
    page = std::make_unique<LibraryPage>(records.store(), instructor.actor(), ports, records.file(), cache.path());
    page->show();
    QObject::connect(page.get(), &LibraryPage::edit_wanted, [this](const EditorStart& start) { opened.push_back(start); });
  }
  void choose(ScenarioId id) {
    for (int i = 0; i < page->model().rowCount(); ++i)
      if (page->model().row(i).shown().id == id) page->table()->choose_row(i);
  }
  /// channel-1 with another depth, published; or with a depth of its own as a draft.
  Scenario changed(double depth_mm) const {
    Scenario s = *load_builtin("channel-1");
    s.target.outline.depth_mm = depth_mm;
    return s;
  }
  /// The file is read or written, on a thread of its own.
  void worked() { ASSERT_TRUE(QTest::qWaitFor([this] { return !page->working(); }, 60'000)); }
  void open_file(const QString& path) {
    page->open_file(path);
    worked();
  }
  void save_chosen() {
    page->save_chosen();
    worked();
  }
  std::vector<ScenarioDraft> drafts() { return *records.store().scenarios.drafts(instructor.actor()); }
  QString message() const {
    for (const Band* band : page->findChildren<Band*>())
      if (!band->isHidden()) return band->text();
    return {};
  }
};

struct LibraryFiles : ::testing::Test {
  TempFolder folder;
  LibraryStation from, to;
  QString path(const char* name) const { return QString::fromStdString((folder / name).string()); }
  /// A new exercise on a volume, saved by `from`.
  Scenario send_volume(const QString& file) {
    const EditorStart start = *exercise_on(dexterity_block(0.4), "Block from a scan", from.records.file());
    Scenario draft = start.draft;
    EXPECT_TRUE(from.records.store().scenarios.save_draft(from.instructor.actor(), draft.id, canonical_json(draft), {}).has_value());
    from.show();
    from.choose(draft.id);
    from.picked = file;
    from.save_chosen();
    return draft;
  }
};

}  // namespace cusp::test
