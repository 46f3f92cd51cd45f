/// How Cusp looks: every colour, size and font of the desktop, in one place. Painted widgets read tokens(); nothing
/// else in ui holds a colour. Light and dark, 100 to 200 %. GUI thread.
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

/// Roles, not hues: see ui/README.md for what each one means. Contrast is held by tests/ui/widgets.
struct Tokens {
  bool dark = false;
  QColor window, surface, sunken, hover;
  QColor line;                    // ornament: cards, rules
  QColor border;                  // controls; at least 3:1
  QColor text, text2, text3;      // text3 is also disabled text
  QColor accent, on_accent, accent_soft;  // accent is also the focus
  QColor good, good_soft, look, look_soft, bad, bad_soft;
  QColor view_middle, view_edge;  // behind the tooth
  QColor bar_enamel, bar_dentine, bar_caries, bar_pulp;
  QColor line_target, line_leeway, line_over, line_under;
  QColor shadow;

  static const Tokens& light();
  static const Tokens& dark_theme();
};

/// Colours on the tooth itself: the same in both themes.
struct ToothColours {
  QColor enamel, dentine, caries, pulp, target, casing, leeway, over, under, water;
  /// Difference map from far left standing to far cut too far, at -0.5, -0.3, 0, +0.3, +0.5 mm.
  QColor map[5];
  static const ToothColours& get();
};

enum class ColourScheme { system, light, dark };

/// Sets palette, style sheet, style and fonts of the whole program; may be called again at any time.
void apply_theme(QApplication& app, ColourScheme scheme, int scale_percent);

/// Tokens of the theme that the application's palette shows now.
const Tokens& tokens();

/// A length given at 100 %, at the present scale.
int px(int at_100);
double px(double at_100);
int scale_percent();

/// Sizes of ui/README.md: 12, 13, 15, 18, 24 and 40 px at 100 %.
enum class TextRole { caption, body, section, live, page_title, score };
QFont font_of(TextRole role, bool bold = false);

/// A label in a text role. `ink` is a property of the style sheet: "", "text2", "text3", "good", "look", "bad", "accent".
QLabel* make_label(const QString& text, TextRole role = TextRole::body, bool bold = false, const char* ink = "");
void set_ink(QWidget* widget, const char* ink);

/// Buttons' and frames' variants: "primary", "quiet", "erase", "checked", "link", "card", "band"... Re-polishes.
void set_kind(QWidget* widget, const char* kind);

/// Fusion with Cusp's metrics and its focus ring: 2 px accent, 2 px off, on whatever has the focus.
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
