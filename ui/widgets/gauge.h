/// Painted bar gauges: scale, required band, marker and number. A screen reader gets name, value, least and most.
/// Thread: GUI.
#pragma once

#include <QColor>
#include <QProgressBar>
#include <QWidget>
#include <optional>

namespace cusp::ui {

struct Tokens;

/// Upright gauge of a live value: depth and force of the drilling screen. The number keeps its width.
class Gauge : public QWidget {
  Q_OBJECT

 public:
  enum class Grows { down, up };  // from the top or from the bottom of the bar
  enum class ScaleSide { left, right };

  explicit Gauge(const QString& title, const QString& unit, Grows grows, QWidget* parent = nullptr);

  struct Scale {
    double least = 0, most = 3;
    double major_step = 0.5;  // between two figures
    int minor_per_major = 5;  // ticks without figure
  };
  void set_scale(const Scale& scale);
  void set_scale_side(ScaleSide side);
  /// The required band, and a limit line beyond it; nullopt for none.
  void set_band(std::optional<double> lo, std::optional<double> hi);
  void set_limit(std::optional<double> limit);
  /// nullopt shows a dash: nothing is measured now. A value that is not finite is taken for nullopt.
  void set_value(std::optional<double> value);

  QString title() const { return title_; }
  double least() const { return scale_.least; }
  double most() const { return scale_.most; }
  std::optional<double> value() const { return value_; }
  QString value_text() const;

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  double y_of(double value, const QRectF& bar) const;
  void paint_head(QPainter& p, const Tokens& t) const;
  void paint_track(QPainter& p, const QRectF& bar, const Tokens& t) const;
  void paint_scale(QPainter& p, const QRectF& bar, const Tokens& t) const;
  void paint_value(QPainter& p, const QRectF& bar, const Tokens& t) const;

  QString title_, unit_;
  Grows grows_;
  ScaleSide side_ = ScaleSide::left;
  Scale scale_;
  std::optional<double> band_lo_, band_hi_, limit_, value_;
};

/// Flat progress bar: a share of something, in the colour of one role (theme.qss, `QProgressBar[kind]`).
class Bar : public QProgressBar {
  Q_OBJECT

 public:
  enum class Role { accent, target, good, look, bad, enamel, dentine, carious, pulp, plain };
  explicit Bar(Role role = Role::accent, QWidget* parent = nullptr);
  void set_role(Role role);
  /// Clamped to [0, 1]; a screen reader reads `spoken` ("6.82 mm³").
  void set_share(double share, const QString& spoken = {});
  double share() const;
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return sizeHint(); }

 private:
  Role role_;
};

QColor colour_of(Bar::Role role);

/// Paints a Bar into table cells and on paper. `share` is clamped to [0, 1].
void paint_bar(QPainter& painter, const QRectF& rect, double share, const QColor& fill, const QColor& track);

}  // namespace cusp::ui
