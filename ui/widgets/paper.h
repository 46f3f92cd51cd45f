/// A sheet of paper that is written from top to foot. Thread: GUI, or any without a window.
#pragma once

#include <QFont>
#include <QRectF>
#include <QString>

#include "ui/widgets/theme.h"

class QPainter;

namespace cusp::ui {

inline constexpr double kNumberRing = 8;  // radius of a number in a ring, px of the screen at 100 %

/// Writes paragraphs from the top of the page to its foot. Lengths in pixels of the screen at 100 % pass through u().
class Paper {
 public:
  struct Type {
    double size;  // px at 100 %
    Weight weight;
    QColor ink;
  };
  /// Left edge and width, in units of the painter.
  struct Column {
    double x, width;
  };
  /// Whether the next paragraph stands below this one or beside it.
  enum class Then { advance, stay };

  /// `unit` of the painter's units to a pixel of the screen.
  Paper(QPainter& painter, const QRectF& page, double unit) : p_(painter), page_(page), u_(unit), y_(page.top()) {}

  double u(double px_at_100) const { return px_at_100 * u_; }
  double y() const { return y_; }
  void skip(double px_at_100) { y_ += u(px_at_100); }
  QPainter& painter() { return p_; }
  const QRectF& page() const { return page_; }
  QFont font(double size, Weight weight = Weight::regular) const;
  /// Writes one paragraph into a column, from y() on; returns its height.
  double write(const QString& text, const Column& column, const Type& type, Qt::Alignment align = Qt::AlignLeading,
               Then then = Then::advance);
  /// Height that write() takes.
  double height_of(const QString& text, double width, const Type& type);
  void rule(const QColor& ink);
  /// A number in a ring: on a picture, and before its sentence.
  void number(QPointF middle, int number);

 private:
  QPainter& p_;
  QRectF page_;
  double u_;
  double y_;
};

}  // namespace cusp::ui
