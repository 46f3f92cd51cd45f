/// Painted bar gauges: a scale, a wanted band, a marker and the number. Round dials never. A screen reader gets name,
/// value, least and most.
#pragma once

#include <QColor>
#include <QWidget>
#include <optional>

namespace cusp::ui {

/// Upright gauge with its scale, as the depth and push of the drilling screen. The number keeps its width.
class Gauge : public QWidget {
  Q_OBJECT

 public:
  enum class Grows { down, up };          // where the scale's zero lies: top or bottom
  enum class ScaleSide { left, right };

  explicit Gauge(const QString& title, const QString& unit, Grows grows, QWidget* parent = nullptr);

  void set_range(double least, double most, double major_step, int minor_per_major = 5);
  void set_decimals(int decimals);
  void set_scale_side(ScaleSide side);
  /// Wanted band, and a limit line beyond it; nullopt for none.
  void set_band(std::optional<double> lo, std::optional<double> hi);
  void set_limit(std::optional<double> limit);
  /// nullopt: not measured now; shows a dash.
  void set_value(std::optional<double> value);

  QString title() const { return title_; }
  double least() const { return least_; }
  double most() const { return most_; }
  std::optional<double> value() const { return value_; }
  QString value_text() const;

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  double y_of(double value, const QRectF& bar) const;

  QString title_, unit_;
  Grows grows_;
  ScaleSide side_ = ScaleSide::left;
  double least_ = 0, most_ = 3, major_ = 0.5;
  int minor_ = 5, decimals_ = 2;
  std::optional<double> band_lo_, band_hi_, limit_, value_;
};

/// Flat bar: a share of something, in one role's colour. Used in panels, tables and progress.
class Bar : public QWidget {
  Q_OBJECT

 public:
  enum class Role { accent, target, good, look, bad, enamel, dentine, caries, pulp, plain };
  explicit Bar(Role role = Role::accent, QWidget* parent = nullptr);
  void set_role(Role role);
  /// Clamped to [0, 1]; `spoken` is what a screen reader says ("6.82 mm³").
  void set_share(double share, const QString& spoken = {});
  double share() const { return share_; }
  QString spoken() const { return spoken_; }
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  Role role_;
  double share_ = 0;
  QString spoken_;
};

QColor colour_of(Bar::Role role);

/// Paints a Bar's drawing anywhere (table cells, paper).
void paint_bar(QPainter& painter, const QRectF& rect, double share, const QColor& fill, const QColor& track);

}  // namespace cusp::ui
