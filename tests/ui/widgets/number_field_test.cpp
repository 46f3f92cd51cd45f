// NumberField: typing, pasting, stepping, refusals and messages.
#include "tests/modules.h"
#include "ui/widgets/number_field.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QClipboard>
#include <QLineEdit>
#include <QSignalSpy>
#include <QTest>
#include <QVBoxLayout>
#include <QWheelEvent>

#include "ui/widgets/parts.h"

namespace cusp::test {
namespace {

/// A field for 0.05 to 20 mm that stands at 2, in a window of its own.
struct Typed {
  QWidget window;
  NumberField* field = new NumberField;

  explicit Typed(const QLocale& locale = QLocale(QLocale::English)) {
    auto* column = new QVBoxLayout(&window);
    field->setLocale(locale);
    field->setDecimals(2);
    field->setRange(0.05, 20);
    field->setSingleStep(0.1);
    field->setSuffix(QStringLiteral("\u00A0mm"));
    field->setValue(2);
    column->addWidget(labelled(QStringLiteral("Depth"), field));
    window.show();
    window.activateWindow();
    EXPECT_TRUE(QTest::qWaitForWindowActive(&window));
    field->setFocus();
  }
  double type(const QString& text) {
    field->selectAll();
    QTest::keyClicks(field, text);
    QTest::keyClick(field, Qt::Key_Return);
    return field->value();
  }
};

TEST(NumberField, reads_comma_and_full_stop_as_decimal_signs_in_every_language) {
  for (const QLocale::Language language : {QLocale::English, QLocale::German, QLocale::French, QLocale::Arabic}) {
    Typed at{QLocale(language)};
    EXPECT_DOUBLE_EQ(at.type(QStringLiteral("1,5")), 1.5) << language;
    EXPECT_DOUBLE_EQ(at.type(QStringLiteral("2.5")), 2.5) << language;
    EXPECT_TRUE(at.field->message().isEmpty()) << at.field->message().toStdString();
  }
}

TEST(NumberField, reads_no_exponent_no_group_and_no_second_sign) {
  for (const char* text : {"1e9", "1 000", "1.234,5", "1,2,3", "--1", "1-", "five", "", "0x10", "nan", "inf", "½", "."}) {
    EXPECT_FALSE(read_number(QString::fromUtf8(text)).has_value()) << text;
  }
  EXPECT_EQ(read_number(QStringLiteral("-3")), -3.0);
  EXPECT_EQ(read_number(QStringLiteral("−0,25")), -0.25);
  EXPECT_EQ(read_number(QStringLiteral("+.5")), 0.5);
  EXPECT_EQ(read_number(QStringLiteral("٣٫٥")), 3.5);  // Arabic digits and decimal sign
}

TEST(NumberField, shows_the_minus_of_every_other_number_and_takes_either) {
  Typed at;
  at.field->setRange(-20, 20);
  EXPECT_DOUBLE_EQ(at.type(QStringLiteral("-3")), -3.0);
  EXPECT_EQ(at.field->text().replace(QChar::Nbsp, u' ').toStdString(), "\u22123.00 mm");
  at.field->findChild<QLineEdit*>()->setText(QStringLiteral("\u22122"));
  QTest::keyClick(at.field, Qt::Key_Return);
  EXPECT_DOUBLE_EQ(at.field->value(), -2.0);
  at.field->stepUp();
  EXPECT_DOUBLE_EQ(at.field->value(), -1.9);
}

TEST(NumberField, a_number_outside_the_range_is_refused_as_a_whole_and_the_message_names_the_range) {
  Typed at;
  EXPECT_DOUBLE_EQ(at.type(QStringLiteral("-3")), 2.0);
  EXPECT_TRUE(at.field->message().contains(QStringLiteral("-3")));
  EXPECT_TRUE(at.field->message().contains(QStringLiteral("0.05")));
  EXPECT_TRUE(at.field->message().contains(QStringLiteral("20.00")));
  EXPECT_TRUE(at.field->note()->isVisible());
  EXPECT_EQ(at.field->accessibleDescription(), at.field->message());
  EXPECT_DOUBLE_EQ(at.type(QStringLiteral("20.01")), 2.0);
  EXPECT_TRUE(at.field->message().contains(QStringLiteral("20.01")));
  EXPECT_DOUBLE_EQ(at.type(QStringLiteral("20")), 20.0);
}

TEST(NumberField, what_is_no_number_is_refused_and_quoted) {
  Typed at;
  EXPECT_DOUBLE_EQ(at.type(QStringLiteral("1e9")), 2.0);
  EXPECT_TRUE(at.field->message().contains(QStringLiteral("1e9")));
  EXPECT_DOUBLE_EQ(at.type(QStringLiteral("two")), 2.0);
  EXPECT_TRUE(at.field->message().contains(QStringLiteral("two")));
  at.field->selectAll();
  QTest::keyClick(at.field, Qt::Key_Delete);
  QTest::keyClick(at.field, Qt::Key_Return);
  EXPECT_DOUBLE_EQ(at.field->value(), 2.0);
  EXPECT_FALSE(at.field->message().isEmpty());
}

TEST(NumberField, what_is_pasted_is_read_as_if_it_were_typed) {
  Typed at;
  const auto paste = [&](const QString& text) {
    QApplication::clipboard()->setText(text);
    at.field->selectAll();
    at.field->findChild<QLineEdit*>()->paste();
    QTest::keyClick(at.field, Qt::Key_Return);
    return at.field->value();
  };
  EXPECT_DOUBLE_EQ(paste(QStringLiteral("1,5 mm")), 1.5);
  EXPECT_DOUBLE_EQ(paste(QStringLiteral("1.234,5")), 1.5);
  EXPECT_FALSE(at.field->message().isEmpty());
}

TEST(NumberField, more_decimals_than_it_has_are_rounded_with_a_message) {
  Typed at;
  EXPECT_DOUBLE_EQ(at.type(QStringLiteral("1.234")), 1.23);
  EXPECT_TRUE(at.field->message().contains(QStringLiteral("1.23")));
  EXPECT_DOUBLE_EQ(at.type(QStringLiteral("1.231")), 1.23);  // the value that stands already
  EXPECT_FALSE(at.field->message().isEmpty());
  EXPECT_DOUBLE_EQ(at.type(QStringLiteral("1.2300")), 1.23);
  EXPECT_TRUE(at.field->message().isEmpty());
}

TEST(NumberField, the_note_goes_with_the_next_key_and_the_description_is_what_it_was) {
  Typed at;
  at.field->setAccessibleDescription(QStringLiteral("usual 2"));
  at.type(QStringLiteral("99"));
  EXPECT_NE(at.field->accessibleDescription().toStdString(), "usual 2");
  at.field->selectAll();
  QTest::keyClick(at.field, Qt::Key_3);
  EXPECT_TRUE(at.field->message().isEmpty());
  EXPECT_FALSE(at.field->note()->isVisible());
  EXPECT_EQ(at.field->accessibleDescription().toStdString(), "usual 2");
}

TEST(NumberField, a_value_shown_by_the_form_takes_an_old_note_away_and_keeps_what_is_half_typed) {
  Typed at;
  QSignalSpy changed(at.field, &QDoubleSpinBox::valueChanged);
  at.type(QStringLiteral("99"));
  at.field->show_value(3);
  EXPECT_TRUE(at.field->message().isEmpty());
  at.field->selectAll();
  QTest::keyClicks(at.field, QStringLiteral("1,"));
  at.field->show_value(3);
  EXPECT_TRUE(at.field->text().startsWith(QStringLiteral("1,")) && !at.field->text().contains(u'3'));
  EXPECT_EQ(changed.count(), 0);
  at.field->show_value(50);  // as a file may hold it
  EXPECT_TRUE(at.field->message().contains(QStringLiteral("50")));
}

TEST(NumberField, shows_only_needed_decimals_after_drop_needless_decimals) {
  Typed at;
  at.field->setRange(-1000, 1000);
  at.field->setSuffix({});
  EXPECT_EQ(at.field->text(), QStringLiteral("2.00"));
  at.field->drop_needless_decimals();
  EXPECT_EQ(at.field->text(), QStringLiteral("2"));
  for (const auto& [typed, shown] : {std::pair{"10", "10"}, {"12.50", "12.5"}, {"0.05", "0.05"}, {"-100", "\u2212100"}, {"0", "0"}}) {
    at.type(QString::fromUtf8(typed));
    EXPECT_EQ(at.field->text(), QString::fromUtf8(shown));
  }
  Typed arabic{QLocale(QLocale::Arabic, QLocale::Egypt)};
  arabic.field->drop_needless_decimals();
  arabic.type(QStringLiteral("10"));
  EXPECT_EQ(read_number(arabic.field->text().chopped(3)), 10.0);
  EXPECT_FALSE(arabic.field->text().contains(arabic.field->locale().decimalPoint()));
}

TEST(NumberField, steps_begin_with_what_was_typed_and_stop_at_what_is_refused) {
  Typed at;
  at.field->selectAll();
  QTest::keyClicks(at.field, QStringLiteral("1,5"));
  QTest::keyClick(at.field, Qt::Key_Up);
  EXPECT_DOUBLE_EQ(at.field->value(), 1.6);
  EXPECT_TRUE(at.field->message().isEmpty());
  at.field->selectAll();
  QTest::keyClicks(at.field, QStringLiteral("99"));
  QTest::keyClick(at.field, Qt::Key_Up);
  EXPECT_DOUBLE_EQ(at.field->value(), 1.6);
  EXPECT_FALSE(at.field->message().isEmpty());
}

TEST(NumberField, the_wheel_turns_only_a_field_that_has_the_focus) {
  Typed at;
  const auto wheel = [&] {
    QWheelEvent turn(QPointF(5, 5), at.field->mapToGlobal(QPointF(5, 5)), {}, QPoint(0, 120), Qt::NoButton, Qt::NoModifier,
                     Qt::NoScrollPhase, false);
    QApplication::sendEvent(at.field, &turn);
  };
  at.field->clearFocus();
  wheel();
  EXPECT_DOUBLE_EQ(at.field->value(), 2.0);
  at.field->setFocus();
  wheel();
  EXPECT_DOUBLE_EQ(at.field->value(), 2.1);
}

}  // namespace
}  // namespace cusp::test
