#include "tests/bench/svg.h"

#include <cmath>
#include <cstdio>

namespace cusp::bench {

namespace {

std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

std::string attribute(std::string_view name, std::string_view value) {
  return ' ' + std::string(name) + "=\"" + std::string(value) + '"';
}
std::string attribute(std::string_view name, double value) { return attribute(name, pixels(value)); }

std::string stroke_of(Stroke s) {
  std::string out = attribute("stroke", s.colour) + attribute("stroke-width", s.width);
  if (!s.dash.empty()) out += attribute("stroke-dasharray", s.dash);
  return out;
}

std::string corners(const std::vector<Point>& points) {
  std::string out;
  for (const Point& p : points) out += (out.empty() ? "" : " ") + pixels(p.x) + ',' + pixels(p.y);
  return out;
}

}  // namespace

std::string pixels(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f", value);
  std::string out = text;
  while (out.back() == '0') out.pop_back();
  if (out.back() == '.') out.pop_back();
  return out == "-0" ? "0" : out;
}

double text_width(std::string_view text, double size) {
  double em = 0.0;
  for (const char c : text) {
    if ((static_cast<unsigned char>(c) & 0xc0) == 0x80) continue;  // inside a letter of UTF-8
    em += c == ' ' || c == '.' || c == ',' || c == 'i' || c == 'l' ? 0.3 : c >= 'A' && c <= 'Z' ? 0.66 : 0.56;
  }
  return em * size;
}

Svg::Svg(double width, double height, std::string_view title, std::string_view about)
    : width_(width), height_(height), title_(title), about_(about) {}

void Svg::rect(Point a, Point b, std::string_view fill, Stroke edge) {
  body_ += "<rect" + attribute("x", a.x) + attribute("y", a.y) + attribute("width", b.x - a.x) +
           attribute("height", b.y - a.y) + attribute("fill", fill) + (edge.width > 0.0 ? stroke_of(edge) : "") +
           "/>\n";
}

void Svg::line(Point a, Point b, Stroke stroke) {
  body_ += "<line" + attribute("x1", a.x) + attribute("y1", a.y) + attribute("x2", b.x) + attribute("y2", b.y) +
           stroke_of(stroke) + "/>\n";
}

void Svg::path(const std::vector<Point>& points, Stroke stroke) {
  body_ += "<polyline" + attribute("points", corners(points)) + attribute("fill", "none") + stroke_of(stroke) +
           attribute("stroke-linejoin", "round") + "/>\n";
}

void Svg::mark(Mark mark, Point at, double size, std::string_view colour, bool hollow) {
  const std::string look = hollow ? attribute("fill", ink::kPaper) + stroke_of({colour, 1.6, ""})
                                  : attribute("fill", colour) + stroke_of({ink::kPaper, 1.0, ""});
  const double r = 0.5 * size;
  const auto polygon = [&](const std::vector<Point>& p) {
    body_ += "<polygon" + attribute("points", corners(p)) + look + "/>\n";
  };
  switch (mark) {
    case Mark::circle:
      body_ += "<circle" + attribute("cx", at.x) + attribute("cy", at.y) + attribute("r", r) + look + "/>\n";
      break;
    case Mark::square: {
      const double a = 0.89 * r;
      polygon({{at.x - a, at.y - a}, {at.x + a, at.y - a}, {at.x + a, at.y + a}, {at.x - a, at.y + a}});
      break;
    }
    case Mark::diamond: {
      const double a = 1.25 * r;
      polygon({{at.x, at.y - a}, {at.x + a, at.y}, {at.x, at.y + a}, {at.x - a, at.y}});
      break;
    }
    case Mark::triangle_up: {
      const double a = 1.15 * r;
      polygon({{at.x, at.y - a}, {at.x + a, at.y + 0.8 * a}, {at.x - a, at.y + 0.8 * a}});
      break;
    }
    case Mark::triangle_down: {
      const double a = 1.15 * r;
      polygon({{at.x, at.y + a}, {at.x + a, at.y - 0.8 * a}, {at.x - a, at.y - 0.8 * a}});
      break;
    }
    case Mark::hexagon: {
      std::vector<Point> p;
      for (int i = 0; i < 6; ++i) {
        const double turn = 1.0471975511965976 * i;
        p.push_back({at.x + 1.1 * r * std::cos(turn), at.y + 1.1 * r * std::sin(turn)});
      }
      polygon(p);
      break;
    }
    case Mark::cross:
      line({at.x - r, at.y - r}, {at.x + r, at.y + r}, {colour, 2.0, ""});
      line({at.x - r, at.y + r}, {at.x + r, at.y - r}, {colour, 2.0, ""});
      break;
    case Mark::plus:
      line({at.x - 1.2 * r, at.y}, {at.x + 1.2 * r, at.y}, {colour, 2.0, ""});
      line({at.x, at.y - 1.2 * r}, {at.x, at.y + 1.2 * r}, {colour, 2.0, ""});
      break;
  }
}

void Svg::text(Point at, std::string_view text, Letters letters) {
  body_ += "<text" + attribute("x", at.x) + attribute("y", at.y) + attribute("font-size", letters.size) +
           attribute("fill", letters.colour);
  if (letters.anchor != Anchor::start)
    body_ += attribute("text-anchor", letters.anchor == Anchor::middle ? "middle" : "end");
  // A rim of paper keeps letters legible over grid and lines.
  if (!letters.plain)
    body_ += attribute("stroke", ink::kPaper) + attribute("stroke-width", 3.0) + attribute("paint-order", "stroke") +
             attribute("stroke-linejoin", "round");
  if (letters.bold) body_ += attribute("font-weight", "600");
  if (letters.upwards) body_ += attribute("transform", "rotate(-90 " + pixels(at.x) + ' ' + pixels(at.y) + ')');
  body_ += '>' + escaped(text) + "</text>\n";
}

std::string Svg::str() const {
  const std::string w = pixels(width_), h = pixels(height_);
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + w + "\" height=\"" + h + "\" viewBox=\"0 0 " + w + ' ' +
         h +
         "\" role=\"img\" font-family=\"system-ui, -apple-system, 'Segoe UI', Roboto, 'Noto Sans', Helvetica, Arial, "
         "sans-serif\">\n<title>" +
         escaped(title_) + "</title>\n<desc>" + escaped(about_) + "</desc>\n<rect width=\"" + w + "\" height=\"" + h +
         "\" fill=\"" + std::string(ink::kPaper) + "\"/>\n" + body_ + "</svg>\n";
}

}  // namespace cusp::bench
