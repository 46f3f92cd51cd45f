#include "ui/render/scenery_section.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace cusp::ui {
namespace {

struct Segment {
  glm::dvec2 a, b;  // pixels, y downwards
  Tissue skin;
};

class Cut {
 public:
  Cut(const SectionSettings& settings) : s_(settings), normal_(settings.plane.normal()) {}

  bool meets(const Box& box) const {
    double low = 1e9, high = -1e9;
    for (int i = 0; i < 8; ++i) {
      const Vec3 corner(i & 1 ? box.high.x : box.low.x, i & 2 ? box.high.y : box.low.y, i & 4 ? box.high.z : box.low.z);
      const double d = glm::dot(corner - s_.plane.centre_mm, normal_);
      low = std::min(low, d);
      high = std::max(high, d);
    }
    return low <= 0.0 && high >= 0.0;
  }

  std::vector<Segment> segments(const SceneryMesh& mesh) const {
    std::vector<double> height(mesh.points_mm.size());
    for (std::size_t i = 0; i < height.size(); ++i) {
      height[i] = glm::dot(Vec3(mesh.points_mm[i]) - s_.plane.centre_mm, normal_);
      if (height[i] == 0.0) height[i] = 1e-9;  // no corner lies on the plane: every cut is a segment
    }
    std::vector<Segment> out;
    for (std::size_t t = 0; t + 2 < mesh.triangles.size(); t += 3) {
      std::array<glm::dvec2, 2> ends{};
      std::size_t found = 0;
      Tissue skin = Tissue::empty;
      for (std::size_t k = 0; k < 3 && found < 2; ++k) {
        const std::uint32_t i = mesh.triangles[t + k], j = mesh.triangles[t + (k + 1) % 3];
        if ((height[i] < 0.0) == (height[j] < 0.0)) continue;
        const double share = height[i] / (height[i] - height[j]);
        ends[found++] = pixel(Vec3(mesh.points_mm[i]) + share * Vec3(mesh.points_mm[j] - mesh.points_mm[i]));
        skin = mesh.tissue[share < 0.5 ? i : j];
      }
      if (found == 2) out.push_back({ends[0], ends[1], skin});
    }
    return out;
  }

 private:
  glm::dvec2 pixel(Vec3 mm) const {
    const Vec3 from = mm - s_.plane.centre_mm;
    return {(s_.width - 1) / 2.0 + glm::dot(from, s_.plane.right) / s_.mm_per_px,
            (s_.height - 1) / 2.0 - glm::dot(from, s_.plane.up) / s_.mm_per_px};
  }
  const SectionSettings& s_;
  Vec3 normal_;
};

double distance(glm::dvec2 p, const Segment& s) {
  const glm::dvec2 along = s.b - s.a, from = p - s.a;
  const double length = glm::dot(along, along);
  const double t = length > 0.0 ? std::clamp(glm::dot(from, along) / length, 0.0, 1.0) : 0.0;
  return glm::length(from - t * along);
}

}  // namespace

std::vector<SceneryPixel> scenery_in_section(const SceneryLook& scenery, const SectionSettings& settings) {
  const Cut cut(settings);
  const int width = std::max(settings.width, 1), height = std::max(settings.height, 1);
  const auto at = [&](int x, int y) { return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x); };
  std::vector<SceneryPixel> out;
  const double skin_px = kSkinMm / settings.mm_per_px, reach = std::max(skin_px, 2.0);
  struct Near {
    double px = 1e9;
    Tissue skin = Tissue::empty;
  };
  for (std::size_t m = 0; m < scenery.meshes().size(); ++m) {
    const SceneryMesh& mesh = scenery.meshes()[m];
    if (!cut.meets(scenery.boxes()[m])) continue;
    const std::vector<Segment> segments = cut.segments(mesh);
    std::vector<std::vector<double>> crossings(static_cast<std::size_t>(height));  // of each row with the outline
    std::vector<Near> near(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    bool any = false;
    for (const Segment& s : segments) {
      const int first = std::max(0, static_cast<int>(std::ceil(std::min(s.a.y, s.b.y))));
      for (int y = first; y < height && y < std::max(s.a.y, s.b.y); ++y) {
        crossings[static_cast<std::size_t>(y)].push_back(s.a.x + (y - s.a.y) / (s.b.y - s.a.y) * (s.b.x - s.a.x));
        any = true;
      }
      const int x0 = std::max(0, static_cast<int>(std::min(s.a.x, s.b.x) - reach));
      const int x1 = std::min(width - 1, static_cast<int>(std::max(s.a.x, s.b.x) + reach));
      const int y1 = std::min(height - 1, static_cast<int>(std::max(s.a.y, s.b.y) + reach));
      for (int y = std::max(0, static_cast<int>(std::min(s.a.y, s.b.y) - reach)); y <= y1; ++y)
        for (int x = x0; x <= x1; ++x) {
          const double d = distance({x, y}, s);
          if (d < near[at(x, y)].px) near[at(x, y)] = {d, s.skin};
        }
    }
    if (!any) continue;
    out.resize(near.size());
    // A body's line ends where it goes into one that came before it: gums are whole round the teeth that stand in them.
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        SceneryPixel& pixel = out[at(x, y)];
        if (pixel.tissue == Tissue::empty)
          pixel.edge = std::max(pixel.edge, static_cast<float>(std::clamp(1.1 - near[at(x, y)].px, 0.0, 1.0)));
      }
    for (int y = 0; y < height; ++y) {
      std::vector<double>& row = crossings[static_cast<std::size_t>(y)];
      std::ranges::sort(row);
      for (std::size_t k = 0; k + 1 < row.size(); k += 2) {
        const int last = std::min(width - 1, static_cast<int>(std::floor(row[k + 1])));
        for (int x = std::max(0, static_cast<int>(std::ceil(row[k]))); x <= last; ++x) {
          const Near& n = near[at(x, y)];
          if (out[at(x, y)].tissue != Tissue::empty) continue;  // the first body counts: teeth come before gums
          out[at(x, y)].tissue = n.px < skin_px ? n.skin : mesh.within;
        }
      }
    }
  }
  return out;
}

}  // namespace cusp::ui
