#include "scenarios/burs/bur_catalogue.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "engine/tool/heads.h"
#include "scenarios/modules.h"

namespace cusp::scenarios {

namespace embedded {
extern const std::string_view burs;
}

namespace {

using Json = nlohmann::json;
using Error = BurTableError;

constexpr std::string_view kUnverified = "M", kOther = "other";
/// Two diameters nearer than this are one, mm: an edited one is a double of the number that was typed.
constexpr double kSameMm = 1e-6;

bool is_alike(const Bur& a, const Bur& b) { return a.head == b.head && std::abs(a.radius_mm - b.radius_mm) < kSameMm; }

/// Walks the file; keeps the first failure.
class TableReader {
 public:
  explicit TableReader(const Json& document) : document_(document) {}

  Result<std::vector<CatalogueBur>, Failure<Error>> run() {
    if (!document_.is_object()) return fail(Error::bad_json, std::string());
    for (const char* key : {"sources", "shank"})
      if (!document_.contains(key) || !document_[key].is_object()) wrong(Error::missing, std::string("/") + key);
    if (!document_.contains("burs") || !document_["burs"].is_array()) wrong(Error::missing, "/burs");
    only(document_, "", {"about", "sources", "shank", "burs"});
    if (failed_) return std::unexpected(*failed_);
    const Json& shank = document_["shank"];
    only(shank, "/shank", {"radius_mm", "length_mm", "sources"});
    shank_radius_ = number(shank, "radius_mm", "/shank", 10);
    shank_length_ = number(shank, "length_mm", "/shank", 100);
    sources(shank, "/shank");
    std::vector<CatalogueBur> out;
    std::size_t i = 0;
    for (const Json& one : document_["burs"]) {
      const std::string where = "/burs/" + std::to_string(i++);
      if (!one.is_object()) {
        wrong(Error::missing, where);
        continue;
      }
      out.push_back(bur(one, where));
    }
    if (failed_) return std::unexpected(*failed_);
    return out;
  }

 private:
  void wrong(Error code, std::string where) {
    if (!failed_) failed_ = Failure<Error>{code, std::move(where), {}};
  }
  void only(const Json& owner, const std::string& where, std::initializer_list<std::string_view> keys) {
    for (auto it = owner.begin(); it != owner.end(); ++it)
      if (std::ranges::find(keys, it.key()) == keys.end()) wrong(Error::unknown_key, where + "/" + it.key());
  }
  double number(const Json& owner, const char* key, const std::string& where, double most) {
    const std::string at = where + "/" + key;
    if (!owner.contains(key) || !owner[key].is_number()) {
      wrong(Error::missing, at);
      return 1.0;
    }
    const double value = owner[key].get<double>();
    if (!(value > 0.0 && value <= most)) wrong(Error::bad_value, at);
    return value;
  }
  std::string text(const Json& owner, const char* key, const std::string& where) {
    if (owner.contains(key) && owner[key].is_string() && !owner[key].get_ref<const std::string&>().empty())
      return owner[key].get<std::string>();
    wrong(Error::missing, where + "/" + key);
    return {};
  }
  std::string one_of(const Json& owner, const char* key, const std::string& where,
                   const std::vector<std::string_view>& known) {
    std::string out = text(owner, key, where);
    if (std::ranges::find(known, out) == known.end()) wrong(Error::unknown_value, where + "/" + key);
    return out;
  }
  std::map<std::string, std::string, std::less<>> sources(const Json& owner, const std::string& where) {
    std::map<std::string, std::string, std::less<>> out;
    const std::string at = where + "/sources";
    if (!owner.contains("sources") || !owner["sources"].is_object() || !owner["sources"].contains(kOther)) {
      wrong(Error::missing, at);
      return out;
    }
    for (auto it = owner["sources"].begin(); it != owner["sources"].end(); ++it) {
      if (!it.value().is_string() || !document_["sources"].contains(it.value().get_ref<const std::string&>())) {
        wrong(Error::unknown_source, at + "/" + it.key());
        continue;
      }
      if (it.key() != kOther && !owner.contains(it.key())) wrong(Error::unknown_key, at + "/" + it.key());
      out[it.key()] = it.value().get<std::string>();
    }
    return out;
  }

  /// nullopt for figures that make no head; a ball has none.
  std::optional<Profile> outline(const Json& owner, const std::string& where, double radius, double length) {
    if (!owner.contains("outline") || !owner["outline"].is_object()) {
      wrong(Error::missing, where + "/outline");
      return std::nullopt;
    }
    const Json& o = owner["outline"];
    const std::string at = where + "/outline";
    const std::string kind = text(o, "kind", at);
    const auto figure = [&](const char* key) { return number(o, key, at, 10); };
    std::optional<Profile> out;
    if (kind == "ball") {
      only(o, at, {"kind"});
      return Profile();
    }
    if (kind == "flat" || kind == "round_end") {
      only(o, at, {"kind", "tip_radius_mm", "top_radius_mm"});
      const double tip = figure("tip_radius_mm"), top = figure("top_radius_mm");
      out = kind == "flat" ? flat_head(tip, top, length) : round_end_head(tip, top, length);
    } else if (kind == "pear") {
      only(o, at, {"kind", "corner_radius_mm", "top_radius_mm"});
      out = pear_head(radius, figure("corner_radius_mm"), figure("top_radius_mm"), length);
    } else if (kind == "oval") {
      only(o, at, {"kind", "tip_radius_mm", "widest_at_mm", "top_radius_mm"});
      out = oval_head(radius, figure("tip_radius_mm"), figure("widest_at_mm"), figure("top_radius_mm"), length);
    } else {
      wrong(Error::unknown_value, at + "/kind");
      return std::nullopt;
    }
    const double off = out ? out->widest() - radius : 1.0;
    if (!(off < 1e-9 && off > -1e-9)) wrong(Error::bad_value, at);
    return out;
  }

  CatalogueBur bur(const Json& one, const std::string& where) {
    CatalogueBur out;
    only(one, where, {"number", "also", "shape", "iso_shape", "diameter_mm", "head_length_mm", "outline", "neck_radius_mm",
                      "neck_length_mm", "material", "grit", "ring", "use", "sources"});
    out.bur.name = text(one, "number", where);
    if (one.contains("also")) out.also = text(one, "also", where);
    for (const std::string& number : {out.bur.name, out.also})
      if (!number.empty() && !seen_.insert(number).second) wrong(Error::twice, where + "/number");
    out.shape = one_of(one, "shape", where, bur_shapes());
    out.iso_shape = text(one, "iso_shape", where);
    out.bur.radius_mm = 0.5 * number(one, "diameter_mm", where, 10);
    out.head_length_mm = number(one, "head_length_mm", where, 20);
    if (const auto head = outline(one, where, out.bur.radius_mm, out.head_length_mm)) out.bur.head = *head;
    out.bur.neck_radius_mm = number(one, "neck_radius_mm", where, 10);
    out.bur.neck_length_mm = number(one, "neck_length_mm", where, 50);
    out.bur.shank_radius_mm = shank_radius_;
    out.bur.shank_length_mm = shank_length_;
    out.material = one_of(one, "material", where, {"carbide", "diamond"});
    if (one.contains("grit")) {
      out.grit = text(one, "grit", where);
      out.ring = one_of(one, "ring", where, {"white", "yellow", "red", "blue", "green", "black"});
    }
    if (one.contains("use") && one["use"].is_array()) {
      for (const Json& use : one["use"]) {
        const bool known = use.is_string() && std::ranges::find(bur_uses(), use.get_ref<const std::string&>()) != bur_uses().end();
        if (known) {
          out.use.push_back(use.get<std::string>());
        } else {
          wrong(Error::unknown_value, where + "/use");
        }
      }
    } else {
      wrong(Error::missing, where + "/use");
    }
    out.sources = sources(one, where);
    return out;
  }

  const Json& document_;
  double shank_radius_ = 0.0, shank_length_ = 0.0;
  std::set<std::string> seen_;
  std::optional<Failure<Error>> failed_;
};

}  // namespace

bool CatalogueBur::verified(std::string_view figure) const noexcept {
  auto it = sources.find(figure);
  if (it == sources.end()) it = sources.find(kOther);
  return it != sources.end() && it->second != kUnverified;
}

Result<std::vector<CatalogueBur>, Failure<BurTableError>> read_bur_table(std::string_view text) {
  const Json document = Json::parse(text, nullptr, false);
  if (document.is_discarded()) return fail(Error::bad_json, std::string());
  return TableReader(document).run();
}

const std::vector<CatalogueBur>& bur_catalogue() {
  static const std::vector<CatalogueBur> table = [] {
    auto read = read_bur_table(embedded::burs);
    assert(read);
    return std::move(*read);
  }();
  return table;
}

const CatalogueBur* catalogue_bur(std::string_view number) {
  for (const CatalogueBur& one : bur_catalogue())
    if (one.bur.name == number || (!one.also.empty() && one.also == number)) return &one;
  return nullptr;
}

const CatalogueBur* catalogue_bur_like(const Bur& bur) {
  for (const CatalogueBur& one : bur_catalogue())
    if (is_alike(one.bur, bur)) return &one;
  return nullptr;
}

bool fits_its_number(const Bur& bur) {
  const CatalogueBur* one = catalogue_bur(bur.name);
  return one == nullptr || is_alike(one->bur, bur);
}

std::string_view shape_of(const Bur& bur) {
  if (bur.head.ball()) return "round";
  const CatalogueBur* one = catalogue_bur(bur.name);
  return one != nullptr && one->bur.head == bur.head ? std::string_view(one->shape) : std::string_view("other");
}

const std::vector<std::string_view>& bur_shapes() {
  static const std::vector<std::string_view> keys = {
      "round",           "inverted_cone",             "straight_fissure", "cross_cut_fissure", "dome_fissure",
      "tapered_fissure", "cross_cut_tapered_fissure", "pear",             "long_pear",         "round_end_taper",
      "flat_end_taper",  "flame",                     "football"};
  return keys;
}

const std::vector<std::string_view>& bur_uses() {
  static const std::vector<std::string_view> keys = {
      "caries",  "entry",   "undercut",    "flatten", "walls",    "bulk",  "line_angles", "crown",    "inlay",
      "class_1", "class_2", "class_2_box", "chamfer", "shoulder", "bevel", "proximal",    "occlusal", "lingual"};
  return keys;
}

}  // namespace cusp::scenarios
