#include "scenarios/format/read.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <optional>
#include <set>
#include <type_traits>

#include <nlohmann/json.hpp>

#include "scenarios/burrs/burr_catalogue.h"
#include "scenarios/format/json_text.h"
#include "scenarios/format/keys.h"
#include "scenarios/format/migrate.h"
#include "scenarios/tissues/tissue_facts.h"

namespace cusp {
namespace {

using nlohmann::json;

/// Range of a number. Bounds here and in scenario.schema.json are the same; a test holds them together.
struct Range {
  double least, most;
  bool above_least = false;  // least itself is out
  std::string text() const {
    std::string out = above_least ? "(" : "[";
    json_text::append_number(out, least);
    out += ", ";
    json_text::append_number(out, most);
    return out + "]";
  }
  bool holds(double v) const noexcept { return v <= most && (above_least ? v > least : v >= least); }
};

constexpr Range kCoordinate{-1000, 1000};
constexpr Range kBand{-1e6, 1e6};

/// Keeps the first failure; everything after it reads defaults and is thrown away.
class Problems {
 public:
  void add(FormatError code, std::string where, std::string detail = {}) {
    if (!first_) first_ = FormatFailure{code, std::move(where), std::move(detail)};
  }
  const std::optional<FormatFailure>& first() const noexcept { return first_; }

 private:
  std::optional<FormatFailure> first_;
};

class Value;

/// An object being read: each key is asked for once; what was not asked for is unknown.
class Object {
 public:
  Object(const json& node, std::string where, Problems& problems)
      : node_(node), where_(std::move(where)), problems_(problems) {
    if (!node.is_object()) problems_.add(FormatError::wrong_type, where_, "object");
  }
  Object(const Object&) = delete;
  Object& operator=(const Object&) = delete;

  Value need(const char* key);
  /// Calls read(value) when the key is there.
  template <class Read>
  void maybe(const char* key, Read read);
  bool has(const char* key) const { return node_.is_object() && node_.contains(key); }
  void nothing_else() {
    if (!node_.is_object()) return;
    for (auto it = node_.begin(); it != node_.end(); ++it) {
      if (!asked_.contains(it.key()))
        problems_.add(FormatError::unknown_key, where_ + json_text::pointer_step(it.key()));
    }
  }
  const std::string& where() const noexcept { return where_; }

 private:
  const json& node_;
  std::string where_;
  Problems& problems_;
  std::set<std::string> asked_;
};

class Value {
 public:
  Value(const json& node, std::string where, Problems& problems)
      : node_(node), where_(std::move(where)), problems_(problems) {}

  double number(const Range& range) const {
    if (!node_.is_number()) return wrong<double>("number");
    const double v = node_.get<double>();
    if (!range.holds(v)) problems_.add(FormatError::out_of_range, where_, range.text());
    return v;
  }
  int integer(const Range& range) const {
    if (!node_.is_number_integer()) return wrong<int>("integer");
    const double v = node_.get<double>();
    if (!range.holds(v)) {
      problems_.add(FormatError::out_of_range, where_, range.text());
      return 0;
    }
    return node_.get<int>();
  }
  std::uint64_t seed() const {
    if (!node_.is_number_integer()) return wrong<std::uint64_t>("integer");
    const Range range{0, 9007199254740991.0};  // 2^53 - 1: every JSON reader keeps it
    if (!range.holds(node_.get<double>())) {
      problems_.add(FormatError::out_of_range, where_, range.text());
      return 0;
    }
    return node_.get<std::uint64_t>();
  }
  bool yes() const {
    if (!node_.is_boolean()) return wrong<bool>("boolean");
    return node_.get<bool>();
  }
  std::string text(std::size_t least, std::size_t most) const {
    if (!node_.is_string()) return wrong<std::string>("string");
    const std::string& v = node_.get_ref<const std::string&>();
    // Characters, as the schema counts them: every byte that does not continue one.
    const auto length = static_cast<std::size_t>(
        std::ranges::count_if(v, [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }));
    if (length < least || length > most) {
      problems_.add(FormatError::out_of_range, where_,
                    Range{static_cast<double>(least), static_cast<double>(most)}.text());
    }
    return v;
  }
  /// One of the words of `known`; an unknown one is `code`.
  template <class Lookup>
  auto word(FormatError code, Lookup lookup) const {
    using T = typename std::invoke_result_t<Lookup, std::string_view>::value_type;
    if (!node_.is_string()) return wrong<T>("string");
    const std::string& v = node_.get_ref<const std::string&>();
    if (auto found = lookup(std::string_view(v))) return *found;
    problems_.add(code, where_, v);
    return T{};
  }
  Vec3 point() const {
    if (!node_.is_array() || node_.size() != 3) return wrong<Vec3>("array of 3 numbers", Vec3(0.0));
    Vec3 v(0.0);
    for (int i = 0; i < 3; ++i) v[i] = item(static_cast<std::size_t>(i)).number(kCoordinate);
    return v;
  }
  /// Calls read(item) for each item of a list of least..most.
  template <class Read>
  void list(std::size_t least, std::size_t most, Read read) const {
    if (!node_.is_array()) {
      problems_.add(FormatError::wrong_type, where_, "array");
      return;
    }
    if (node_.size() < least || node_.size() > most) {
      problems_.add(FormatError::out_of_range, where_,
                    Range{static_cast<double>(least), static_cast<double>(most)}.text());
      return;
    }
    for (std::size_t i = 0; i < node_.size(); ++i) read(item(i));
  }
  LocalText words() const {
    LocalText out;
    if (!node_.is_object()) return wrong<LocalText>("object");
    for (auto it = node_.begin(); it != node_.end(); ++it) {
      const std::string place = where_ + json_text::pointer_step(it.key());
      if (!is_language(it.key())) problems_.add(FormatError::bad_language, place, it.key());
      out[it.key()] = Value(it.value(), place, problems_).text(1, 4000);
    }
    if (!out.contains("en")) problems_.add(FormatError::bad_language, where_, "en");
    return out;
  }

  const std::string& where() const noexcept { return where_; }
  Problems& problems() const noexcept { return problems_; }
  const json& node() const noexcept { return node_; }
  void refuse(FormatError code, std::string detail = {}) const { problems_.add(code, where_, std::move(detail)); }

 private:
  template <class T>
  T wrong(const char* wanted, T nothing = T{}) const {
    problems_.add(FormatError::wrong_type, where_, wanted);
    return nothing;
  }
  Value item(std::size_t i) const { return {node_[i], where_ + "/" + std::to_string(i), problems_}; }
  /// "en", "pt_BR": two or three small letters, a region of two capitals.
  static bool is_language(std::string_view code) noexcept {
    const auto small = [](char c) { return c >= 'a' && c <= 'z'; };
    const auto capital = [](char c) { return c >= 'A' && c <= 'Z'; };
    const std::size_t end = std::min(code.find('_'), code.size());
    const std::string_view language = code.substr(0, end);
    const std::string_view region = code.substr(end);
    if (language.size() < 2 || language.size() > 3 || !std::ranges::all_of(language, small)) return false;
    return region.empty() || (region.size() == 3 && capital(region[1]) && capital(region[2]));
  }

  const json& node_;
  std::string where_;
  Problems& problems_;
};

Value Object::need(const char* key) {
  static const json nothing;  // what is read of it is thrown away: its failure comes after this one
  asked_.insert(key);
  const std::string place = where_ + json_text::pointer_step(key);
  if (!has(key)) {
    problems_.add(FormatError::missing_key, place);
    return {nothing, place, problems_};
  }
  return {node_.at(key), place, problems_};
}

template <class Read>
void Object::maybe(const char* key, Read read) {
  asked_.insert(key);
  if (has(key)) read(Value(node_.at(key), where_ + json_text::pointer_step(key), problems_));
}

template <class Container>
auto one_of(const Container& known) {
  return [&known](std::string_view key) -> std::optional<std::string> {
    return std::ranges::find(known, key) != std::end(known) ? std::optional<std::string>(key) : std::nullopt;
  };
}

std::optional<Method> method_from_key(std::string_view key) {
  for (const Method method : kMethods) {
    if (key_of(method) == key) return method;
  }
  return std::nullopt;
}

/// A file name beside scenario.json: no folder, no drive, nothing hidden.
bool is_plain_file_name(std::string_view name) {
  return !name.empty() && name.front() != '.' && name.find_first_of("/\\:") == std::string_view::npos &&
         std::ranges::all_of(name, [](char c) { return static_cast<unsigned char>(c) >= 0x20; });
}

bool is_key(std::string_view key) {
  return !key.empty() && key.size() <= 64 &&
         std::ranges::all_of(key, [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-'; });
}

Tissue read_tissue(const Value& value) {
  const Tissue tissue = value.word(FormatError::unknown_tissue, scenario_tissue_from_key);
  if (tissue == Tissue::empty && value.node().is_string() && value.node() == "empty")
    value.refuse(FormatError::unknown_tissue, "empty");
  return tissue;
}

LesionSource read_lesion(const Value& value) {
  Object object(value.node(), value.where(), value.problems());
  LesionSource out;
  out.kind = object.need("kind").word(FormatError::unknown_generator, one_of(kLesionKeys));
  out.site = object.need("site").text(1, 64);
  out.radius_mm = object.need("radius_mm").number({0.2, 4});
  out.depth_mm = object.need("depth_mm").number({0, 5});
  out.softness = object.need("softness").number({0, 1});
  object.nothing_else();
  return out;
}

SpecimenSource read_specimen(const Value& value) {
  Object object(value.node(), value.where(), value.problems());
  SpecimenSource out;
  if (object.has("volume")) {
    const Value name = object.need("volume");
    out.volume = name.text(1, 255);
    if (name.node().is_string() && !is_plain_file_name(out.volume)) name.refuse(FormatError::bad_file_name, out.volume);
  } else {
    out.generator = object.need("generator").word(FormatError::unknown_generator, one_of(kGeneratorKeys));
  }
  if (out.generator == "tooth") {
    const Value fdi = object.need("fdi");
    out.fdi = fdi.integer({11, 48});
    if (out.fdi != 0 && !is_fdi(out.fdi)) fdi.refuse(FormatError::out_of_range, "FDI");
    object.maybe("seed", [&](const Value& v) { out.seed = v.seed(); });
    object.maybe("typodont", [&](const Value& v) { out.typodont = v.yes(); });
    object.maybe("around", [&](const Value& list) {
      list.list(0, kAroundKeys.size(), [&](const Value& v) {
        out.around.push_back(v.word(FormatError::unknown_generator, one_of(kAroundKeys)));
      });
    });
    object.maybe("lesions", [&](const Value& list) {
      list.list(0, 16, [&](const Value& v) { out.lesions.push_back(read_lesion(v)); });
    });
  }
  object.maybe("voxel_mm", [&](const Value& v) { out.voxel_mm = v.number({0.04, 1}); });
  object.nothing_else();
  return out;
}

ScenarioTissue read_scenario_tissue(const Value& value) {
  Object object(value.node(), value.where(), value.problems());
  ScenarioTissue out;
  out.tissue = read_tissue(object.need("tissue"));
  // What is left out is the tissue's usual figure; written back, both stand there.
  const TissueFacts& usual = tissue_facts(out.tissue);
  out.stiffness_n_per_mm = usual.stiffness_n_per_mm.value;
  out.speed_mm_s = usual.speed_mm_s.value;
  object.maybe("stiffness_n_per_mm", [&](const Value& v) { out.stiffness_n_per_mm = v.number({0, 20, true}); });
  object.maybe("speed_mm_s", [&](const Value& v) { out.speed_mm_s = v.number({0, 100}); });
  object.nothing_else();
  return out;
}

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

Burr read_burr(const Value& value) {
  Object object(value.node(), value.where(), value.problems());
  Burr out;
  if (object.has("catalogue")) {
    const Value number = object.need("catalogue");
    const std::string text = number.text(1, 64);
    object.nothing_else();
    if (const CatalogueBurr* one = catalogue_burr(text)) return one->burr;
    if (number.node().is_string()) number.refuse(FormatError::unknown_burr, text);
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

Target read_target(const Value& value) {
  Object object(value.node(), value.where(), value.problems());
  Target out;
  out.shape = object.need("shape").word(FormatError::unknown_shape, one_of(kShapeKeys));
  object.need("paths").list(1, 64, [&](const Value& path) {
    auto& points = out.paths.emplace_back();
    path.list(1, 1000, [&](const Value& point) { points.push_back(point.point()); });
  });
  out.width_mm = object.need("width_mm").number({0, 100, true});
  out.depth_mm = object.need("depth_mm").number({0, 100, true});
  out.top_mm = object.need("top_mm").number(kCoordinate);
  out.corner_radius_mm = object.need("corner_radius_mm").number({0, 10});
  object.maybe("box_size_mm", [&](const Value& v) { out.box_size_mm = v.point(); });
  object.nothing_else();
  return out;
}

Bands read_bands(const Value& value) {
  Object object(value.node(), value.where(), value.problems());
  Bands out;
  out.fail_lo = object.need("fail_lo").number(kBand);
  out.acc_lo = object.need("acc_lo").number(kBand);
  out.ideal_lo = object.need("ideal_lo").number(kBand);
  out.ideal_hi = object.need("ideal_hi").number(kBand);
  out.acc_hi = object.need("acc_hi").number(kBand);
  out.fail_hi = object.need("fail_hi").number(kBand);
  object.nothing_else();
  return out;
}

Rubric read_rubric(const Value& value) {
  Object object(value.node(), value.where(), value.problems());
  Rubric out;
  out.pass = object.need("pass").number({0, 100});
  object.need("criteria").list(0, 64, [&](const Value& item) {
    Object one(item.node(), item.where(), item.problems());
    Criterion criterion;
    const Value metric = one.need("metric");
    criterion.metric = metric.word(FormatError::unknown_metric, [](std::string_view key) {
      return metric_from_key(key) ? std::optional<std::string>(key) : std::nullopt;
    });
    for (const Criterion& other : out.criteria) {
      if (other.metric == criterion.metric) metric.refuse(FormatError::duplicate_value, criterion.metric);
    }
    criterion.weight = one.need("weight").number({0, 1000});
    criterion.bands = read_bands(one.need("bands"));
    one.nothing_else();
    out.criteria.push_back(std::move(criterion));
  });
  object.maybe("critical", [&](const Value& list) {
    list.list(0, 16, [&](const Value& item) {
      out.critical.push_back(item.word(FormatError::unknown_critical, one_of(kCriticalKeys)));
    });
  });
  object.nothing_else();
  return out;
}

Scenario read_document(const json& document, Problems& problems) {
  Object root(document, "", problems);
  Scenario out;
  out.format = root.need("format").integer({1, kScenarioFormat});
  const Value id = root.need("id");
  if (const auto parsed = ScenarioId::parse(id.text(0, 64))) {
    out.id = *parsed;
  } else {
    id.refuse(FormatError::bad_id);
  }
  out.version = root.need("version").integer({1, 1e9});
  root.maybe("key", [&](const Value& v) {
    out.key = v.text(1, 64);
    if (v.node().is_string() && !is_key(out.key)) v.refuse(FormatError::out_of_range, "a-z 0-9 -");
  });
  out.title = root.need("title").words();
  out.briefing = root.need("briefing").words();
  out.specimen = read_specimen(root.need("specimen"));
  root.need("tissues").list(0, kTissueCodes, [&](const Value& v) {
    const ScenarioTissue tissue = read_scenario_tissue(v);
    for (const ScenarioTissue& other : out.tissues) {
      if (other.tissue == tissue.tissue)
        v.refuse(FormatError::duplicate_value, std::string(key_of_scenario_tissue(tissue.tissue)));
    }
    out.tissues.push_back(tissue);
  });
  root.need("instruments").list(0, 64, [&](const Value& v) {
    const Burr burr = read_burr(v);
    for (const Burr& other : out.instruments) {
      if (other.name == burr.name) v.refuse(FormatError::duplicate_value, burr.name);
    }
    out.instruments.push_back(burr);
  });
  const Value device_value = root.need("device");
  Object device(device_value.node(), device_value.where(), device_value.problems());
  out.device.needs_dof = device.need("needs_dof").integer({3, 6});
  device.maybe("admitted", [&](const Value& list) {
    list.list(0, 16, [&](const Value& v) {
      out.device.admitted.push_back(v.text(1, 64));
      if (v.node().is_string() && !is_key(out.device.admitted.back())) v.refuse(FormatError::out_of_range, "a-z 0-9 -");
    });
  });
  out.device.full_force_n = device.need("full_force_n").number({0, 50, true});
  device.maybe("tool_tilt_deg", [&](const Value& v) { out.tool_tilt_deg = v.number({-80, 80}); });
  device.maybe("tool_turn_deg", [&](const Value& v) { out.tool_turn_deg = v.number({0, 60}); });
  device.nothing_else();
  out.method = root.need("method").word(FormatError::unknown_method, method_from_key);
  root.maybe("phenomena", [&](const Value& list) {
    list.list(0, 16, [&](const Value& v) {
      out.phenomena.push_back(v.word(FormatError::unknown_phenomenon, one_of(kPhenomenonKeys)));
    });
  });
  out.target = read_target(root.need("target"));
  const Value leeway_value = root.need("leeway");
  Object leeway(leeway_value.node(), leeway_value.where(), leeway_value.problems());
  out.leeway.floor_mm = leeway.need("floor_mm").number({0, 10});
  out.leeway.side_mm = leeway.need("side_mm").number({0, 10});
  leeway.nothing_else();
  root.maybe("protected", [&](const Value& list) {
    list.list(0, kTissueCodes, [&](const Value& v) { out.protected_tissues.push_back(read_tissue(v)); });
  });
  root.maybe("limits", [&](const Value& v) {
    Object limits(v.node(), v.where(), v.problems());
    limits.maybe("time_s", [&](const Value& time) { out.time_limit_s = time.number({0, 86400}); });
    limits.nothing_else();
  });
  out.rubric = read_rubric(root.need("rubric"));
  root.maybe("tolerance", [&](const Value& v) {
    Object tolerance(v.node(), v.where(), v.problems());
    out.tolerance_points = tolerance.need("points").number({0, 100});
    tolerance.nothing_else();
  });
  root.nothing_else();
  return out;
}

}  // namespace

Result<Scenario, FormatFailure> read_scenario(std::string_view text) {
  auto document = json_text::parse(text);
  if (!document) return std::unexpected(document.error());
  if (!document->is_object()) return fail(FormatError::wrong_type, "", "object");
  if (const auto migrated = migrate(*document); !migrated) return std::unexpected(migrated.error());
  Problems problems;
  Scenario scenario = read_document(*document, problems);
  if (problems.first()) return std::unexpected(*problems.first());
  return scenario;
}

Result<Scenario, FormatFailure> read_scenario_file(const std::filesystem::path& path) {
  std::error_code ignored;
  const std::filesystem::path file_path = std::filesystem::is_directory(path, ignored) ? path / "scenario.json" : path;
  if (!std::filesystem::is_regular_file(file_path, ignored)) return fail(FormatError::unreadable, file_path.string());
  std::ifstream file(file_path, std::ios::binary);
  if (!file) return fail(FormatError::unreadable, file_path.string());
  std::string text(kMaxScenarioBytes + 1, '\0');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (file.bad()) return fail(FormatError::unreadable, file_path.string());
  text.resize(static_cast<std::size_t>(file.gcount()));
  auto scenario = read_scenario(text);
  if (!scenario) {
    FormatFailure failure = scenario.error();
    const bool in_text = !failure.where.empty() && failure.where.front() != '/';
    failure.where = file_path.string() + (in_text ? ":" : "#") + failure.where;
    return std::unexpected(std::move(failure));
  }
  return scenario;
}

}  // namespace cusp
