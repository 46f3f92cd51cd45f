// Languages: complete, switched while the program runs, and nothing on the screen that was never meant to be translated.

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QApplication>
#include <QFile>
#include <QLabel>
#include <QRegularExpression>
#include <QXmlStreamReader>
#include <atomic>
#include <thread>

#include "tests/modules.h"
#include "tests/source_dir.h"
#include "tests/ui/desk_records.h"
#include "ui/app/desktop.h"
#include "ui/text/grade_text.h"
#include "ui/text/incident_text.h"
#include "ui/text/language.h"
#include "ui/text/names.h"
#include "ui/app/shell.h"
#include "ui/widgets/format.h"

namespace cusp::test {
namespace {

struct Message {
  QString context, source, translation;
  QStringList forms;
  bool finished = true, plural = false;
};

QVector<Message> read_ts(const QString& name) {
  QVector<Message> messages;
  QFile file(QString::fromStdString((source_dir() / "translations").string()) + QLatin1Char('/') + name);
  if (!file.open(QIODevice::ReadOnly)) return messages;
  QXmlStreamReader xml(&file);
  QString context;
  Message m;
  while (!xml.atEnd()) {
    xml.readNext();
    if (xml.isStartElement()) {
      if (xml.name() == u"name") context = xml.readElementText();
      if (xml.name() == u"message") {
        m = Message{};
        m.context = context;
        m.plural = xml.attributes().value(QStringLiteral("numerus")) == u"yes";
      }
      if (xml.name() == u"source") m.source = xml.readElementText();
      if (xml.name() == u"translation") {
        m.finished = !xml.attributes().hasAttribute(QStringLiteral("type"));
        if (!m.plural) m.translation = xml.readElementText();
      }
      if (xml.name() == u"numerusform") m.forms += xml.readElementText();
    }
    if (xml.isEndElement() && xml.name() == u"message") messages += m;
  }
  return messages;
}

TEST(Languages, ATaskReadsAnExercisesTextWhileItsLanguageIsChosen) {
  const LocalText texts{{"en", "Channel"}};
  const QString one(64, u'a'), other(64, u'b');
  choose_exercise_language(one);
  std::atomic<bool> over{false};
  std::jthread task([&] {
    while (!over) EXPECT_EQ(local(texts), QStringLiteral("Channel"));
  });
  for (int i = 0; i < 200'000; ++i) choose_exercise_language(i % 2 == 0 ? other : one);
  over = true;
  task.join();
  choose_exercise_language({});
}

TEST(Languages, german_is_complete) {
  const auto messages = read_ts(QStringLiteral("cusp_de.ts"));
  ASSERT_GT(messages.size(), 300);
  for (const Message& m : messages) {
    EXPECT_TRUE(m.finished) << m.context.toStdString() << ": " << m.source.toStdString();
    // lupdate loses the namespace after code that it misreads; such a text would stay English.
    EXPECT_TRUE(m.context.startsWith(QStringLiteral("cusp::ui::"))) << m.context.toStdString() << ": " << m.source.toStdString();
    if (m.plural) {
      ASSERT_EQ(m.forms.size(), 2) << m.source.toStdString();
      for (const QString& form : m.forms) EXPECT_FALSE(form.isEmpty()) << m.source.toStdString();
    } else {
      EXPECT_FALSE(m.translation.isEmpty()) << m.context.toStdString() << ": " << m.source.toStdString();
    }
  }
}

TEST(Languages, english_has_every_plural) {
  const auto english = read_ts(QStringLiteral("cusp_en.ts")), german = read_ts(QStringLiteral("cusp_de.ts"));
  qsizetype plurals = 0;
  for (const Message& m : german) plurals += m.plural ? 1 : 0;
  ASSERT_EQ(english.size(), plurals);
  for (const Message& m : english) {
    EXPECT_TRUE(m.finished) << m.source.toStdString();
    ASSERT_EQ(m.forms.size(), 2);
    EXPECT_NE(m.forms[0], m.forms[1]) << m.source.toStdString();
  }
}

TEST(Languages, a_translation_keeps_every_place_holder) {
  static const QRegularExpression holder(QStringLiteral("%L?[0-9]|%n"));
  for (const Message& m : read_ts(QStringLiteral("cusp_de.ts"))) {
    QStringList wanted;
    for (auto it = holder.globalMatch(m.source); it.hasNext();) wanted += it.next().captured();
    wanted.sort();
    for (const QString& text : m.plural ? m.forms : QStringList{m.translation}) {
      QStringList found;
      for (auto it = holder.globalMatch(text); it.hasNext();) found += it.next().captured();
      found.sort();
      // A singular may have "one" instead of the number.
      if (m.plural) found.removeAll(QStringLiteral("%n")), wanted.removeAll(QStringLiteral("%n"));
      EXPECT_EQ(found, wanted) << m.source.toStdString() << " / " << text.toStdString();
    }
  }
}

TEST(Languages, switching_changes_text_and_numbers_at_once) {
  install_language(*qApp, QStringLiteral("de"));
  EXPECT_EQ(current_language().toStdString(), "de");
  EXPECT_EQ(metric_name("uncut_remainder").toStdString(), "Nicht entfernt");
  EXPECT_EQ(format_number(1.5, 1).toStdString(), "1,5");
  install_language(*qApp, QStringLiteral("en"));
  EXPECT_EQ(metric_name("uncut_remainder").toStdString(), "Not removed");
  EXPECT_EQ(format_number(1.5, 1).toStdString(), "1.5");
}

TEST(Languages, one_that_is_not_known_is_english) {
  install_language(*qApp, QStringLiteral("xx"));
  EXPECT_EQ(current_language().toStdString(), "en");
  qputenv("LC_ALL", "de_AT.UTF-8");
  install_language(*qApp, {});
  EXPECT_EQ(current_language().toStdString(), "de");
  qputenv("LC_ALL", "C.UTF-8");
  install_language(*qApp, QStringLiteral("en"));
}

TEST(Languages, an_exercise_shows_its_text_in_the_chosen_language_then_in_the_program_s_then_in_english) {
  const LocalText three = {{"en", "Channel"}, {"de", "Kanal"}, {"fr", "Canal"}}, one = {{"en", "Channel"}};
  install_language(*qApp, QStringLiteral("de"));
  EXPECT_EQ(local(three).toStdString(), "Kanal");
  choose_exercise_language(QStringLiteral("fr"));
  EXPECT_EQ(local(three).toStdString(), "Canal");
  EXPECT_EQ(local(one).toStdString(), "Channel");
  choose_exercise_language(QStringLiteral("es"));
  EXPECT_EQ(local(three).toStdString(), "Kanal");
  choose_exercise_language({});
  install_language(*qApp, QStringLiteral("en"));
}

TEST(Languages, are_named_by_themselves_and_an_unknown_code_names_itself) {
  EXPECT_EQ(language_name(QStringLiteral("de")).toStdString(), "Deutsch");
  EXPECT_EQ(language_name(QStringLiteral("fr")).toStdString(), "Français");
  EXPECT_EQ(language_name(QStringLiteral("pt_BR")).toStdString(), "Português (BR)");
  EXPECT_EQ(language_name(QStringLiteral("qqq")).toStdString(), "qqq");
}

/// Texts that are shown but are nobody's to translate: names, numbers, dates, what a person wrote.
bool translatable(const QString& text, const QStringList& own) {
  static const QRegularExpression letters(QStringLiteral("\\p{L}{2,}"));
  if (!text.contains(letters)) return false;
  for (const QString& part : own) {
    // An exercise's own text, whole or by its first sentence.
    if (!part.isEmpty() && (text.trimmed() == part || (text.size() > 40 && part.startsWith(text)))) return false;
  }
  return true;
}

TEST(Languages, german_has_what_no_page_shows_at_first) {
  install_language(*qApp, QStringLiteral("de"));
  constexpr std::pair<const char*, const char*> texts[] = {
      {"cusp::ui::StopCard", "The driver of the device stands still"},
      {"cusp::ui::StopCard", "Unplug the device and plug it in again. What was drilled until then is kept."},
      {"cusp::ui::Performance", "Kind"},
      {"cusp::ui::Performance", "All kinds"},
      {"cusp::ui::Performance", "Practice"},
      {"cusp::ui::Performance", "Assessments"},
      {"cusp::ui::Performance", "points by attempt, all exercises together"},
      {"cusp::ui::Cli", "Only this kind; of a gradebook the assignment, where the exercise is assigned more than once"}};
  for (const auto& [context, text] : texts) EXPECT_NE(QCoreApplication::translate(context, text), QString::fromUtf8(text)) << text;
  install_language(*qApp, QStringLiteral("en"));
}

TEST(Languages, no_text_on_any_page_was_forgotten) {
  test::DeskRecords records;
  const Account lena = records.student("1", "Lena Brandt");
  records.attempt(lena, "channel-1", 78, 426);
  QStringList own = {QStringLiteral("Cusp"), QStringLiteral("Lena Brandt"), QStringLiteral("Anna Weber"), QSysInfo::machineHostName(),
                     QStringLiteral("English"), QStringLiteral("Deutsch"), QStringLiteral("Falcon"), QStringLiteral("Inverse3"), QStringLiteral("SpaceMouse"),
                     QString::fromStdString(records.file().string()), fingerprint(records.store().context().key->id())};
  const auto exercises = load_exercises(records.store());
  ASSERT_TRUE(exercises.has_value());
  for (const Exercise& e : exercises->exercises) {
    for (const LocalText& texts : {e.scenario.title, e.scenario.briefing}) {
      for (const auto& [code, text] : texts) own += QString::fromStdString(text);
    }
  }
  install_language(*qApp, QStringLiteral("pseudo"));
  Settings settings(QDir::temp().filePath(QStringLiteral("cusp-pseudo.ini")));
  Ports ports = Ports::of_the_system();
  for (const Account& who : {records.administrator(), lena}) {
    Desktop desktop(settings, ports, records.file());
    desktop.start();
    desktop.show();
    const auto check = [&](const QString& page) {
      static const QRegularExpression caps(QStringLiteral("^(Ctrl|Alt|Esc|Enter|Space|Page Up|Page Down|Return|F\\d+|.)$"));
      static const QRegularExpression date(QStringLiteral("^\\w{3} \\d+ \\w{3}"));
      for (const QWidget* w : desktop.findChildren<QWidget*>()) {
        QString text;
        if (const auto* label = qobject_cast<const QLabel*>(w)) text = label->text();
        if (const auto* button = qobject_cast<const QAbstractButton*>(w)) text = button->text();
        if (text.contains(QRegularExpression(QStringLiteral("[\\[\\]]"))) || text.contains(date) || text.contains(caps)) continue;
        if (text.startsWith(u"English") || text.startsWith(u"Deutsch")) continue;
        text.replace(QChar(0x00A0), u' ');  // between a figure and its unit
        EXPECT_FALSE(translatable(text, own)) << page.toStdString() << ": " << text.toStdString();
      }
    };
    check(QStringLiteral("sign in"));
    desktop.sign_in(who);
    for (const NavEntry& entry : desktop.shell()->entries()) {
      desktop.shell()->show_page(entry.key);
      EXPECT_TRUE(entry.name.startsWith(u'[')) << entry.name.toStdString();
      check(entry.key);
    }
  }
  install_language(*qApp, QStringLiteral("en"));
}

}  // namespace
}  // namespace cusp::test
