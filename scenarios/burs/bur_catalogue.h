/// The catalogue of burs: burs.json, built in. A figure that nobody verified is marked; the interface shows the mark with
/// the figure.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/result.h"
#include "engine/tool/bur.h"
#include "scenarios/modules.h"

namespace cusp::scenarios {

struct CatalogueBur {
  Bur bur;               // its name is the number
  std::string also;        // a second catalogue number; mostly none
  std::string shape;       // key: "straight_fissure"
  std::string iso_shape;   // ISO 6360, three digits
  double head_length_mm = 0.0;
  std::string material;    // "carbide", "diamond"
  std::string grit, ring;  // ISO 6360 code and colour; of diamonds
  std::vector<std::string> use;  // keys: "walls"
  std::map<std::string, std::string, std::less<>> sources;

  /// Of a figure of burs.json ("diameter_mm"): false for general knowledge, "[M]".
  bool verified(std::string_view figure) const noexcept;
};

enum class BurTableError : std::uint8_t {
  bad_json,
  missing,         // a key is not there, or is of another type
  unknown_key,
  bad_value,       // out of its range, or figures that make no convex head
  unknown_value,   // a shape, material or use that the catalogue does not know
  unknown_source,
  twice,           // a number
};

/// `where`: JSON pointer.
[[nodiscard]] Result<std::vector<CatalogueBur>, Failure<BurTableError>> read_bur_table(std::string_view text);

/// The program's own, in the file's order. The first call reads it: not on the haptic thread.
const std::vector<CatalogueBur>& bur_catalogue();

/// By number, its other one too; nullptr when there is none.
const CatalogueBur* catalogue_bur(std::string_view number);

/// The catalogue's bur with that head and diameter, whatever its neck; nullptr without one.
const CatalogueBur* catalogue_bur_like(const Bur& bur);

/// False if its name is a number of the catalogue and its head or diameter is not that number's.
bool fits_its_number(const Bur& bur);

/// Key of its shape: the catalogue's for a head from there, "round" for a ball of any size, else "other".
std::string_view shape_of(const Bur& bur);

/// Every key of a shape and of a use: ui has a text for each.
const std::vector<std::string_view>& bur_shapes();
const std::vector<std::string_view>& bur_uses();

}  // namespace cusp::scenarios
