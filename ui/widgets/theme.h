/// Every colour, size and font of the desktop, light and dark, at 100 to 200 %. Painted widgets read tokens(); no other file
/// of ui holds a colour. Thread: GUI.
#pragma once

#include <QColor>
#include <QFont>
#include <QProxyStyle>
#include <QString>

class QApplication;
class QLabel;
class QPalette;
class QWidget;

namespace cusp::ui {

/// Colours by role (ui/README.md). tests/ui/widgets holds their contrast.
struct Tokens {
  bool dark = false;
  QColor window, surface, sunken, hover;
  QColor line;                    // ornament: cards, rules
  QColor border;                  // controls; at least 3:1
  QColor text, text2, text3;      // text3 is also disabled text
  QColor accent, on_accent, accent_soft;  // accent is also the focus
  QColor good, good_soft, look, look_soft, bad, bad_soft;
  QColor view_middle, view_edge;  // behind the tooth
  QColor bar_enamel, bar_dentine, bar_carious, bar_pulp;
  QColor line_target, line_leeway, line_over, line_under;
  QColor shadow;

  static const Tokens& light();
  static const Tokens& dark_theme();
};

/// Colours on the tooth itself: the same in both themes.
struct ToothColours {
  QColor enamel, dentine, carious, pulp, target, casing, leeway, over, under, water;
  /// Difference map at -0.5 (uncut remainder), -0.3, 0, +0.3 and +0.5 mm (over-cut).
  QColor map[5];
  static const ToothColours& get();
};

enum class ColourScheme { system, light, dark };

/// Sets palette, style sheet, style and fonts of the program, at the start and at every change of theme or scale.
void apply_theme(QApplication& app, ColourScheme scheme, int scale_percent);

/// Tokens of the present theme.
const Tokens& tokens();

/// Length at the present scale of a length at 100 %.
int px(int at_100);
double px(double at_100);
int scale_percent();

/// Sizes of ui/README.md: 12, 13, 15, 18, 24 and 40 px at 100 %.
enum class TextRole { caption, body, section, live, page_title, score };
enum class Weight { regular, bold };
QFont font_of(TextRole role, Weight weight = Weight::regular);

/// A label in a text role. `ink` is a property of the style sheet: "", "text2", "text3", "good", "look", "bad", "accent".
QLabel* make_label(const QString& text, TextRole role = TextRole::body, Weight weight = Weight::regular, const char* ink = "");
void set_ink(QWidget* widget, const char* ink);

/// Sets the variant that theme.qss styles ("primary", "erase", "card", "bar_good"), and polishes the widget again.
void set_kind(QWidget* widget, const char* kind);

/// Fusion with the theme's metrics and a focus ring: 2 px of accent, 2 px off the widget.
class CuspStyle : public QProxyStyle {
  Q_OBJECT

 public:
  CuspStyle();
  int pixelMetric(PixelMetric metric, const QStyleOption* option, const QWidget* widget) const override;
  int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                QStyleHintReturn* data) const override;
  void drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                   const QWidget* widget) const override;
  void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override;
};

}  // namespace cusp::ui
