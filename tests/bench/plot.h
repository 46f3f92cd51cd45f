/// A frame with two axes, and labels that stand beside what they name and keep off each other.
#pragma once

#include <string>
#include <vector>

#include "tests/bench/svg.h"

namespace cusp::bench {

struct Axis {
  double low = 0.0, high = 1.0;
  bool log = false;
  std::string title;
  std::vector<std::pair<double, std::string>> ticks;  // where the axis is lettered

  /// 0 at low, 1 at high; beyond them outside that. Pre of a logarithmic one: value > 0.
  double place(double value) const;
};

/// Whole decades that hold all values, lettered 1, 10, 100, 1 k, 10 k, 1 M below and 0.1, 0.01 above.
/// Pre: values are positive, at least one.
Axis decades(std::string title, const std::vector<double>& values);
/// From low to high, lettered at each `every`.
Axis even(std::string title, double low, double high, double every);

/// 62,000 as "62 k", 1,500,000 as "1.5 M", 0.02 as "0.02": at most three figures.
std::string short_number(double value);

/// What stands on a picture already.
class Room {
 public:
  struct Box {
    Point a, b;
  };
  /// weight: how much worse than blank paper it is to stand on it.
  void take(Box box, double weight = 1.0) { taken_.emplace_back(box, weight); }
  void take_mark(Point at, double size, double weight = 2.0) {
    take({{at.x - 0.5 * size, at.y - 0.5 * size}, {at.x + 0.5 * size, at.y + 0.5 * size}}, weight);
  }
  /// By every pixel or so of a line.
  void take_line(Point a, Point b);
  /// Area in common with what stands there, weighted.
  double overlap(Box box) const;

 private:
  std::vector<std::pair<Box, double>> taken_;
};

class Plot {
 public:
  /// The frame's corners in the picture; draws grid, axes, their numbers and titles.
  Plot(Svg& svg, Point top_left, Point bottom_right, Axis x, Axis y);

  Point at(double x, double y) const;
  Point top_left() const { return a_; }
  Point bottom_right() const { return b_; }
  bool holds(Point p) const { return p.x >= a_.x - 0.5 && p.x <= b_.x + 0.5 && p.y >= a_.y - 0.5 && p.y <= b_.y + 0.5; }

  /// Points outside the frame are left out.
  void path(const std::vector<Point>& values, Stroke stroke);
  void mark(Mark mark, double x, double y, double size, std::string_view colour, bool hollow = false);
  /// Beside a place, on the side that is freest, the first of equals in a fixed order; from further off a thin line
  /// leads to it. Within the frame.
  void label(Point at, double distance, std::string_view text, Letters letters = {});
  Room& room() { return room_; }

 private:
  Svg& svg_;
  Point a_, b_;
  Axis x_, y_;
  Room room_;
};

/// Title and the line below it, over a picture; where and what was measured at its foot.
void heading(Svg& svg, std::string_view title, std::string_view below);
void footing(Svg& svg, std::string_view text);

}  // namespace cusp::bench
