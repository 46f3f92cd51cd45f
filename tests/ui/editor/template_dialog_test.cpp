// A new exercise from a template: the dialog makes a draft in the editor, refuses what does not fit, and Cancel changes nothing.
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QMenu>
#include <QPointer>
#include <QPushButton>
#include <QTest>

#include "scenarios/templates/templates.h"
#include "tests/ui/editor/editor_pages.h"
#include "tests/ui/looks.h"
#include "ui/editor/template_dialog.h"
#include "ui/editor/template_messages.h"
#include "ui/instructor/library_page.h"
#include "ui/text/language.h"
#include "ui/widgets/number_field.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"

namespace cusp::test {
namespace {

constexpr const char* kDepth = "Depth of the pulpal floor below the mouth";

/// The entry of the menu of beginnings that names a template.
QAction* begin_of(LibraryPage& page, const char* key) {
  return page.findChild<QMenu*>(QStringLiteral("begin"))->findChild<QAction*>(QLatin1String(key));
}

/// The library with the dialog open over it.
struct TemplateDialogs : EditorPages {
  std::unique_ptr<LibraryPage> page;
  std::unique_ptr<QSignalSpy> wanted;
  QPointer<TemplateDialog> dialog;
  void SetUp() override {
    EditorPages::SetUp();
    show_library();
    ask();
  }
  void show_library() {
    page = std::make_unique<LibraryPage>(records.store(), instructor.actor(), ports, records.file(), folder.path().toStdString());
    wanted = std::make_unique<QSignalSpy>(page.get(), &LibraryPage::edit_wanted);
    page->resize(1280, 800);
    page->show();
  }
  void ask() {
    begin_of(*page, "class-1-adhesive")->trigger();
    dialog = page->findChild<TemplateDialog*>();
    ASSERT_TRUE(dialog);
  }
  QPushButton* make() const { return named<QPushButton>(*dialog, "Make the exercise"); }
  QComboBox* combo(const char* name) const { return named<QComboBox>(*dialog, name); }
  QString standing() const { return dialog->findChild<Band*>()->text(); }
  void type(const char* field, const char* text) const {
    auto* number = named<NumberField>(*dialog, field);
    ASSERT_NE(number, nullptr);
    number->setFocus();
    number->selectAll();
    QTest::keyClicks(number, QLatin1String(text));
  }
  void leave_pictures();
  Scenario made() const { return wanted->at(0).at(0).value<EditorStart>().draft; }
};

/// Library and dialog in each language and look, and the editor with a class II, if pictures are wanted.
void TemplateDialogs::leave_pictures() {
  if (!pictures_wanted()) return;
  in_each_look([&](const QString& look) {
    for (const int index : {0, 3}) {
      show_library();
      ask();
      dialog->findChildren<QComboBox*>().at(0)->setCurrentIndex(index);
      NumberField* depth = dialog->findChildren<NumberField*>().at(1);
      depth->selectAll();
      if (index == 0) QTest::keyClicks(depth, QStringLiteral("9"));
      QTest::qWait(500);
      leave_picture(*dialog, QStringLiteral("template-%1-%2").arg(index).arg(look));
    }
    leave_picture(*page, QStringLiteral("library-") + look);
  });
  apply_theme(*qApp, ColourScheme::light, 200);
  show_library();
  ask();
  QTest::qWait(500);
  leave_picture(*dialog, QStringLiteral("template-200"));
  install_language(*qApp, QStringLiteral("en"));
  apply_theme(*qApp, ColourScheme::light, 100);
  show_library();
  ask();
  dialog->findChildren<QComboBox*>().at(0)->setCurrentIndex(3);
  dialog->accept();
  const auto editor = open(wanted->at(0).at(0).value<EditorStart>());
  QTest::qWait(2000);  // the view draws the target when it rests
  leave_picture(*editor, QStringLiteral("template-editor"));
}

TEST_F(TemplateDialogs, make_a_draft_that_opens_in_the_editor_and_is_kept_like_any_other) {
  combo("Template")->setCurrentIndex(1);
  combo("Tooth")->setCurrentText(QStringLiteral("14, upper right"));
  type(kDepth, "2.1");
  ASSERT_TRUE(make()->isEnabled());
  make()->click();
  ASSERT_EQ(wanted->count(), 1);
  const auto start = wanted->at(0).at(0).value<EditorStart>();
  EXPECT_FALSE(start.published.has_value());
  EXPECT_FALSE(start.draft.id.is_nil());
  EXPECT_EQ(start.draft.version, 1);
  auto same = fit_template({.key = "class-1-classical", .fdi = 14, .values = {{"depth", 2.1}}, .id = start.draft.id});
  ASSERT_TRUE(same);
  EXPECT_TRUE(start.draft == *same) << "values left at their defaults are the template's own";
  EditorModel model(start);
  EXPECT_FALSE(model.stack().canUndo());
  EXPECT_TRUE(model.set_depth_mm(1.9));
  model.stack().undo();
  EXPECT_TRUE(model.scenario() == *same);
  std::optional<std::string> kept;
  EXPECT_EQ(keep_draft(records.store(), instructor.actor(), model, kept), DraftSave::kept);
  EXPECT_EQ(records.store().scenarios.drafts(instructor.actor())->size(), 1u);
}

TEST_F(TemplateDialogs, make_an_exercise_of_every_template_by_its_defaults) {
  for (int i = 0; i < combo("Template")->count(); ++i) {
    combo("Template")->setCurrentIndex(i);
    EXPECT_TRUE(make()->isEnabled()) << standing().toStdString();
  }
}

TEST_F(TemplateDialogs, begin_with_the_template_that_the_menu_names) {
  for (const ExerciseTemplate& one : exercise_templates()) {
    dialog->reject();
    ASSERT_TRUE(QTest::qWaitFor([&] { return dialog.isNull(); }));
    begin_of(*page, one.key.c_str())->trigger();
    dialog = page->findChild<TemplateDialog*>();
    ASSERT_TRUE(dialog);
    EXPECT_EQ(combo("Template")->currentText().toStdString(), one.name.at("en"));
  }
}

TEST_F(TemplateDialogs, refuse_a_value_out_of_range_with_its_name_and_range) {
  type(kDepth, "9");
  EXPECT_FALSE(make()->isEnabled());
  EXPECT_TRUE(standing().contains(QLatin1String(kDepth))) << standing().toStdString();
  EXPECT_TRUE(standing().contains(QStringLiteral("is outside"))) << standing().toStdString();
  EXPECT_TRUE(standing().contains(QStringLiteral("2.6"))) << standing().toStdString();
  // Enter leaves the field; it must not make an exercise of the value before.
  QTest::keyClick(named<NumberField>(*dialog, kDepth), Qt::Key_Return);
  EXPECT_EQ(wanted->count(), 0);
  EXPECT_TRUE(dialog && dialog->isVisible());
  type(kDepth, "1.9");
  EXPECT_TRUE(QTest::qWaitFor([&] { return make()->isEnabled(); }));
}

TEST_F(TemplateDialogs, refuse_values_that_leave_nothing_of_the_preparation) {
  combo("Template")->setCurrentText(QStringLiteral("Class II, adhesive"));
  ASSERT_TRUE(make()->isEnabled());
  named<QCheckBox>(*dialog, "Mesial box")->setChecked(false);
  EXPECT_TRUE(QTest::qWaitFor([&] { return !make()->isEnabled(); }));
  EXPECT_TRUE(standing().startsWith(QStringLiteral("Choose a mesial box"))) << standing().toStdString();
  dialog->accept();
  EXPECT_EQ(wanted->count(), 0);
  named<QCheckBox>(*dialog, "Distal box")->setChecked(true);
  dialog->accept();  // does not wait for the pause
  ASSERT_EQ(wanted->count(), 1);
  EXPECT_EQ(made().title.at("en"), "Class II DO, adhesive, tooth 36");
}

TEST_F(TemplateDialogs, leave_everything_as_it_was_on_cancel) {
  type(kDepth, "2.1");
  named<QPushButton>(*dialog, "Cancel")->click();
  EXPECT_EQ(wanted->count(), 0);
  EXPECT_TRUE(records.store().scenarios.drafts(instructor.actor())->empty());
  EXPECT_FALSE(std::filesystem::exists(drafts_folder(records.file(), {}).parent_path()));
  EXPECT_TRUE(QTest::qWaitFor([&] { return dialog.isNull(); })) << "the next one starts anew";
  ask();
  EXPECT_DOUBLE_EQ(named<NumberField>(*dialog, kDepth)->value(), 1.6);  // class-1-adhesive.json
}

TEST_F(TemplateDialogs, offer_premolars_and_molars_and_follow_the_tooth_but_not_a_value_set_by_hand) {
  EXPECT_EQ(combo("Tooth")->count(), 20);
  EXPECT_EQ(combo("Tooth")->findData(33), -1);
  const char* ridge = "Marginal ridge that stays";  // 2.0 mm in a molar, 1.6 mm in a premolar
  EXPECT_DOUBLE_EQ(named<NumberField>(*dialog, ridge)->value(), 2.0);
  named<NumberField>(*dialog, kDepth)->setValue(1.9);
  combo("Tooth")->setCurrentIndex(combo("Tooth")->findData(35));
  EXPECT_DOUBLE_EQ(named<NumberField>(*dialog, ridge)->value(), 1.6);
  EXPECT_DOUBLE_EQ(named<NumberField>(*dialog, kDepth)->value(), 1.9);
}

TEST_F(TemplateDialogs, show_range_unit_default_and_source_of_each_parameter) {
  for (int i = 0; i < combo("Template")->count(); ++i) {
    combo("Template")->setCurrentIndex(i);
    for (const TemplateParameter& p : exercise_templates()[static_cast<std::size_t>(i)].parameters) {
      QWidget* field = nullptr;
      for (QWidget* one : dialog->findChildren<QWidget*>())
        if (one->accessibleName() == QString::fromStdString(p.name.at("en"))) field = one;
      ASSERT_NE(field, nullptr) << p.key;
      const QString note = field->accessibleDescription();
      EXPECT_TRUE(note.contains(QStringLiteral("efault"))) << note.toStdString();
      EXPECT_FALSE(note.contains(QStringLiteral(".md"))) << "no file that an instructor has: " << note.toStdString();
      EXPECT_EQ(note.contains(QStringLiteral("not verified [M]")), p.source.find("[M]") != std::string::npos) << note.toStdString();
      bool shown = false;
      for (const QLabel* label : dialog->findChildren<QLabel*>()) shown = shown || label->text() == note;
      EXPECT_TRUE(shown) << note.toStdString();
      EXPECT_EQ(note.contains(QStringLiteral(" to ")), !is_choice(p)) << note.toStdString();
    }
  }
  leave_pictures();
}

TEST_F(TemplateDialogs, lead_tab_through_the_parameters_to_the_buttons) {
  combo("Template")->setCurrentIndex(2);
  combo("Template")->setCurrentIndex(0);
  QStringList order;
  for (QWidget* w = combo("Tooth"); w != combo("Template"); w = w->nextInFocusChain())
    if ((w->focusPolicy() & Qt::TabFocus) && w->isVisible() && !w->accessibleName().isEmpty()) order += w->accessibleName();
  QStringList reading{QStringLiteral("Tooth")};
  for (const TemplateParameter& p : exercise_templates()[0].parameters) reading += QString::fromStdString(p.name.at("en"));
  reading += {QStringLiteral("Cancel"), QStringLiteral("Make the exercise")};
  EXPECT_EQ(order.join(u'|').toStdString(), reading.join(u'|').toStdString());
}

}  // namespace
}  // namespace cusp::test
