// Colours, style sheet and icons.

#include <gtest/gtest.h>

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QProxyStyle>
#include <QRadioButton>
#include <QRegularExpression>
#include <QScrollArea>
#include <QScrollBar>
#include <QSlider>
#include <QSpinBox>
#include <QStyleOptionButton>
#include <QTabBar>
#include <QTabWidget>
#include <QTest>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <QWheelEvent>
#include <cmath>
#include <vector>

#include "tests/modules.h"
#include "tests/source_dir.h"
#include "ui/widgets/icon.h"
#include "ui/widgets/theme.h"

namespace cusp::test {
namespace {

/// WCAG 2.1: relative luminance and contrast ratio.
double luminance(const QColor& c) {
  const auto channel = [](double v) { return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); };
  return 0.2126 * channel(c.redF()) + 0.7152 * channel(c.greenF()) + 0.0722 * channel(c.blueF());
}
double contrast(const QColor& a, const QColor& b) {
  const double la = luminance(a), lb = luminance(b);
  return (std::max(la, lb) + 0.05) / (std::min(la, lb) + 0.05);
}

TEST(Look, every_text_role_can_be_read_on_every_ground) {
  for (const Tokens* t : {&Tokens::light(), &Tokens::dark_theme()}) {
    for (const QColor& ground : {t->window, t->surface, t->sunken, t->hover}) {
      for (const QColor& ink : {t->text, t->text2, t->text3, t->good, t->look, t->bad}) {
        EXPECT_GE(contrast(ink, ground), 4.5) << ink.name().toStdString() << " on " << ground.name().toStdString();
      }
    }
    EXPECT_GE(contrast(t->on_accent, t->accent), 4.5);
    EXPECT_GE(contrast(t->good, t->good_soft), 4.5);
    EXPECT_GE(contrast(t->look, t->look_soft), 4.5);
    EXPECT_GE(contrast(t->bad, t->bad_soft), 4.5);
    EXPECT_GE(contrast(t->text, t->accent_soft), 4.5);
  }
}

TEST(Look, borders_bars_and_lines_stand_out_by_three_to_one) {
  for (const Tokens* t : {&Tokens::light(), &Tokens::dark_theme()}) {
    for (const QColor& ink : {t->border, t->accent, t->bar_enamel, t->bar_dentine, t->bar_carious, t->bar_pulp, t->line_target,
                              t->line_leeway, t->line_over, t->line_under}) {
      EXPECT_GE(contrast(ink, t->surface), 3.0) << ink.name().toStdString();
    }
  }
}

TEST(Look, no_colour_stands_outside_the_theme) {
  // A literal colour elsewhere would not follow light and dark. The tooth's own colours live in ui/render/colours.h.
  static const QRegularExpression literal(
      QStringLiteral("#[0-9A-Fa-f]{6}\\b|QColor\\([0-9]|rgba?\\([0-9]|Qt::(white|black|red|green|blue|gray|yellow)\\b"));
  const QString root = QString::fromStdString((source_dir() / "ui").string());
  QDirIterator files(root, {QStringLiteral("*.cpp"), QStringLiteral("*.h"), QStringLiteral("*.qss"), QStringLiteral("*.svg")},
                     QDir::Files, QDirIterator::Subdirectories);
  int read = 0;
  while (files.hasNext()) {
    const QString name = files.next();
    if (name.endsWith(QStringLiteral("widgets/theme.cpp")) || name.contains(QStringLiteral("/ui/render/"))) continue;
    QFile file(name);
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    const auto found = literal.match(QString::fromUtf8(file.readAll()));
    EXPECT_FALSE(found.hasMatch()) << name.toStdString() << ": " << found.captured().toStdString();
    ++read;
  }
  EXPECT_GT(read, 50);
  // It can fail: the theme itself would be found.
  QFile theme(root + QStringLiteral("/widgets/theme.cpp"));
  ASSERT_TRUE(theme.open(QIODevice::ReadOnly));
  EXPECT_TRUE(literal.match(QString::fromUtf8(theme.readAll())).hasMatch());
}

TEST(Look, the_style_sheet_has_every_name_filled_in) {
  apply_theme(*qApp, ColourScheme::light, 100);
  const QString sheet = qApp->styleSheet();
  EXPECT_GT(sheet.size(), 2000);
  EXPECT_FALSE(sheet.contains(QRegularExpression(QStringLiteral("@[a-z]"))));
  EXPECT_FALSE(sheet.contains(QRegularExpression(QStringLiteral("\\$[0-9]"))));
  // @text2 came out as itself, not as @text with a 2.
  EXPECT_TRUE(sheet.contains(Tokens::light().text2.name()));
  EXPECT_FALSE(sheet.contains(Tokens::light().text.name() + u'2'));
}

TEST(Look, scale_enlarges_lengths_and_type) {
  apply_theme(*qApp, ColourScheme::light, 150);
  EXPECT_EQ(px(32), 48);
  EXPECT_EQ(font_of(TextRole::section).pixelSize(), 23);  // 15 * 1.5, rounded up
  EXPECT_TRUE(qApp->styleSheet().contains(QStringLiteral("min-height: 45px")));  // $30
  apply_theme(*qApp, ColourScheme::light, 400);
  EXPECT_EQ(scale_percent(), 200);
  apply_theme(*qApp, ColourScheme::light, 100);
}

TEST(Look, every_icon_is_drawn_in_the_ink_that_was_asked_for) {
  const QStringList files = QDir(QStringLiteral(":/cusp/icons")).entryList({QStringLiteral("*.svg")}, QDir::Files);
  EXPECT_GE(files.size(), 60);
  for (const QString& file : files) {
    const QString name = file.chopped(4);
    const QImage image = icon_pixmap(name, Ink::accent, 20).toImage().convertToFormat(QImage::Format_ARGB32);
    ASSERT_EQ(image.size(), QSize(20, 20)) << name.toStdString();
    int inked = 0;
    for (int y = 0; y < 20; ++y) {
      for (int x = 0; x < 20; ++x) {
        const QColor c = image.pixelColor(x, y);
        if (c.alpha() < 120) continue;
        ++inked;
        EXPECT_LE(std::abs(c.red() - Tokens::light().accent.red()), 4) << name.toStdString();
      }
    }
    EXPECT_GT(inked, 3) << name.toStdString();
  }
}

TEST(Look, the_frame_of_an_unchecked_box_is_a_controls_border) {
  for (const ColourScheme scheme : {ColourScheme::light, ColourScheme::dark}) {
    apply_theme(*qApp, scheme, 100);
    QCheckBox box;
    box.resize(40, 40);
    QStyleOptionButton option;
    option.initFrom(&box);
    const QRect frame = box.style()->subElementRect(QStyle::SE_CheckBoxIndicator, &option, &box);
    const QImage seen = box.grab().toImage();
    EXPECT_EQ(seen.pixelColor(frame.left(), frame.center().y()).name().toStdString(), tokens().border.name().toStdString());
  }
  apply_theme(*qApp, ColourScheme::light, 100);
}

TEST(Look, the_text_of_a_radio_button_stands_as_far_from_its_sign_as_that_of_a_check_box) {
  apply_theme(*qApp, ColourScheme::light, 100);
  QRadioButton radio;
  QCheckBox check;
  for (QWidget* button : {static_cast<QWidget*>(&radio), static_cast<QWidget*>(&check)}) button->ensurePolished();
  EXPECT_EQ(radio.style()->pixelMetric(QStyle::PM_RadioButtonLabelSpacing, nullptr, &radio), px(8));
  EXPECT_EQ(check.style()->pixelMetric(QStyle::PM_CheckBoxLabelSpacing, nullptr, &check), px(8));
}

TEST(Look, a_chosen_row_of_a_tree_has_no_notch_beside_its_indent) {
  apply_theme(*qApp, ColourScheme::light, 100);
  QTreeWidget tree;
  tree.setHeaderHidden(true);
  auto* whole = new QTreeWidgetItem(&tree, {QStringLiteral("Union")});
  auto* part = new QTreeWidgetItem(whole, {QStringLiteral("Box")});
  tree.expandAll();
  tree.resize(240, 120);
  tree.show();
  tree.setCurrentItem(part);
  const QRect row = tree.visualItemRect(part);
  const QImage seen = tree.viewport()->grab().toImage();
  for (int x = row.left() - 4; x < row.left() + 4; ++x)
    EXPECT_EQ(seen.pixelColor(x, row.top() + 1).name().toStdString(), tokens().accent_soft.name().toStdString()) << x - row.left();
}

TEST(Look, no_box_stands_where_two_scroll_bars_meet) {
  apply_theme(*qApp, ColourScheme::light, 100);
  QScrollArea area;
  auto* inside = new QWidget;
  inside->setFixedSize(800, 800);
  area.setWidget(inside);
  area.resize(200, 200);
  area.show();
  const int bar = area.verticalScrollBar()->width();
  ASSERT_EQ(bar, px(12));
  const QImage seen = area.grab().toImage();
  for (int x = 200 - bar; x < 200; ++x)
    for (int y = 200 - bar; y < 200; ++y) ASSERT_EQ(seen.pixelColor(x, y).name().toStdString(), seen.pixelColor(199, 199).name().toStdString()) << x << ' ' << y;
}

/// As Fusion asks for signs on a desktop; offscreen it does not.
class SignedButtons : public QProxyStyle {
 public:
  int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget, QStyleHintReturn* data) const override {
    return hint == SH_DialogButtonBox_ButtonsHaveIcons ? 1 : QProxyStyle::styleHint(hint, option, widget, data);
  }
};

TEST(Look, the_buttons_of_a_file_picker_have_no_signs_of_another_family) {
  CuspStyle style;
  style.setBaseStyle(new SignedButtons);
  EXPECT_EQ(style.styleHint(QStyle::SH_DialogButtonBox_ButtonsHaveIcons, nullptr, nullptr, nullptr), 0);
}

TEST(Look, an_icon_follows_the_theme_without_being_made_again) {
  const QIcon made = icon(QStringLiteral("check"), Ink::text);
  const auto darkest = [&] {
    const QImage image = made.pixmap(QSize(20, 20)).toImage();
    int least = 255;
    for (int y = 0; y < image.height(); ++y) {
      for (int x = 0; x < image.width(); ++x) {
        if (image.pixelColor(x, y).alpha() > 200) least = std::min(least, image.pixelColor(x, y).lightness());
      }
    }
    return least;
  };
  apply_theme(*qApp, ColourScheme::light, 100);
  EXPECT_LT(darkest(), 60);
  apply_theme(*qApp, ColourScheme::dark, 100);
  EXPECT_TRUE(tokens().dark);
  EXPECT_GT(darkest(), 200);
  apply_theme(*qApp, ColourScheme::light, 100);
}

/// Whether `over` takes the wheel; if not, its parents get a real one.
bool roll_down(QWidget* over) {
  const QPointF at = over->rect().center();
  QWheelEvent down(at, over->mapToGlobal(at), {}, {0, -120}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
  QApplication::sendEvent(over, &down);
  return down.isAccepted();
}

TEST(Look, the_wheel_scrolls_a_page_whatever_field_has_the_focus_and_the_keys_change_the_field) {
  apply_theme(*qApp, ColourScheme::light, 100);
  QScrollArea area;
  auto* page = new QWidget;
  auto* body = new QVBoxLayout(page);
  auto* number = new QSpinBox;
  auto* choice = new QComboBox;
  choice->addItems({"a", "b", "c"});
  auto* slider = new QSlider(Qt::Horizontal);
  auto* tabs = new QTabBar;
  for (const char* name : {"a", "b"}) tabs->addTab(name);
  const std::vector<QWidget*> fields{number, choice, slider, tabs};
  for (QWidget* field : fields) body->addWidget(field);
  page->setFixedHeight(2000);
  area.setWidget(page);
  area.resize(300, 300);
  area.show();
  area.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&area));
  ASSERT_GT(area.verticalScrollBar()->maximum(), 0);
  number->setValue(50);
  slider->setValue(50);
  for (QWidget* field : fields) {
    field->setFocus();
    ASSERT_TRUE(field->hasFocus());
    EXPECT_FALSE(roll_down(field));
  }
  EXPECT_EQ(number->value(), 50);
  EXPECT_EQ(choice->currentIndex(), 0);
  EXPECT_EQ(slider->value(), 50);
  EXPECT_EQ(tabs->currentIndex(), 0);
  QTest::keyClick(number, Qt::Key_Down);
  QTest::keyClick(choice, Qt::Key_Down);
  QTest::keyClick(slider, Qt::Key_Left);
  EXPECT_EQ(number->value(), 49);
  EXPECT_EQ(choice->currentIndex(), 1);
  EXPECT_EQ(slider->value(), 49);
}

TEST(Look, no_tab_moves_when_another_is_chosen_or_has_the_focus) {
  apply_theme(*qApp, ColourScheme::light, 100);
  QTabWidget tabs;
  tabs.setDocumentMode(true);
  for (const char* name : {"Shape", "Points", "Burs", "Tissues"}) tabs.addTab(new QWidget, name);
  tabs.resize(600, 200);  // wide enough for all: a narrow bar scrolls to the chosen one
  tabs.show();
  const QTabBar& bar = *tabs.tabBar();
  const auto places = [&bar] {
    std::vector<QRect> out{bar.geometry()};
    for (int i = 0; i < bar.count(); ++i) out.push_back(bar.tabRect(i));
    return out;
  };
  const std::vector<QRect> at_first = places();
  for (int i = 0; i < bar.count(); ++i) {
    tabs.setCurrentIndex(i);
    tabs.tabBar()->setFocus();
    QCoreApplication::processEvents();
    EXPECT_EQ(places(), at_first) << bar.tabText(i).toStdString();
  }
}

TEST(Look, the_wheel_changes_a_number_a_choice_or_a_slider_only_where_it_has_the_focus) {
  QWidget page;
  auto* body = new QVBoxLayout(&page);
  auto* number = new QSpinBox;
  auto* choice = new QComboBox;
  choice->addItems({"a", "b", "c"});
  auto* slider = new QSlider(Qt::Horizontal);
  auto* other = new QCheckBox;
  for (QWidget* field : {static_cast<QWidget*>(number), static_cast<QWidget*>(choice), static_cast<QWidget*>(slider),
                         static_cast<QWidget*>(other)})
    body->addWidget(field);
  page.show();
  page.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&page));
  number->setValue(50);
  slider->setValue(50);
  other->setFocus();
  for (QWidget* over : {static_cast<QWidget*>(number), static_cast<QWidget*>(choice), static_cast<QWidget*>(slider)}) roll_down(over);
  EXPECT_EQ(number->value(), 50);
  EXPECT_EQ(choice->currentIndex(), 0);
  EXPECT_EQ(slider->value(), 50);
  number->setFocus();
  roll_down(number);
  EXPECT_EQ(number->value(), 49);
}

}  // namespace
}  // namespace cusp::test
