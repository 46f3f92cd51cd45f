// Every page of the three roles by keyboard alone, and in a language whose texts are longer, from either side.

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QAccessible>
#include <QButtonGroup>
#include <QLabel>
#include <QPushButton>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <algorithm>
#include <functional>
#include <vector>

#include "scenarios/library/library.h"
#include "tests/modules.h"
#include "tests/ui/desk_records.h"
#include "tests/ui/report/sample_report.h"
#include "tests/ui/whole_texts.h"
#include "ui/app/accessible_parts.h"
#include "ui/app/desktop.h"
#include "ui/app/shell.h"
#include "ui/editor/audit_page.h"
#include "ui/editor/editor_page.h"
#include "ui/editor/handle_knob.h"
#include "ui/editor/target_view.h"
#include "ui/instructor/import_page.h"
#include "ui/replay/reference_page.h"
#include "ui/report/report_page.h"
#include "ui/student/briefing.h"
#include "ui/admin/way_back.h"
#include "ui/student/self_assessment_page.h"
#include "ui/text/language.h"
#include "ui/view/section_bar.h"

namespace cusp::test {
namespace {

constexpr int kMostStops = 400;  // of the Tab key on one page

QString spoken_name(QWidget* widget) {
  QAccessibleInterface* face = QAccessible::queryAccessibleInterface(widget);
  return face ? face->text(QAccessible::Name) : QString();
}

/// What the Tab key is to reach. Of a group of which one is chosen Tab reaches that one, and the arrow keys the rest; of a group
/// without a choice it reaches each.
bool is_stop(const QWidget& widget) {
  if (!widget.isVisible() || !widget.isEnabled() || !(widget.focusPolicy() & Qt::TabFocus) || widget.focusProxy()) return false;
  const auto* button = qobject_cast<const QAbstractButton*>(&widget);
  const bool in_group = button && button->isCheckable() && (button->autoExclusive() || button->group());
  const bool open = in_group && button->group() && button->group()->checkedButton() == nullptr;
  return !in_group || open || button->isChecked();
}

QRect on(const QWidget& window, const QWidget& widget) { return {widget.mapTo(&window, QPoint()), widget.size()}; }

/// The second is read before the first: above it in the same column, or before it in the same line.
bool against_reading(const QRect& first, const QRect& second) {
  const bool same_column = first.left() < second.right() && second.left() < first.right();
  const bool same_line = first.top() < second.bottom() && second.top() < first.bottom();
  return same_column ? second.bottom() <= first.top() : same_line && second.right() <= first.left();
}

struct Stop {
  QWidget* widget = nullptr;
  bool against_reading = false;  // of the stop before, when Tab came here: a page that scrolls has moved since
};

/// Places of the window that Tab reaches, from the first one on until it comes round.
std::vector<Stop> stops(QWidget& window) {
  std::vector<Stop> out;
  QWidget* first = window.nextInFocusChain();
  while (first != &window && !is_stop(*first)) first = first->nextInFocusChain();
  first->setFocus(Qt::TabFocusReason);
  for (int i = 0; i < kMostStops; ++i) {
    QWidget* now = QApplication::focusWidget();
    if (now == nullptr || (!out.empty() && now == out.front().widget)) break;
    out.push_back({now, !out.empty() && against_reading(on(window, *out.back().widget), on(window, *now))});
    QTest::keyClick(now, Qt::Key_Tab);
    if (QApplication::focusWidget() == now) ADD_FAILURE() << "Tab does not leave " << described(*now);
    if (QApplication::focusWidget() == now) break;
  }
  return out;
}

struct Walk : ::testing::Test {
  test::DeskRecords records;
  QTemporaryDir folder;
  Settings settings{folder.filePath(QStringLiteral("Cusp.ini"))};
  Ports ports = Ports::of_the_system();
  QTemporaryDir cache;
  ThumbnailCache pictures{cache.path().toStdString()};
  Account lena = records.student("1", "Lena Brandt");
  Account berg = *records.store().accounts.create(records.administrator().actor(), {"berg", "Mara Berg", Role::instructor, "correct horse", ""});

  static void SetUpTestSuite() {
    [[maybe_unused]] static const bool once = (install_accessible_parts(), true);
  }
  Walk() { records.attempt(lena, "channel-1", 78, 426); }
  ~Walk() override {
    qApp->setLayoutDirection(Qt::LeftToRight);
    install_language(*qApp, QStringLiteral("en"));
  }

  using Visit = std::function<void(QWidget& window, const std::string& page)>;
  void each_page(const Visit& visit) {
    for (const Account& who : {lena, berg, records.administrator()}) {
      Desktop desktop(settings, ports, records.file());
      desktop.start();
      desktop.showNormal();
      desktop.resize(1280, 800);
      ASSERT_TRUE(QTest::qWaitForWindowExposed(&desktop));
      if (who.id == lena.id) visit(desktop, "sign-in");
      desktop.sign_in(who);
      for (const NavEntry& entry : desktop.shell()->entries()) {
        desktop.shell()->show_page(entry.key);
        QTest::qWait(0);
        visit(desktop, who.number + ", " + entry.key.toStdString());
      }
      if (who.id == lena.id) visit_pages_over_the_shell(desktop, visit);
    }
  }
  /// The editor with four of its six forms and with its section, and the page of imports.
  void visit_pages_of_an_author(Desktop& desktop, const Visit& visit) {
    desktop.push(new ImportPage(ports, records.file()));
    visit(desktop, "import");
    desktop.back();
    EditorStart start;
    start.draft = *load_builtin("channel-1");
    start.draft.specimen.voxel_mm = 0.4;
    auto* editor = new EditorPage(records.store(), berg.actor(), ports, start);
    desktop.push(editor);
    ASSERT_TRUE(QTest::qWaitFor([&] { return editor->grown() && editor->findChild<AuditPage*>(); }, 60'000));
    auto* tabs = editor->findChild<QTabWidget*>();
    for (const int i : {0, 1, 4, 5}) {  // without burs and tissues, whose rows Tab meets after what stands below them
      tabs->setCurrentIndex(i);
      QTest::qWait(0);
      visit(desktop, "editor, " + tabs->tabText(i).toStdString());
    }
    tabs->setCurrentIndex(0);
    editor->stage()->section()->open();
    visit(desktop, "editor, section");
    desktop.back();
  }
  void visit_pages_over_the_shell(Desktop& desktop, const Visit& visit) {
    Exercise exercise;
    exercise.scenario = *load_builtin("channel-1");
    exercise.scenario.specimen.voxel_mm = 0.4;  // so that it grows at once
    const auto teeth = std::make_shared<ToothCache>(std::filesystem::path());
    desktop.push(new Briefing(exercise, pictures, {}, teeth));
    visit(desktop, "briefing");
    auto* reference = new ReferencePage(teeth, {exercise.scenario, {}, Guidance::full, nullptr}, QStringLiteral("Channel"));
    desktop.push(reference);
    ASSERT_TRUE(QTest::qWaitFor([&] { return reference->ready(); }, 60'000));
    visit(desktop, "reference");
    desktop.back();
    desktop.back();
    desktop.push(new WayBack("/var/lib/cusp/station.db", "/var/lib/cusp/backups", {QStringLiteral("The database is damaged."), QStringLiteral("It cannot be read whole.")}, ports));
    visit(desktop, "way back");
    desktop.back();
    desktop.push(new SelfAssessmentPage(*load_builtin("class-2-46-mo"), SelfAssessmentPage::Then::result));
    visit(desktop, "own assessment");
    desktop.back();
    desktop.push(new ReportPage(sample(), ports, ReportPage::TryAgain::offered, QStringLiteral("Back")));
    visit(desktop, "report");
    desktop.back();
  }
};

/// The points of an outline come in its own order, wherever they lie on the tooth.
bool both_on_the_tooth(const Stop& first, const Stop& second) {
  return qobject_cast<HandleKnob*>(first.widget) && qobject_cast<HandleKnob*>(second.widget);
}

void expect_tab_reaches_everything(QWidget& window, const std::string& page) {
  window.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window)) << page;
  ASSERT_EQ(window.size(), QSize(1280, 800));
  const std::vector<Stop> met = stops(window);
  for (const Stop& stop : met) EXPECT_FALSE(spoken_name(stop.widget).isEmpty()) << page << ": no name, " << described(*stop.widget);
  for (QWidget* widget : window.findChildren<QWidget*>()) {
    EXPECT_TRUE(!is_stop(*widget) || std::ranges::find(met, widget, &Stop::widget) != met.end()) << page << ": Tab does not reach " << described(*widget);
  }
  for (std::size_t i = 1; i < met.size(); ++i) {
    EXPECT_FALSE(met[i].against_reading && !both_on_the_tooth(met[i - 1], met[i]))
        << page << ": after " << described(*met[i - 1].widget) << " comes " << described(*met[i].widget);
  }
}

TEST_F(Walk, tab_reaches_everything_in_the_order_of_reading_and_everything_has_a_name) { each_page(expect_tab_reaches_everything); }

/// At the usual size, and at the one that full HD has at 200 %.
void expect_nothing_clipped_at_either_size(QWidget& window, const std::string& page) {
  expect_nothing_clipped(window, page);
  const QSize usual = window.size();
  window.resize(kHalfOfFullHd);
  expect_whole_at_half_of_full_hd(window, page + ", half of full HD");
  window.resize(usual);
}

TEST_F(Walk, tab_reaches_everything_of_an_authors_pages_in_the_order_of_reading) {
  Desktop desktop(settings, ports, records.file());
  desktop.start();
  desktop.showNormal();
  desktop.resize(1280, 800);
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&desktop));
  desktop.sign_in(berg);
  visit_pages_of_an_author(desktop, expect_tab_reaches_everything);
}

TEST_F(Walk, longer_texts_are_clipped_on_no_page) {
  install_language(*qApp, QStringLiteral("pseudo"));
  each_page(expect_nothing_clipped_at_either_size);
}

TEST_F(Walk, longer_texts_are_clipped_on_no_mirrored_page) {
  install_language(*qApp, QStringLiteral("pseudo"));
  qApp->setLayoutDirection(Qt::RightToLeft);
  each_page(expect_nothing_clipped);
}

}  // namespace
}  // namespace cusp::test
