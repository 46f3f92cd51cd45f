// Hostile input in every field and filter of every page, by random hands: nothing ends the program, and the records verify afterwards.
// 25 acts on each page by default; with CUSP_FULL=1 300. CUSP_HOSTILE_SEED=N repeats a run.

#include <gtest/gtest.h>

#include <QAbstractSpinBox>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QFile>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <random>

#include "storage/records/verify.h"
#include "tests/full_run.h"
#include "tests/modules.h"
#include "tests/ui/desk_records.h"
#include "ui/app/desktop.h"
#include "ui/app/shell.h"
#include "ui/settings/settings.h"

namespace cusp::test {
namespace {

/// What breaks programs: quotes of SQL, formulas of spreadsheets, paths, marks of texts, signs of other scripts, numbers out of range.
QStringList hostile_texts() {
  QStringList out = {QStringLiteral("'; DROP TABLE sessions; --"), QStringLiteral("\" OR 1=1 --"), QStringLiteral("=cmd|' /C calc'!A0"), QStringLiteral("@SUM(1+1)"),
                     QStringLiteral("\t=1+1"), QStringLiteral("../../../../etc/passwd"), QStringLiteral("/dev/full"), QStringLiteral("<b>bold</b><img src=x>&amp;"),
                     QStringLiteral("%n %1 %2 %s %%"), QStringLiteral("-1"), QStringLiteral("99999999999999999999"), QStringLiteral("1e308"), QStringLiteral("NaN"),
                     QStringLiteral("%_%"), QStringLiteral("*[a-z]\\"), QStringLiteral("\n\nline\r\nline;a,b\n"), QStringLiteral(" "), QString(),
                     QStringLiteral("4711\n4711 Lena\n0"), QString::fromUtf8("\u202Eevil\u202C\u200B"), QString::fromUtf8("\u0661\u0662\u0663"), QString::fromUtf8("\U0001F9B7\u0301\u0301\u0301")};
  out += QString(20'000, u'x');
  out += QString(QChar(0)) + QStringLiteral("after nul");
  out += QString(QChar(0xD800)) + QStringLiteral("half a pair");
  return out;
}

/// Leaves the page that is tested, or starts what only a device, a display or minutes can end.
bool leads_away(const QAbstractButton& button) {
  const QString text = button.text() + button.accessibleName();
  for (const char* word : {"Start", "Try", "Watch", "Open in the editor", "Reference", "Measure", "Briefing", "Continue", "Grade", "Quit", "Account of", "Test", "Open the report", "Quick start"})
    if (text.contains(QLatin1StringView(word))) return true;
  return false;
}

class Hands {
 public:
  Hands(Desktop& desktop, std::uint64_t seed, const QStringList& texts) : desktop_(desktop), random_(seed), texts_(texts) {}

  /// One act: in a dialog if one is open, else on the page. False: nothing takes input now.
  bool act() {
    QWidget* const page = desktop_.shell()->page();
    QWidget* where = page;
    for (QWidget* top : QApplication::topLevelWidgets())
      if (top->isVisible() && qobject_cast<QDialog*>(top)) where = top;
    QList<QWidget*> all;
    for (QWidget* one : where->findChildren<QWidget*>())
      if (one->isVisible() && one->isEnabled() && takes_input(*one)) all += one;
    if (where != page && (all.isEmpty() || pick(6) == 0))
      static_cast<QDialog*>(where)->reject();
    else if (all.isEmpty())
      return false;
    else
      use(*all[pick(static_cast<int>(all.size()))]);
    return true;
  }
  int pick(int below) { return std::uniform_int_distribution<int>(0, below - 1)(random_); }
  const QString& text() { return texts_[pick(static_cast<int>(texts_.size()))]; }

 private:
  static bool takes_input(const QWidget& one) {
    const auto* button = qobject_cast<const QAbstractButton*>(&one);
    if (button) return !leads_away(*button) && !(qobject_cast<const QPushButton*>(button) && static_cast<const QPushButton*>(button)->menu());
    return qobject_cast<const QLineEdit*>(&one) || qobject_cast<const QPlainTextEdit*>(&one) || qobject_cast<const QComboBox*>(&one) ||
           qobject_cast<const QAbstractSpinBox*>(&one);
  }
  void use(QWidget& one) {
    if (auto* line = qobject_cast<QLineEdit*>(&one)) {
      line->setFocus();
      line->clear();
      line->insert(text());  // as typed: validators and lengths hold
      if (pick(2) == 0) QTest::keyClick(line, Qt::Key_Return);
    } else if (auto* plain = qobject_cast<QPlainTextEdit*>(&one)) {
      plain->setPlainText(text());
    } else if (auto* box = qobject_cast<QComboBox*>(&one)) {
      if (box->count() > 0) box->setCurrentIndex(pick(box->count()));
    } else if (auto* spin = qobject_cast<QAbstractSpinBox*>(&one)) {
      spin->findChild<QLineEdit*>()->setText(text());
      spin->interpretText();
      pick(2) == 0 ? spin->stepUp() : spin->stepDown();
    } else if (auto* button = qobject_cast<QAbstractButton*>(&one)) {
      button->click();
    }
  }

  Desktop& desktop_;
  std::mt19937_64 random_;
  const QStringList& texts_;
};

struct Hostile : ::testing::Test {
  DeskRecords records;
  QTemporaryDir folder;
  Settings settings{folder.filePath(QStringLiteral("Cusp.ini"))};
  QStringList texts = hostile_texts();
  std::mt19937_64 random{std::getenv("CUSP_HOSTILE_SEED") != nullptr ? std::strtoull(std::getenv("CUSP_HOSTILE_SEED"), nullptr, 10) : 24};

  /// Questions are answered at random; files have hostile names and contents, in a folder of their own.
  Ports ports() {
    Ports out = Ports::of_the_system();
    out.ask = [this](QWidget*, const Question&, const std::function<void(bool)>& then) { then(random() % 2 == 0); };
    out.pick_file = [this](QWidget*, const FileWish& wish, const std::function<void(const QString&)>& then) {
      if (wish.what == FileWish::What::folder) return then(folder.filePath(QStringLiteral("backups")));
      const QString path = folder.filePath(QStringLiteral("'; DROP TABLE %1.csv").arg(random() % 4));
      if (!wish.saving) {
        QFile file(path);
        if (file.open(QIODevice::WriteOnly)) file.write(texts[static_cast<qsizetype>(random() % static_cast<std::uint64_t>(texts.size()))].toUtf8());
      }
      then(path);
    };
    return out;
  }
};

TEST_F(Hostile, InputInEveryFieldEndsNothingAndTheRecordsVerify) {
  const Account lena = records.student("1", "Lena Brandt", "271828"), omar = records.student("2", "Omar Said", "271828");
  const Account berg = *records.store().accounts.create(records.administrator().actor(), {"berg", "Mara Berg", Role::instructor, "correct horse", ""});
  const SessionId kept = records.attempt(lena, "channel-1", 78, 426);
  records.attempt(omar, "class-1-36", 55, 600);
  const Ports hands_of = ports();
  QTimer menus;  // one that is open waits for a choice
  QObject::connect(&menus, &QTimer::timeout, [] {
    if (QWidget* popup = QApplication::activePopupWidget()) popup->close();
  });
  menus.start(20);
  const int acts_of_page = full_run() ? 300 : 25;
  int pages = 0;
  for (const Account& who : {lena, berg, records.administrator()}) {
    Desktop desktop(settings, hands_of, records.file());
    desktop.start();
    desktop.showNormal();
    desktop.resize(1280, 800);
    desktop.sign_in(who);
    QStringList keys;
    for (const NavEntry& entry : desktop.shell()->entries()) keys += entry.key;
    for (const QString& key : keys) {
      SCOPED_TRACE(who.number + ", " + key.toStdString());
      Hands hands(desktop, random(), texts);
      int acts = 0, idle = 0;
      while (acts < acts_of_page && idle < 50) {
        if (desktop.shell() == nullptr || desktop.page() != desktop.shell() || desktop.shell()->page_key() != key) {
          while (desktop.shell() != nullptr && desktop.page() != desktop.shell()) desktop.back();
          if (desktop.shell() == nullptr) desktop.sign_in(who);
          desktop.shell()->show_page(key);
        }
        if (hands.act()) {
          ++acts;
          QCoreApplication::processEvents();
        } else {
          ++idle;  // its rows are on their way
          QTest::qWait(10);
        }
      }
      for (QWidget* top : QApplication::topLevelWidgets())
        if (auto* dialog = qobject_cast<QDialog*>(top); dialog && dialog->isVisible()) dialog->reject();
      pages += acts == acts_of_page ? 1 : 0;
    }
  }
  EXPECT_GE(pages, 15) << "pages that took every act";
  const auto proof = verify_store(records.store().context());
  ASSERT_TRUE(proof);
  for (const ChainFinding& f : proof->findings) ADD_FAILURE() << f.table << ' ' << f.row << ' ' << f.what;
  EXPECT_TRUE(records.store().sessions.find(kept));
}

}  // namespace
}  // namespace cusp::test
