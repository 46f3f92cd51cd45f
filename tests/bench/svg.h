/// Pictures as text: the few marks that a chart needs, written the same for the same calls. Pixels, y downwards.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace cusp::bench {

/// Okabe and Ito's palette, told apart under every common colour blindness, and the greys of axes and text.
namespace ink {
inline constexpr std::string_view kBlue = "#0072B2", kSky = "#56B4E9", kGreen = "#009E73", kOrange = "#E69F00",
                                  kVermilion = "#D55E00", kPurple = "#CC79A7", kText = "#1B1F24", kQuiet = "#57606A",
                                  kGrid = "#E3E7EB", kPaper = "#FFFFFF";
}  // namespace ink

enum class Mark { circle, square, diamond, triangle_up, triangle_down, hexagon, cross, plus };
enum class Anchor { start, middle, end };

struct Point {
  double x = 0.0, y = 0.0;
};

struct Stroke {
  std::string_view colour = ink::kText;
  double width = 1.0;
  std::string_view dash;  // as SVG has it, empty for a whole line
};

struct Letters {
  double size = 12.0;
  std::string_view colour = ink::kText;
  Anchor anchor = Anchor::start;
  bool bold = false;
  bool plain = false;    // without the rim of paper, on a coloured ground
  bool upwards = false;  // turned by 90 degrees, reading upwards
};

/// About how wide a text is in the fonts that the pictures ask for.
double text_width(std::string_view text, double size);
/// With the fewest digits that tell it to a hundredth of a pixel.
std::string pixels(double value);

class Svg {
 public:
  /// title and about: what a reader without eyes gets.
  Svg(double width, double height, std::string_view title, std::string_view about);

  double width() const { return width_; }
  double height() const { return height_; }

  void rect(Point a, Point b, std::string_view fill, Stroke edge = {.colour = "", .width = 0.0, .dash = ""});
  void line(Point a, Point b, Stroke stroke);
  void path(const std::vector<Point>& points, Stroke stroke);
  void mark(Mark mark, Point at, double size, std::string_view colour, bool hollow = false);
  void text(Point at, std::string_view text, Letters letters = {});

  /// The whole picture, on a white page of its own.
  std::string str() const;

 private:
  double width_, height_;
  std::string title_, about_, body_;
};

}  // namespace cusp::bench
