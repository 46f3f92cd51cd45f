#include "ui/widgets/theme.h"

#include "scenarios/tissues/tissue_facts.h"
#include "ui/modules.h"
#include "ui/widgets/icon.h"
#include "ui/widgets/page_style.h"

#include <QApplication>
#include <QFile>
#include <QFocusFrame>
#include <QFontDatabase>
#include <QLabel>
#include <QPainter>
#include <QPalette>
#include <QPointer>
#include <QRegularExpression>
#include <QStyle>
#include <QStyleFactory>
#include <QStyleOption>
#include <QTabBar>
#include <QTemporaryDir>
#include <algorithm>
#include <atomic>
#include <utility>
#include <vector>

static void load_resources() { Q_INIT_RESOURCE(cusp_widgets); }

namespace cusp::ui {
namespace {

std::atomic<int> g_scale_percent{100};  // a task that writes a PDF reads it

Tokens make_light() {
  Tokens t;
  t.dark = false;
  t.window = QColor(u"#F3F4F6"_qs), t.surface = QColor(u"#FFFFFF"_qs);
  t.sunken = QColor(u"#E9EBEF"_qs), t.hover = QColor(u"#E4E8EE"_qs);
  t.line = QColor(u"#D3D7DE"_qs), t.border = QColor(u"#7D8693"_qs);
  t.text = QColor(u"#16191E"_qs), t.text2 = QColor(u"#4A515D"_qs), t.text3 = QColor(u"#5F6773"_qs);
  t.accent = QColor(u"#1F5BB8"_qs), t.on_accent = QColor(u"#FFFFFF"_qs), t.accent_soft = QColor(u"#DFE9F8"_qs);
  t.good = QColor(u"#1B7340"_qs), t.good_soft = QColor(u"#DDF1E4"_qs);
  t.look = QColor(u"#8A5300"_qs), t.look_soft = QColor(u"#FBEBCF"_qs);
  t.bad = QColor(u"#B3261E"_qs), t.bad_soft = QColor(u"#FBE3E0"_qs);
  t.view_middle = QColor(u"#CDD4DC"_qs), t.view_edge = QColor(u"#AFB8C3"_qs);
  t.bar_enamel = QColor(u"#8C7B52"_qs), t.bar_dentine = QColor(u"#A06A17"_qs);
  t.bar_carious = QColor(u"#6A3D1E"_qs), t.bar_pulp = QColor(u"#B01E55"_qs);
  t.line_target = QColor(u"#007A68"_qs), t.line_leeway = QColor(u"#2F68C4"_qs);
  t.line_over = QColor(u"#B54708"_qs), t.line_under = QColor(u"#5B3DA8"_qs);
  t.shadow = QColor(u"#33000000"_qs);
  return t;
}

Tokens make_dark() {
  Tokens t;
  t.dark = true;
  t.window = QColor(u"#14171B"_qs), t.surface = QColor(u"#1C2026"_qs);
  t.sunken = QColor(u"#101316"_qs), t.hover = QColor(u"#2A3038"_qs);
  t.line = QColor(u"#343B45"_qs), t.border = QColor(u"#7C8795"_qs);
  t.text = QColor(u"#ECEEF1"_qs), t.text2 = QColor(u"#B3BBC6"_qs), t.text3 = QColor(u"#929CA9"_qs);
  t.accent = QColor(u"#82B1FF"_qs), t.on_accent = QColor(u"#0B1B33"_qs), t.accent_soft = QColor(u"#1D3356"_qs);
  t.good = QColor(u"#5FCB8A"_qs), t.good_soft = QColor(u"#16341F"_qs);
  t.look = QColor(u"#F0B65A"_qs), t.look_soft = QColor(u"#3B2B0E"_qs);
  t.bad = QColor(u"#FF8B80"_qs), t.bad_soft = QColor(u"#431B18"_qs);
  t.view_middle = QColor(u"#262B32"_qs), t.view_edge = QColor(u"#0E1114"_qs);
  t.bar_enamel = QColor(u"#F1EBDD"_qs), t.bar_dentine = QColor(u"#DFB26B"_qs);
  t.bar_carious = QColor(u"#B98158"_qs), t.bar_pulp = QColor(u"#F0679A"_qs);
  t.line_target = QColor(u"#2FC7AF"_qs), t.line_leeway = QColor(u"#7FAEF5"_qs);
  t.line_over = QColor(u"#F2913D"_qs), t.line_under = QColor(u"#A98BF0"_qs);
  t.shadow = QColor(u"#80000000"_qs);
  return t;
}

QPalette palette_of(const Tokens& t) {
  QPalette p;
  p.setColor(QPalette::Window, t.window);
  p.setColor(QPalette::WindowText, t.text);
  p.setColor(QPalette::Base, t.surface);
  p.setColor(QPalette::AlternateBase, t.window);
  p.setColor(QPalette::Text, t.text);
  p.setColor(QPalette::PlaceholderText, t.text3);
  p.setColor(QPalette::Button, t.surface);
  p.setColor(QPalette::ButtonText, t.text);
  p.setColor(QPalette::BrightText, t.bad);
  p.setColor(QPalette::Highlight, t.accent);
  p.setColor(QPalette::HighlightedText, t.on_accent);
  p.setColor(QPalette::Link, t.accent);
  p.setColor(QPalette::LinkVisited, t.accent);
  p.setColor(QPalette::ToolTipBase, t.surface);
  p.setColor(QPalette::ToolTipText, t.text);
  p.setColor(QPalette::Light, t.surface);
  p.setColor(QPalette::Midlight, t.hover);
  p.setColor(QPalette::Mid, t.line);
  p.setColor(QPalette::Dark, t.border);
  p.setColor(QPalette::Shadow, t.text);
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
    p.setColor(QPalette::Disabled, role, t.text3);
  }
  return p;
}

/// Longest names first: @text is the beginning of @text2.
std::vector<std::pair<QString, QColor>> named_colours(const Tokens& t) {
  std::vector<std::pair<QString, QColor>> named = {
      {u"@window"_qs, t.window},           {u"@surface"_qs, t.surface},       {u"@sunken"_qs, t.sunken},
      {u"@hover"_qs, t.hover},             {u"@line"_qs, t.line},             {u"@border"_qs, t.border},
      {u"@text"_qs, t.text},               {u"@text2"_qs, t.text2},           {u"@text3"_qs, t.text3},
      {u"@accent"_qs, t.accent},           {u"@on_accent"_qs, t.on_accent},   {u"@accent_soft"_qs, t.accent_soft},
      {u"@good"_qs, t.good},               {u"@good_soft"_qs, t.good_soft},   {u"@look"_qs, t.look},
      {u"@look_soft"_qs, t.look_soft},     {u"@bad"_qs, t.bad},               {u"@bad_soft"_qs, t.bad_soft},
      {u"@bar_enamel"_qs, t.bar_enamel},   {u"@bar_dentine"_qs, t.bar_dentine}, {u"@bar_carious"_qs, t.bar_carious},
      {u"@bar_pulp"_qs, t.bar_pulp},       {u"@line_target"_qs, t.line_target},
  };
  std::sort(named.begin(), named.end(),
            [](const auto& a, const auto& b) { return a.first.size() > b.first.size(); });
  return named;
}

/// A PNG of the chevron in the theme's ink: a style sheet takes pictures from files only.
QString chevron_file(const Tokens& t) {
  static const QTemporaryDir folder;
  const QString file = folder.filePath(u"chevron-%1-%2.png"_qs.arg(t.dark ? u"dark"_qs : u"light"_qs).arg(scale_percent()));
  if (!QFile::exists(file)) icon_pixmap(u"chevron_down"_qs, Ink::text2, 16).save(file, "PNG");
  return file;
}

QString style_sheet(const Tokens& t) {
  QFile file(u":/cusp/theme.qss"_qs);
  if (!file.open(QIODevice::ReadOnly)) return {};
  QString text = QString::fromUtf8(file.readAll());
  for (const auto& [name, colour] : named_colours(t)) text.replace(name, colour.name());
  // "$32" is 32 px at 100 %.
  static const QRegularExpression length(u"\\$(\\d+)"_qs);
  QString out;
  qsizetype from = 0;
  for (auto it = length.globalMatch(text); it.hasNext();) {
    const auto m = it.next();
    out += text.mid(from, m.capturedStart() - from) + QString::number(px(m.captured(1).toInt())) + u"px"_qs;
    from = m.capturedEnd();
  }
  out += text.mid(from);
  return out.replace(u"%chevron_down%"_qs, chevron_file(t));
}

/// Fusion derives the frame from the window's colour, which has too little contrast in the dark theme.
void draw_check_box(QPainter& painter, const QStyleOption& option) {
  const Tokens& t = tokens();
  const bool enabled = option.state & QStyle::State_Enabled;
  const bool on = option.state & QStyle::State_On, some = option.state & QStyle::State_NoChange;
  const bool filled = enabled && (on || some);
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  const bool under = option.state & QStyle::State_MouseOver;
  painter.setPen(QPen(!enabled ? t.line : under ? t.text : filled ? t.accent : t.border, px(1.0)));
  painter.setBrush(!enabled ? t.window : filled ? t.accent : t.surface);
  const QRectF box = QRectF(option.rect).adjusted(0.5, 0.5, -0.5, -0.5);
  painter.drawRoundedRect(box, px(4.0), px(4.0));
  painter.setPen(QPen(enabled ? t.on_accent : t.text3, px(2.0), Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  const auto at = [&box](double x, double y) { return QPointF(box.left() + x * box.width(), box.top() + y * box.height()); };
  if (on) painter.drawPolyline(QPolygonF{at(0.25, 0.53), at(0.43, 0.71), at(0.76, 0.31)});
  if (some) painter.drawLine(at(0.28, 0.5), at(0.72, 0.5));
  painter.restore();
}

void draw_radio_button(QPainter& painter, const QStyleOption& option) {
  const Tokens& t = tokens();
  const bool enabled = option.state & QStyle::State_Enabled, on = option.state & QStyle::State_On;
  const bool under = option.state & QStyle::State_MouseOver;
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  const double side = std::min(option.rect.width(), option.rect.height()) - 1.0;
  const QPointF middle = QRectF(option.rect).center();
  painter.setPen(QPen(!enabled ? t.line : under ? t.text : on ? t.accent : t.border, px(on ? 2.0 : 1.0)));
  painter.setBrush(enabled ? t.surface : t.window);
  const double radius = 0.5 * (side - px(1.0));
  painter.drawEllipse(middle, radius, radius);
  if (on) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(enabled ? t.accent : t.text3);
    painter.drawEllipse(middle, 0.5 * radius, 0.5 * radius);
  }
  painter.restore();
}

/// A page's focus proxy is where the focus begins, once. Qt sends every Tab that enters the page to the proxy, past all that
/// stands before it.
void begun(const QWidget& now) {
  for (QWidget* page = now.parentWidget(); page != nullptr; page = page->parentWidget())
    if (page->focusProxy() == &now && page->focusPolicy() == Qt::NoFocus) page->setFocusProxy(nullptr);
}

/// Moves one QFocusFrame to the widget with the focus.
class FocusRing : public QObject {
 public:
  explicit FocusRing(QApplication* app) : QObject(app) {
    setObjectName(u"cusp_focus_ring"_qs);
    connect(app, &QApplication::focusChanged, this, [this](QWidget*, QWidget* now) {
      if (now) begun(*now);
      follow(now);
    });
  }
  void follow(QWidget* now) {
    // Pages and scroll areas answer no keys, so they get no ring.
    const bool wanted = now && now->isVisible() && now->parentWidget() && !now->isWindow() &&
                        !now->property("no_focus_ring").toBool() && now->focusPolicy() != Qt::NoFocus &&
                        !now->inherits("QMenu");
    if (!wanted) {
      delete frame_;
      return;
    }
    if (frame_ && frame_->widget() == now) return;
    delete frame_;
    frame_ = new QFocusFrame(now->window());
    frame_->setWidget(now);
  }

 private:
  QPointer<QFocusFrame> frame_;
};

}  // namespace

const Tokens& Tokens::light() {
  static const Tokens t = make_light();
  return t;
}
const Tokens& Tokens::dark_theme() {
  static const Tokens t = make_dark();
  return t;
}

const ToothColours& ToothColours::get() {
  const auto of = [](Tissue tissue) { return QColor::fromRgb(tissue_facts(tissue).colour.value); };
  static const ToothColours c{
      of(Tissue::enamel), of(Tissue::dentine), of(Tissue::carious_dentine), of(Tissue::pulp),
      QColor(u"#12B39A"_qs), QColor(u"#16191E"_qs), QColor(u"#2F68C4"_qs), QColor(u"#E0700F"_qs),
      QColor(u"#4B2E91"_qs), QColor(u"#9CC7E8"_qs),
      {QColor(u"#4B2E91"_qs), QColor(u"#9A86D0"_qs), QColor(u"#EFEDE6"_qs), QColor(u"#F2A65A"_qs),
       QColor(u"#B54708"_qs)}};
  return c;
}

void apply_theme(QApplication& app, ColourScheme scheme, int percent) {
  load_resources();
  static const QPalette of_the_system = QApplication::palette();
  const bool system_dark = of_the_system.color(QPalette::Window).lightness() < 128;
  const bool dark = scheme == ColourScheme::dark || (scheme == ColourScheme::system && system_dark);
  const Tokens& t = dark ? Tokens::dark_theme() : Tokens::light();
  g_scale_percent = std::clamp(percent, 100, 200);
  if (!app.findChild<QObject*>(u"cusp_focus_ring"_qs)) {
    QApplication::setStyle(new PageStyle);
    new FocusRing(&app);
  }
  QApplication::setFont(font_of(TextRole::body));
  QApplication::setPalette(palette_of(t));  // from here on tokens() are these
  app.setStyleSheet(style_sheet(t));
}

const Tokens& tokens() {
  return QGuiApplication::palette().color(QPalette::Window).lightness() < 128 ? Tokens::dark_theme() : Tokens::light();
}

int scale_percent() { return g_scale_percent; }
int px(int at_100) { return (at_100 * scale_percent() + 50) / 100; }
double px(double at_100) { return at_100 * scale_percent() / 100.0; }

QFont font_of(TextRole role, Weight weight) {
  int size = 13;
  switch (role) {
    case TextRole::caption: size = 12; break;
    case TextRole::body: size = 13; break;
    case TextRole::section: size = 15; break;
    case TextRole::live: size = 18; break;
    case TextRole::page_title: size = 24; break;
    case TextRole::score: size = 40; break;
  }
  QFont font;
  font.setFamilies({u"Noto Sans"_qs, u"Noto Sans Arabic"_qs, u"Noto Sans CJK SC"_qs, u"DejaVu Sans"_qs});
  font.setPixelSize(px(size));
  font.setBold(weight == Weight::bold);
  return font;
}

QLabel* make_label(const QString& text, TextRole role, Weight weight, const char* ink) {
  auto* label = new QLabel;
  // By its own choice Qt reads HTML, opens the files that it names, and shows its links.
  label->setTextFormat(Qt::PlainText);
  label->setText(text);
  static constexpr const char* kNames[] = {"caption", "body", "section", "live", "page_title", "score"};
  label->setProperty("role", QString::fromLatin1(kNames[static_cast<int>(role)]));
  label->setProperty("bold", weight == Weight::bold);
  label->setProperty("ink", QString::fromLatin1(ink));
  return label;
}

static void repolish(QWidget* widget) {
  widget->style()->unpolish(widget);
  widget->style()->polish(widget);
  widget->update();
}

void set_ink(QWidget* widget, const char* ink) {
  widget->setProperty("ink", QString::fromLatin1(ink));
  repolish(widget);
}

void set_kind(QWidget* widget, const char* kind) {
  widget->setProperty("kind", QString::fromLatin1(kind));
  repolish(widget);
}

CuspStyle::CuspStyle() : QProxyStyle(u"Fusion"_qs) {}

int CuspStyle::pixelMetric(PixelMetric metric, const QStyleOption* option, const QWidget* widget) const {
  switch (metric) {
    case PM_FocusFrameHMargin:
    case PM_FocusFrameVMargin: {
      // Tabs reach the edge of the window, so their ring lies inside them.
      const auto* ring = qobject_cast<const QFocusFrame*>(option ? option->styleObject : nullptr);
      return ring && qobject_cast<const QTabBar*>(ring->widget()) ? 0 : px(4);
    }
    case PM_ToolTipLabelFrameWidth: return px(6);
    case PM_ScrollBarExtent: return px(12);
    case PM_SmallIconSize:
    case PM_ButtonIconSize: return px(20);
    case PM_LayoutHorizontalSpacing:
    case PM_LayoutVerticalSpacing: return px(8);
    case PM_ExclusiveIndicatorWidth:
    case PM_ExclusiveIndicatorHeight:
    case PM_IndicatorWidth:
    case PM_IndicatorHeight: return px(18);
    default: return QProxyStyle::pixelMetric(metric, option, widget);
  }
}

int CuspStyle::styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                         QStyleHintReturn* data) const {
  switch (hint) {
    case SH_FocusFrame_AboveWidget: return 1;
    case SH_FocusFrame_Mask: return 0;
    case SH_UnderlineShortcut: return 0;
    case SH_Widget_Animation_Duration: return 0;  // nothing moves by itself
    case SH_EtchDisabledText: return 0;
    case SH_ItemView_ShowDecorationSelected: return 1;
    case SH_DialogButtonBox_ButtonsHaveIcons: return 0;  // Fusion's signs are of another family
    default: return QProxyStyle::styleHint(hint, option, widget, data);
  }
}

void CuspStyle::drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                            const QWidget* widget) const {
  if (element == CE_FocusFrame) {
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setPen(QPen(tokens().accent, px(2)));
    painter->setBrush(Qt::NoBrush);
    const double inset = px(2) / 2.0;
    painter->drawRoundedRect(QRectF(option->rect).adjusted(inset, inset, -inset, -inset), px(6), px(6));
    painter->restore();
    return;
  }
  QProxyStyle::drawControl(element, option, painter, widget);
}

void CuspStyle::drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                              const QWidget* widget) const {
  if (element == PE_FrameFocusRect) return;  // FocusRing draws instead
  if (element == PE_IndicatorCheckBox) {
    draw_check_box(*painter, *option);
    return;
  }
  if (element == PE_IndicatorRadioButton) {
    draw_radio_button(*painter, *option);
    return;
  }
  QProxyStyle::drawPrimitive(element, option, painter, widget);
}

}  // namespace cusp::ui
