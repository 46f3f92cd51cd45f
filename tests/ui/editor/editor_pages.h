// The editor's page over real records, and what stands on it.
#pragma once

#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "scenarios/library/library.h"
#include "tests/modules.h"
#include "tests/ui/desk_records.h"
#include "ui/editor/audit_page.h"
#include "ui/editor/editor_page.h"
#include "ui/editor/editor_records.h"
#include "ui/editor/handle_knob.h"
#include "ui/editor/publish_sheet.h"
#include "ui/editor/target_view.h"

namespace cusp::test {

inline constexpr int kGrowsWithinMs = 60'000;  // a coarse block takes a moment; waited for, never decided by

struct EditorPages : ::testing::Test {
  DeskRecords records;
  QTemporaryDir folder;
  Ports ports = Ports::of_the_system();
  Account instructor;
  QString file;
  void SetUp() override {
    instructor = *records.store().accounts.create(records.administrator().actor(),
                                             {"berg", "Mara Berg", Role::instructor, "correct horse", ""});
    ports.pick_file = [this](QWidget*, const FileWish&, std::function<void(const QString&)> then) { then(file); };
  }
  /// channel-1 at 0.4 mm, so that it grows at once.
  EditorStart coarse() const {
    EditorStart start;
    start.published = *load_builtin("channel-1");
    start.published->specimen.voxel_mm = 0.4;
    start.draft = *start.published;
    start.draft.version = start.published->version + 1;
    start.folder = drafts_folder(records.file(), start.draft.id).string();
    return start;
  }
  std::unique_ptr<EditorPage> open() { return open(coarse()); }
  std::unique_ptr<EditorPage> open(const EditorStart& start) {
    auto page = std::make_unique<EditorPage>(records.store(), instructor.actor(), ports, start);
    page->resize(1280, 800);
    QSignalSpy ready(page.get(), &EditorPage::ready);
    page->show();
    EXPECT_TRUE(page->grown() || ready.wait(kGrowsWithinMs));
    // Each form comes in a turn of the event loop of its own, the audit's last.
    EXPECT_TRUE(QTest::qWaitFor([&] { return page->findChild<AuditPage*>() != nullptr; }, kGrowsWithinMs));
    return page;
  }
};

/// In the order of handles_of().
inline std::vector<HandleKnob*> knobs_of(const TargetView& stage) {
  std::vector<HandleKnob*> out;
  for (HandleKnob* knob : stage.findChildren<HandleKnob*>())
    if (!knob->isHidden()) out.push_back(knob);
  return out;
}

/// The sheet that asks before publishing; nullptr while none is open.
inline PublishSheet* sheet_of(const EditorPage& page) {
  for (PublishSheet* sheet : page.findChildren<PublishSheet*>())
    if (sheet->isVisible()) return sheet;
  return nullptr;
}

/// Opens the sheet; false if a check fails.
inline bool open_sheet(EditorPage& page) {
  page.publish_version();
  return QTest::qWaitFor([&] { return sheet_of(page) != nullptr; }, kGrowsWithinMs);
}

/// Presses the sheet's button; false if no version is published then.
inline bool publish_by_sheet(EditorPage& page) {
  QSignalSpy done(&page, &EditorPage::published);
  sheet_of(page)->publish()->click();
  return done.wait(kGrowsWithinMs);
}

template <class W>
W* named(QWidget& page, const char* name) {
  for (W* w : page.findChildren<W*>()) {
    if (w->accessibleName() == QLatin1String(name)) return w;
  }
  return nullptr;
}

}  // namespace cusp::test
