#include "tests/bench/plot.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace cusp::bench {

double Axis::place(double value) const {
  if (log) return std::log(value / low) / std::log(high / low);
  return (value - low) / (high - low);
}

std::string short_number(double value) {
  const char* unit = "";
  double shown = value;
  if (std::fabs(value) >= 1e6) {
    shown = value / 1e6;
    unit = " M";
  } else if (std::fabs(value) >= 1e3) {
    shown = value / 1e3;
    unit = " k";
  }
  char text[32];
  std::snprintf(text, sizeof text, "%.*f", std::fabs(shown) >= 100.0 || shown == 0.0 ? 0 : 2, shown);
  if (std::fabs(shown) < 1.0 && shown != 0.0)
    std::snprintf(text, sizeof text, "%.2g", shown);
  else if (std::fabs(shown) >= 10.0 && std::fabs(shown) < 100.0)
    std::snprintf(text, sizeof text, "%.1f", shown);
  std::string out = text;
  if (out.find('.') != std::string::npos && out.find('e') == std::string::npos) {
    while (out.back() == '0') out.pop_back();
    if (out.back() == '.') out.pop_back();
  }
  return out + unit;
}

Axis decades(std::string title, const std::vector<double>& values) {
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  int low = static_cast<int>(std::floor(std::log10(*least) + 1e-9));
  int high = static_cast<int>(std::ceil(std::log10(*most) - 1e-9));
  if (high == low) ++high;
  Axis out;
  out.log = true;
  out.title = std::move(title);
  out.low = std::pow(10.0, low);
  out.high = std::pow(10.0, high);
  for (int d = low; d <= high; ++d) {
    char text[32];
    std::snprintf(text, sizeof text, "%.*f", std::max(0, -d), std::pow(10.0, d));
    out.ticks.emplace_back(std::pow(10.0, d), d >= 3 ? short_number(std::pow(10.0, d)) : text);
  }
  return out;
}

Axis even(std::string title, double low, double high, double every) {
  Axis out;
  out.low = low;
  out.high = high;
  out.title = std::move(title);
  const int first = static_cast<int>(std::ceil(low / every - 1e-9));
  const int last = static_cast<int>(std::floor(high / every + 1e-9));
  for (int i = first; i <= last; ++i) out.ticks.emplace_back(i * every, i == 0 ? "0" : short_number(i * every));
  return out;
}

void Room::take_line(Point a, Point b) {
  const int steps = std::max(1, static_cast<int>(std::hypot(b.x - a.x, b.y - a.y) / 4.0));
  for (int i = 0; i <= steps; ++i) {
    const double t = static_cast<double>(i) / steps;
    take_mark({a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t}, 4.0, 4.0);
  }
}

double Room::overlap(Box box) const {
  double sum = 0.0;
  for (const auto& [t, weight] : taken_) {
    const double w = std::min(t.b.x, box.b.x) - std::max(t.a.x, box.a.x);
    const double h = std::min(t.b.y, box.b.y) - std::max(t.a.y, box.a.y);
    if (w > 0.0 && h > 0.0) sum += weight * w * h;
  }
  return sum;
}

Plot::Plot(Svg& svg, Point top_left, Point bottom_right, Axis x, Axis y)
    : svg_(svg), a_(top_left), b_(bottom_right), x_(std::move(x)), y_(std::move(y)) {
  const Letters numbers{.size = 12.0, .colour = ink::kQuiet, .anchor = Anchor::middle};
  const auto fine = [](const Axis& axis, auto&& draw) {
    if (!axis.log) return;
    for (double decade = axis.low; decade < axis.high * 0.999; decade *= 10.0)
      for (int i = 2; i < 10; ++i)
        if (const double p = axis.place(decade * i); p < 1.0) draw(p);
  };
  const double w = b_.x - a_.x, h = b_.y - a_.y;
  fine(x_, [&](double p) { svg_.line({a_.x + p * w, b_.y}, {a_.x + p * w, b_.y - 4.0}, {ink::kQuiet, 0.6, ""}); });
  fine(y_, [&](double p) { svg_.line({a_.x, b_.y - p * h}, {a_.x + 4.0, b_.y - p * h}, {ink::kQuiet, 0.6, ""}); });
  for (const auto& [value, text] : x_.ticks) {
    const double px = at(value, y_.low).x;
    svg_.line({px, a_.y}, {px, b_.y}, {ink::kGrid, 1.0, ""});
    svg_.text({px, b_.y + 17.0}, text, numbers);
  }
  for (const auto& [value, text] : y_.ticks) {
    const double py = at(x_.low, value).y;
    svg_.line({a_.x, py}, {b_.x, py}, {ink::kGrid, 1.0, ""});
    svg_.text({a_.x - 7.0, py + 4.2}, text, {.size = 12.0, .colour = ink::kQuiet, .anchor = Anchor::end});
  }
  svg_.line({a_.x, a_.y}, {a_.x, b_.y}, {ink::kQuiet, 1.0, ""});
  svg_.line({a_.x, b_.y}, {b_.x, b_.y}, {ink::kQuiet, 1.0, ""});
  svg_.text({0.5 * (a_.x + b_.x), b_.y + 37.0}, x_.title, {.size = 13.0, .anchor = Anchor::middle});
  if (!y_.title.empty())
    svg_.text({a_.x - 48.0, 0.5 * (a_.y + b_.y)}, y_.title, {.size = 13.0, .anchor = Anchor::middle, .upwards = true});
}

Point Plot::at(double x, double y) const {
  return {a_.x + x_.place(x) * (b_.x - a_.x), b_.y - y_.place(y) * (b_.y - a_.y)};
}

void Plot::path(const std::vector<Point>& values, Stroke stroke) {
  std::vector<Point> points;
  for (const Point& v : values) {
    const Point p = at(v.x, v.y);
    if (!holds(p)) continue;
    if (!points.empty()) room_.take_line(points.back(), p);
    points.push_back(p);
  }
  if (points.size() > 1) svg_.path(points, stroke);
}

void Plot::mark(Mark mark, double x, double y, double size, std::string_view colour, bool hollow) {
  const Point p = at(x, y);
  svg_.mark(mark, p, size, colour, hollow);
  room_.take_mark(p, size * 1.1);
}

void Plot::label(Point at, double distance, std::string_view text, Letters letters) {
  const double width = text_width(text, letters.size) * (letters.bold ? 1.06 : 1.0);
  const double rise = 0.74 * letters.size, fall = 0.22 * letters.size;
  struct Side {
    double x, y;  // direction
    Anchor anchor;
  };
  constexpr Side kSides[] = {
      {1, 0, Anchor::start},      {-1, 0, Anchor::end},      {0, -1, Anchor::middle},   {0, 1, Anchor::middle},
      {0.8, -0.9, Anchor::start}, {0.8, 0.9, Anchor::start}, {-0.8, -0.9, Anchor::end}, {-0.8, 0.9, Anchor::end},
      {1, -0.5, Anchor::start},   {1, 0.5, Anchor::start},   {-1, -0.5, Anchor::end},   {-1, 0.5, Anchor::end},
      {-0.2, -1, Anchor::start},  {-0.2, 1, Anchor::start},  {0.2, -1, Anchor::end},    {0.2, 1, Anchor::end}};
  double best = 1e300;
  Point place;
  Anchor anchor = Anchor::start;
  Room::Box box;
  double off = 1.0;
  for (const double far : {1.0, 1.6, 2.4, 3.4}) {
    for (const Side& side : kSides) {
      const Point base{at.x + side.x * distance * far,
                       at.y + side.y * (distance * far + 0.25 * letters.size) + 0.36 * letters.size};
      const double left = side.anchor == Anchor::start ? base.x
                          : side.anchor == Anchor::end ? base.x - width
                                                       : base.x - 0.5 * width;
      const Room::Box b{{left - 2.0, base.y - rise - 1.0}, {left + width + 2.0, base.y + fall + 1.0}};
      double cost = room_.overlap(b) + 6.0 * (far - 1.0);
      const double beyond = std::max(0.0, a_.x - b.a.x) + std::max(0.0, b.b.x - b_.x) + std::max(0.0, a_.y - b.a.y) +
                            std::max(0.0, b.b.y - b_.y);
      cost += beyond * 200.0;
      if (far > 1.0) {  // its line should cross no other letters
        const Point end{std::clamp(at.x, b.a.x, b.b.x), std::clamp(at.y, b.a.y, b.b.y)};
        for (int i = 2; i < 8; ++i) {
          const Point p{at.x + (end.x - at.x) * i / 8.0, at.y + (end.y - at.y) * i / 8.0};
          cost += room_.overlap({{p.x - 1.5, p.y - 1.5}, {p.x + 1.5, p.y + 1.5}});
        }
      }
      if (cost < best - 1e-6) {
        best = cost;
        place = base;
        anchor = side.anchor;
        box = b;
        off = far;
      }
    }
  }
  if (off > 1.0) {
    const Point end{std::clamp(at.x, box.a.x, box.b.x), std::clamp(at.y, box.a.y, box.b.y)};
    const double whole = std::hypot(end.x - at.x, end.y - at.y);
    const double skip = std::min(distance - 3.0, whole) / std::max(whole, 1e-9);  // the mark itself
    svg_.line({at.x + (end.x - at.x) * skip, at.y + (end.y - at.y) * skip}, end, {ink::kQuiet, 0.8, ""});
    room_.take_line(at, end);
  }
  letters.anchor = anchor;
  svg_.text(place, text, letters);
  room_.take(box);
}

void heading(Svg& svg, std::string_view title, std::string_view below) {
  svg.text({20.0, 30.0}, title, {.size = 18.0, .bold = true});
  svg.text({20.0, 50.0}, below, {.size = 13.0, .colour = ink::kQuiet});
}

void footing(Svg& svg, std::string_view text) {
  svg.text({20.0, svg.height() - 12.0}, text, {.size = 11.0, .colour = ink::kQuiet});
}

}  // namespace cusp::bench
