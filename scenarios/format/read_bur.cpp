// What one drills with: a bur of the catalogue, or one by its figures.

#include <cmath>

#include "scenarios/burs/bur_catalogue.h"
#include "scenarios/format/read_sections.h"

namespace cusp::scenarios::format_reader {
namespace {

/// Pieces of an outline from the tip on: two ends, and for an arc its centre and radius.
Profile read_head(const Value& value, double radius_mm) {
  Profile out;
  bool sound = true;
  value.list(1, Profile::kMostPieces, [&](const Value& piece) {
    std::vector<double> figures;
    piece.list(4, 7, [&](const Value& v) { figures.push_back(v.number({-100, 100})); });
    if (!piece.node().is_array()) return;
    sound = sound && (figures.size() == 4 || figures.size() == 7);
    if (!sound) return;
    OutlinePiece one{{figures[0], figures[1]}, {figures[2], figures[3]}, {}, 0.0};
    if (figures.size() == 7) {
      one.centre = {figures[4], figures[5]};
      one.radius = figures[6];
    }
    sound = (figures.size() == 4 || one.radius > 0.0) && out.add(one);
  });
  // The pivot lies one radius above the tip, and the radius is the widest one's.
  constexpr double kSame = 1e-6;
  sound = sound && out.closed() && std::abs(out.widest() - radius_mm) <= kSame && std::abs(out.low() + radius_mm) <= kSame;
  if (!sound) value.refuse(FormatError::out_of_range, "convex outline");
  return out;
}

}  // namespace

Bur read_bur(const Value& value) {
  Object object(value.node(), value.where(), value.problems());
  Bur out;
  if (object.has("catalogue")) {
    const Value number = object.need("catalogue");
    const std::string text = number.text(1, 64);
    object.nothing_else();
    if (const CatalogueBur* one = catalogue_bur(text)) return one->bur;
    if (number.node().is_string()) number.refuse(FormatError::unknown_bur, text);
    return out;
  }
  out.name = object.need("name").text(1, 64);
  out.radius_mm = object.need("radius_mm").number({0, 10, true});
  out.neck_radius_mm = object.need("neck_radius_mm").number({0, 10, true});
  out.neck_length_mm = object.need("neck_length_mm").number({0, 50});
  out.shank_radius_mm = object.need("shank_radius_mm").number({0, 10, true});
  out.shank_length_mm = object.need("shank_length_mm").number({0, 100});
  object.maybe("head", [&](const Value& v) { out.head = read_head(v, out.radius_mm); });
  object.nothing_else();
  return out;
}

}  // namespace cusp::scenarios::format_reader
