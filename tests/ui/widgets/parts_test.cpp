// Gauges, tables and parts.

#include <gtest/gtest.h>

#include <QAccessible>
#include <QApplication>
#include <QDialog>
#include <QFileDialog>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QScreen>
#include <QScrollBar>
#include <QSignalSpy>
#include <QStandardItemModel>
#include <QTableView>
#include <QTest>
#include <QTextDocumentFragment>
#include <QVBoxLayout>

#include "tests/modules.h"
#include "ui/widgets/busy.h"
#include "ui/widgets/chip.h"
#include "ui/widgets/format.h"
#include "ui/widgets/gauge.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/ports.h"
#include "ui/widgets/table.h"

namespace cusp::test {
namespace {

/// A band across the top of a page.
Band* add_band_to(QWidget& page) {
  auto* column = new QVBoxLayout(&page);
  column->setContentsMargins(0, 0, 0, 0);
  auto* band = new Band;
  column->addWidget(band);
  column->addStretch();
  return band;
}

TEST(Gauge, describes_itself_to_a_screen_reader_with_its_name_value_and_range) {
  Gauge gauge(QStringLiteral("Depth"), QStringLiteral("mm"), Gauge::Grows::down);
  gauge.set_scale({.least = 0, .most = 3, .major_step = 0.5});
  gauge.set_value(1.52);
  QAccessibleInterface* face = QAccessible::queryAccessibleInterface(&gauge);
  ASSERT_NE(face, nullptr);
  EXPECT_EQ(face->text(QAccessible::Name).toStdString(), "Depth");
  ASSERT_NE(face->valueInterface(), nullptr);
  EXPECT_DOUBLE_EQ(face->valueInterface()->currentValue().toDouble(), 1.52);
  EXPECT_DOUBLE_EQ(face->valueInterface()->maximumValue().toDouble(), 3.0);
  EXPECT_TRUE(face->text(QAccessible::Value).contains(QStringLiteral("1.52")));
}

TEST(Gauge, without_a_value_shows_a_dash_and_takes_no_nonsense) {
  Gauge gauge(QStringLiteral("Push"), QStringLiteral("N"), Gauge::Grows::up);
  EXPECT_EQ(gauge.value_text().toStdString(), "–");
  gauge.set_value(std::numeric_limits<double>::infinity());
  EXPECT_FALSE(gauge.value().has_value());
  gauge.resize(104, 420);
  EXPECT_FALSE(gauge.grab().isNull());
}

TEST(Band, puts_buttons_that_take_more_than_half_of_its_width_below_its_text) {
  QWidget page;
  Band* band = add_band_to(page);
  std::vector<QPushButton*> buttons;
  for (const char* name : {"Keep", "See", "Replace"}) {
    buttons.push_back(make_button(QLatin1String(name)));
    buttons.back()->setFixedWidth(300);
    band->ways_out()->addWidget(buttons.back());
  }
  page.resize(700, 600);
  page.show();
  band->show_message(Band::Kind::look, QStringLiteral("Another window saved this draft."), QStringLiteral("Yours is not saved."));
  const auto text_bottom = [&] {
    for (const QLabel* label : band->findChildren<QLabel*>())
      if (!label->text().isEmpty()) return label->geometry().bottom();
    return -1;
  };
  ASSERT_TRUE(QTest::qWaitFor([&] { return buttons[0]->y() > text_bottom() && text_bottom() > 0; }));
  EXPECT_EQ(page.width(), 700) << "the buttons did not widen the page";
  EXPECT_EQ(buttons[1]->y(), buttons[0]->y());
  EXPECT_GT(buttons[2]->y(), buttons[0]->geometry().bottom()) << "two of 300 px in 640";
  for (const QPushButton* button : buttons) EXPECT_TRUE(band->rect().contains(button->geometry())) << button->text().toStdString();
  page.resize(2000, 600);
  EXPECT_TRUE(QTest::qWaitFor([&] { return buttons[0]->y() <= text_bottom() && buttons[2]->y() == buttons[0]->y(); }));
}

TEST(Band, with_a_name_of_60_letters_takes_lines_and_does_not_widen_the_page) {
  constexpr int kWidth = 480;  // half of full HD at 200 %; the name alone takes some 840 px
  const QString name(60, u'W');
  QWidget page;
  Band* band = add_band_to(page);
  page.resize(kWidth, 300);
  page.show();
  band->show_message(Band::Kind::good, QStringLiteral("%1 is saved.").arg(name), QStringLiteral("%1 can sign in.").arg(name));
  QTest::qWait(0);
  EXPECT_LE(page.minimumSizeHint().width(), kWidth);
  EXPECT_EQ(page.width(), kWidth);
  EXPECT_EQ(band->text(), QStringLiteral("%1 is saved. %1 can sign in.").arg(name)) << "a screen reader hears the name in one";
}

TEST(Card, takes_lines_for_a_title_and_an_aside_of_60_letters) {
  constexpr int kWidth = 960;  // of half of full HD; in one line the two take some 1800 px
  const QString name(60, u'W');
  Card card(name, name);
  card.wrap_title();
  card.wrap_aside();
  EXPECT_LE(card.minimumSizeHint().width(), kWidth);
  card.set_title(name);
  card.set_aside(name);
  EXPECT_LE(card.minimumSizeHint().width(), kWidth);
  EXPECT_EQ(card.accessibleName(), name);
}

TEST(Band, for_rows_that_could_not_be_read_gives_them_the_focus_and_goes_unless_they_fail_again) {
  QWidget page;
  auto* column = new QVBoxLayout(&page);
  auto* rows = new QLineEdit;
  int asked = 0;
  Band* band = nullptr;
  const auto fail = [&] { band->show_message(Band::Kind::bad, QStringLiteral("The entries could not be read.")); };
  band = make_unread_band(rows, [&] {
    if (++asked == 1) fail();
  });
  column->addWidget(band);
  column->addWidget(rows);
  page.show();
  EXPECT_FALSE(band->isVisible());
  fail();
  auto* again = band->findChild<QPushButton*>();
  ASSERT_NE(again, nullptr);
  EXPECT_EQ(again->accessibleName().toStdString(), "Try again");
  again->setFocus();
  again->click();
  EXPECT_EQ(asked, 1);
  EXPECT_TRUE(band->isVisible()) << "they failed once more";
  EXPECT_EQ(page.focusWidget(), rows);
  again->click();
  EXPECT_EQ(asked, 2);
  EXPECT_FALSE(band->isVisible());
}

TEST(Bar, keeps_its_share_between_nothing_and_all) {
  Bar bar;
  bar.set_share(1.7);
  EXPECT_DOUBLE_EQ(bar.share(), 1.0);
  bar.set_share(-1);
  EXPECT_DOUBLE_EQ(bar.share(), 0.0);
  bar.set_share(std::numeric_limits<double>::quiet_NaN());
  EXPECT_DOUBLE_EQ(bar.share(), 0.0);
}

TEST(Bar, describes_itself_to_a_screen_reader_with_its_value_with_the_unit) {
  Bar bar;
  bar.set_share(0.34, QStringLiteral("6.82 mm³"));
  QAccessibleInterface* face = QAccessible::queryAccessibleInterface(&bar);
  ASSERT_NE(face, nullptr);
  EXPECT_EQ(face->role(), QAccessible::ProgressBar);
  EXPECT_EQ(face->text(QAccessible::Value).toStdString(), "6.82 mm³");
  ASSERT_NE(face->valueInterface(), nullptr);
  EXPECT_DOUBLE_EQ(face->valueInterface()->currentValue().toDouble(), 0.34);
}

TEST(Bar, is_filled_in_its_roles_colour_in_light_and_dark) {
  for (const ColourScheme scheme : {ColourScheme::light, ColourScheme::dark}) {
    apply_theme(*qApp, scheme, 100);
    Bar bar(Bar::Role::carious);
    bar.set_share(0.5);
    bar.resize(100, 6);
    const QImage seen = bar.grab().toImage();
    EXPECT_EQ(seen.pixelColor(25, 3).name().toStdString(), tokens().bar_carious.name().toStdString());
    EXPECT_EQ(seen.pixelColor(75, 3).name().toStdString(), tokens().sunken.name().toStdString());
    bar.set_role(Bar::Role::pulp);
    EXPECT_EQ(bar.grab().toImage().pixelColor(25, 3).name().toStdString(), tokens().bar_pulp.name().toStdString());
  }
  apply_theme(*qApp, ColourScheme::light, 100);
}

TEST(Parts, a_form_gives_each_field_its_label_as_buddy_and_name) {
  QWidget page;
  QFormLayout* form = make_form();
  page.setLayout(form);
  auto* name = new QLineEdit;
  QLabel* label = add_field(*form, QStringLiteral("Name"), name);
  EXPECT_EQ(label->buddy(), name);
  EXPECT_EQ(name->accessibleName().toStdString(), "Name");
  page.resize(300, 100);
  page.show();
  EXPECT_GT(name->y(), label->y());  // the label stands above
}

TEST(Ports, a_name_without_suffix_gets_that_of_the_suggested_one) {
  QWidget page;
  Ports::of_the_system().pick_file(&page, {QStringLiteral("Save"), QStringLiteral("molar 1.5.cusp"), QStringLiteral("Exercise (*.cusp)")}, [](const QString&) {});
  auto* dialog = page.findChild<QFileDialog*>();
  ASSERT_NE(dialog, nullptr);
  EXPECT_EQ(dialog->defaultSuffix().toStdString(), "cusp");
  dialog->reject();
}

TEST(Ports, replacing_is_offered_only_where_the_writer_replaces) {
  for (const auto what : {FileWish::What::file, FileWish::What::new_file}) {
    QWidget page;
    FileWish wish{QStringLiteral("Save"), QStringLiteral("pack.cusppack"), QStringLiteral("Appeal pack (*.cusppack)")};
    wish.what = what;
    Ports::of_the_system().pick_file(&page, wish, [](const QString&) {});
    auto* dialog = page.findChild<QFileDialog*>();
    ASSERT_NE(dialog, nullptr);
    EXPECT_EQ(dialog->testOption(QFileDialog::DontConfirmOverwrite), what == FileWish::What::new_file);
    dialog->reject();
  }
}

TEST(Ports, the_window_is_the_active_one_after_a_file_is_chosen_or_not) {
  QWidget page;
  page.show();
  Ports::of_the_system().pick_file(&page, {QStringLiteral("Save"), QStringLiteral("molar.cusp"), QStringLiteral("Exercise (*.cusp)")}, [](const QString&) {});
  auto* dialog = page.findChild<QFileDialog*>();
  ASSERT_NE(dialog, nullptr);
  ASSERT_TRUE(QTest::qWaitForWindowActive(dialog));
  dialog->reject();
  EXPECT_TRUE(QTest::qWaitForWindowActive(&page));
}

TEST(Ports, a_question_that_follows_a_chosen_file_stays_the_active_window) {
  QWidget page;
  page.show();
  QDialog first(&page);
  activate_after(first, &page);
  first.open();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&first));
  Ports::of_the_system().ask(&page, {QStringLiteral("Open it?"), {}, QStringLiteral("Open")}, [](bool) {});
  auto* box = page.findChild<QMessageBox*>();
  ASSERT_NE(box, nullptr);
  first.accept();
  EXPECT_TRUE(QTest::qWaitForWindowActive(box));
  EXPECT_FALSE(page.isActiveWindow());
  box->reject();
}

TEST(Ports, a_key_that_is_held_since_before_a_question_does_not_answer_it) {
  QWidget page;
  page.show();
  bool answered = false;
  Ports::of_the_system().ask(&page, {QStringLiteral("Hand in?"), {}, QStringLiteral("Hand in")}, [&answered](bool) { answered = true; });
  auto* box = page.findChild<QMessageBox*>();
  ASSERT_NE(box, nullptr);
  QPushButton* act = box->defaultButton();
  QTest::simulateEvent(act, true, Qt::Key_Return, Qt::NoModifier, QString(), true);
  QTest::simulateEvent(box, true, Qt::Key_Escape, Qt::NoModifier, QString(), true);
  EXPECT_FALSE(answered);
  QTest::keyClick(act, Qt::Key_Return);
  EXPECT_TRUE(answered);
}

TEST(Ports, the_text_of_a_question_begins_where_its_buttons_do) {
  QWidget page;
  page.show();
  Ports::of_the_system().ask(&page, {QStringLiteral("Leave this attempt?"), QStringLiteral("It stays in your results as interrupted."), QStringLiteral("Leave"), true}, [](bool) {});
  auto* box = page.findChild<QMessageBox*>();
  ASSERT_NE(box, nullptr);
  QTest::qWait(0);
  int first_text = box->width(), first_button = box->width();
  for (const QLabel* label : box->findChildren<QLabel*>())
    if (label->isVisible() && !label->text().isEmpty()) first_text = std::min(first_text, label->mapTo(box, label->contentsRect().topLeft()).x());
  for (const QPushButton* button : box->findChildren<QPushButton*>())
    if (button->isVisible()) first_button = std::min(first_button, button->mapTo(box, QPoint()).x());
  EXPECT_EQ(first_text, first_button);
  box->reject();
}

TEST(Chip, is_no_window_before_a_page_takes_it) {
  auto* chip = new Chip(QStringLiteral("Passed"), Chip::Kind::good);
  auto* empty = new Chip;
  EXPECT_FALSE(chip->isVisible());
  QWidget page;
  auto* column = new QVBoxLayout(&page);
  column->addWidget(chip);
  column->addWidget(empty);
  page.show();
  EXPECT_TRUE(chip->isVisible());
  EXPECT_FALSE(empty->isVisible());
  empty->set(QStringLiteral("Draft"), Chip::Kind::plain);
  EXPECT_TRUE(empty->isVisible());
}

TEST(Table, opens_a_row_with_enter_and_chooses_one_in_right_to_left_too) {
  QStandardItemModel model(3, 2);
  for (int row = 0; row < 3; ++row) model.setItem(row, 0, new QStandardItem(QString::number(row)));
  Table table;
  table.setModel(&model);
  table.setLayoutDirection(Qt::RightToLeft);
  table.show();
  table.choose_row(1);
  EXPECT_EQ(table.chosen_row(), 1);
  QSignalSpy opened(&table, &Table::row_opened);
  QTest::keyClick(&table, Qt::Key_Return);
  ASSERT_EQ(opened.count(), 1);
  EXPECT_EQ(opened[0][0].toModelIndex().row(), 1);
  table.choose_row(7);  // no such row: the choice stays
  EXPECT_EQ(table.chosen_row(), 1);
}

TEST(Table, a_bar_below_wide_rows_covers_none_of_them) {
  QStandardItemModel model(2, 3);
  for (int row = 0; row < 2; ++row)
    for (int column = 0; column < 3; ++column) model.setItem(row, column, new QStandardItem(QStringLiteral("a cell of some width")));
  QWidget page;
  auto* column = new QVBoxLayout(&page);
  auto* table = new Table;
  table->setModel(&model);
  table->set_stretch_column(0);
  table->set_rows_shown(16);
  column->addWidget(table);
  column->addStretch();
  const auto rows_shown = [&] { return table->viewport()->height() >= 2 * px(36); };
  page.resize(300, 400);
  page.show();
  EXPECT_TRUE(QTest::qWaitFor([&] { return table->horizontalScrollBar()->isVisible() && rows_shown(); }));
  const int with_bar = table->height();
  page.resize(900, 400);
  EXPECT_TRUE(QTest::qWaitFor([&] { return !table->horizontalScrollBar()->isVisible() && rows_shown() && table->height() < with_bar; }));
}

TEST(Busy, stays_hidden_for_work_that_is_over_at_once) {
  QWidget page;
  Busy busy(&page);
  page.show();
  busy.start(QStringLiteral("Reading the tooth"), Busy::Cancel::offered);
  EXPECT_FALSE(busy.isVisible());
  busy.finish();
  QTest::qWait(Busy::kDelayMs + 50);
  EXPECT_FALSE(busy.isVisible());
  busy.start(QStringLiteral("Reading the tooth"), Busy::Cancel::offered);
  ASSERT_TRUE(QTest::qWaitFor([&] { return busy.isVisible(); }));
}

TEST(Parts, a_dialog_leaves_a_rim_of_the_screen_for_its_frame) {
  constexpr int kHighestFrame = 32;  // px, of a title bar; the offscreen platform's screen has 800 x 800
  QDialog dialog;
  const QSize all = dialog.screen()->availableGeometry().size(), most = most_of_screen(dialog);
  EXPECT_LE(most.height(), all.height() - kHighestFrame);
  EXPECT_LT(most.width(), all.width());
  EXPECT_GT(most.height(), all.height() * 9 / 10);
}

TEST(Parts, buttons_and_icon_buttons_have_names) {
  const std::unique_ptr<QPushButton> button(make_button(QStringLiteral("Finish"), ButtonKind::primary, QStringLiteral("flag")));
  EXPECT_EQ(button->accessibleName().toStdString(), "Finish");
  const std::unique_ptr<QToolButton> alone(make_icon_button(QStringLiteral("globe"), QStringLiteral("Language"), QKeySequence(Qt::Key_F9)));
  EXPECT_EQ(alone->accessibleName().toStdString(), "Language");
  EXPECT_EQ(alone->toolTip().toStdString(), "Language (F9)");
}

TEST(Parts, a_name_that_is_html_is_shown_as_it_stands) {
  const QString name = QStringLiteral("<img src=\"/dev/zero\"> & <a href=\"http://x\">Lena</a>");
  const std::unique_ptr<QLabel> label(make_label(name));
  EXPECT_EQ(label->textFormat(), Qt::PlainText);
  QWidget page;
  Ports::of_the_system().ask(&page, {name, name + u'\n' + name, QStringLiteral("Erase")}, [](bool) {});
  auto* box = page.findChild<QMessageBox*>();
  ASSERT_NE(box, nullptr);
  for (const QString& html : {box->text(), box->informativeText(), tool_tip_text(name), short_tool_tip(name)}) {
    EXPECT_FALSE(html.contains(u"<img")) << html.toStdString();
    EXPECT_TRUE(QTextDocumentFragment::fromHtml(html).toPlainText().startsWith(name)) << html.toStdString();
  }
  EXPECT_EQ(QTextDocumentFragment::fromHtml(box->informativeText()).toPlainText(), name + u'\n' + name);
  EXPECT_EQ(short_tool_tip(QStringLiteral("Bur 330")), QStringLiteral("Bur 330"));
  box->reject();
}

TEST(Parts, a_band_reports_what_happened_and_goes_away) {
  QWidget page;
  Band band(&page);
  page.show();
  EXPECT_FALSE(band.isVisible());
  band.show_message(Band::Kind::bad, QStringLiteral("The disk is full."), QStringLiteral("<All> before it is kept."));
  EXPECT_TRUE(band.isVisible());
  EXPECT_EQ(band.text().toStdString(), "The disk is full. <All> before it is kept.");
  band.clear();
  EXPECT_FALSE(band.isVisible());
}

TEST(Parts, segments_have_one_chosen_and_report_a_change) {
  Segments who({QStringLiteral("Student"), QStringLiteral("Staff")});
  QSignalSpy changed(&who, &Segments::changed);
  EXPECT_EQ(who.chosen(), 0);
  who.button(1)->click();
  EXPECT_EQ(who.chosen(), 1);
  ASSERT_EQ(changed.count(), 1);
  EXPECT_EQ(changed[0][0].toInt(), 1);
}

}  // namespace
}  // namespace cusp::test
