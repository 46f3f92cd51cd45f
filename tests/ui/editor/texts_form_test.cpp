// Title and briefing in any language.

#include "ui/editor/texts_form.h"

#include <gtest/gtest.h>

#include <QComboBox>
#include <QCoreApplication>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTest>

#include "scenarios/format/ranges.h"
#include "scenarios/format/read.h"
#include "scenarios/format/write.h"
#include "scenarios/library/library.h"
#include "tests/modules.h"
#include "ui/text/language.h"

namespace cusp::test {
namespace {

TEST(title_of_copy, is_one_that_an_exercise_can_hold) {
  EditorStart start;
  start.draft = *load_builtin("channel-1");
  const QString longest(static_cast<int>(kMostTextCharacters), u'ä');
  start.draft.title = title_of_copy({{"en", longest.toStdString()}, {"de", "Rinne"}});
  EXPECT_TRUE(read_scenario(canonical_json(start.draft)).has_value());
  EXPECT_TRUE(QString::fromStdString(start.draft.title.at("en")).endsWith(QStringLiteral("ä (copy)")));
  EXPECT_EQ(start.draft.title.at("de"), "Rinne (Kopie)");
}

struct TextsInLanguages : ::testing::Test {
  EditorStart start;
  std::unique_ptr<EditorModel> model;
  std::unique_ptr<TextsForm> form;
  void SetUp() override { start.draft = *load_builtin("channel-1"); }
  void open() {
    model = std::make_unique<EditorModel>(start);
    form = std::make_unique<TextsForm>(*model);
  }
  void add(const char* code) {
    for (QComboBox* box : form->findChildren<QComboBox*>()) {
      if (box->accessibleName() != QStringLiteral("Add a language")) continue;
      const int row = box->findData(QLatin1String(code));
      ASSERT_GE(row, 0);
      box->setCurrentIndex(row);
      Q_EMIT box->activated(row);
      EXPECT_EQ(box->currentIndex(), 0);
    }
  }
  template <class W>
  W* field(const QString& name) {
    for (W* w : form->findChildren<W*>())
      if (w->accessibleName() == name && !w->isHidden()) return w;
    return nullptr;
  }
  QPushButton* remove_button(const QString& language) {
    return field<QPushButton>(QStringLiteral("Remove %1").arg(language));
  }
};

TEST_F(TextsInLanguages, english_and_german_have_fields_at_once_and_stay) {
  open();
  EXPECT_EQ(form->shown_languages(), (QStringList{QStringLiteral("en"), QStringLiteral("de")}));
  EXPECT_EQ(remove_button(QStringLiteral("Deutsch")), nullptr);
  EXPECT_FALSE(model->remove_language("en"));
}

TEST_F(TextsInLanguages, a_long_title_shows_its_beginning) {
  start.draft.title["en"] = std::string(200, 'm');
  open();
  const auto* title = field<QLineEdit>(QStringLiteral("Title, English"));
  ASSERT_NE(title, nullptr);
  EXPECT_EQ(title->text().size(), 200);
  EXPECT_EQ(title->cursorPosition(), 0);
}

TEST_F(TextsInLanguages, an_added_one_is_typed_kept_and_undone) {
  open();
  add("fr");
  ASSERT_EQ(form->shown_languages().back(), QStringLiteral("fr"));
  EXPECT_EQ(model->stack().count(), 0) << "fields alone change nothing";
  auto* title = field<QLineEdit>(QStringLiteral("Title, Français"));
  ASSERT_NE(title, nullptr);
  QTest::keyClicks(title, QStringLiteral("Canal droit"));
  EXPECT_EQ(model->scenario().title.at("fr"), "Canal droit");
  auto* briefing = field<QPlainTextEdit>(QStringLiteral("Briefing, Français"));
  ASSERT_NE(briefing, nullptr);
  briefing->setPlainText(QStringLiteral("Fraisez un canal."));
  EXPECT_EQ(model->scenario().briefing.at("fr"), "Fraisez un canal.");
  model->stack().undo();
  EXPECT_FALSE(model->scenario().briefing.contains("fr"));
  EXPECT_EQ(briefing->toPlainText(), QString());
}

TEST_F(TextsInLanguages, the_focus_goes_to_an_added_one_before_what_stands_below) {
  open();
  add("fr");
  const QWidget* next = field<QPlainTextEdit>(QStringLiteral("Briefing, Deutsch"));
  ASSERT_NE(next, nullptr);
  do next = next->nextInFocusChain();
  while (!qobject_cast<const QLineEdit*>(next) && !qobject_cast<const QComboBox*>(next));
  EXPECT_EQ(next, field<QLineEdit>(QStringLiteral("Title, Français"))) << next->accessibleName().toStdString();
}

TEST_F(TextsInLanguages, adding_one_twice_makes_no_second_fields) {
  open();
  add("fr");
  add("fr");
  add("de");
  EXPECT_EQ(form->shown_languages().size(), 3);
}

TEST_F(TextsInLanguages, one_of_a_file_has_fields_and_goes_as_one_step_that_is_undone) {
  start.draft.title["pt_BR"] = "Canal reto";
  start.draft.briefing["pt_BR"] = "Corte um canal.";
  open();
  ASSERT_EQ(form->shown_languages().back(), QStringLiteral("pt_BR"));
  const QString name = language_name(QStringLiteral("pt_BR"));
  EXPECT_TRUE(name.endsWith(QStringLiteral("(BR)"))) << name.toStdString();
  auto* away = remove_button(name);
  ASSERT_NE(away, nullptr);
  away->click();
  QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  EXPECT_FALSE(form->shown_languages().contains(QStringLiteral("pt_BR")));
  EXPECT_FALSE(model->scenario().title.contains("pt_BR"));
  EXPECT_EQ(model->stack().count(), 1);
  model->stack().undo();
  EXPECT_EQ(model->scenario(), start.draft);
  ASSERT_TRUE(form->shown_languages().contains(QStringLiteral("pt_BR")));
  EXPECT_EQ(field<QLineEdit>(QStringLiteral("Title, %1").arg(name))->text(), QStringLiteral("Canal reto"));
}

TEST_F(TextsInLanguages, the_fields_of_a_file_s_language_stay_while_its_text_is_typed_anew) {
  start.draft.title["fr"] = "Canal";
  open();
  auto* title = field<QLineEdit>(QStringLiteral("Title, Français"));
  ASSERT_NE(title, nullptr);
  title->selectAll();
  QTest::keyClick(title, Qt::Key_Delete);
  EXPECT_FALSE(model->scenario().title.contains("fr"));
  ASSERT_EQ(field<QLineEdit>(QStringLiteral("Title, Français")), title);
  QTest::keyClicks(title, QStringLiteral("Fissure"));
  EXPECT_EQ(model->scenario().title.at("fr"), "Fissure");
}

TEST_F(TextsInLanguages, every_language_of_the_list_may_stand_in_an_exercise) {
  open();
  QStringList seen;
  for (const Language& language : world_languages()) {
    EXPECT_FALSE(language.name.isEmpty());
    EXPECT_FALSE(seen.contains(language.code)) << language.code.toStdString();
    seen += language.code;
    EXPECT_TRUE(model->set_title(language.code.toStdString(), language.name)) << language.code.toStdString();
  }
  for (const char* code : {"fr", "es", "pl", "tr", "ar", "zh", "ja"}) EXPECT_TRUE(seen.contains(QLatin1String(code))) << code;
}

}  // namespace
}  // namespace cusp::test
