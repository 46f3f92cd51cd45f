#include "scenarios/import/nrrd_header.h"

#include <algorithm>
#include <bitset>
#include <charconv>
#include <cmath>
#include <optional>
#include <vector>

#include "scenarios/import/header_text.h"
#include "scenarios/import/limit_figures.h"

namespace cusp::scenarios {
namespace {

std::optional<Vec3> vector3(std::string_view t) {
  if (t.size() < 2 || t.front() != '(' || t.back() != ')') return std::nullopt;
  t = t.substr(1, t.size() - 2);
  Vec3 out;
  for (int i = 0; i < 3; ++i) {
    const auto comma = i < 2 ? t.find(',') : t.size();
    if (comma == t.npos) return std::nullopt;
    const auto n = number(t.substr(0, comma));
    if (!n) return std::nullopt;
    out[i] = *n;
    t.remove_prefix(std::min(comma + 1, t.size()));
  }
  return out;
}

struct TypeName {
  std::string_view name;
  int bytes;
  bool is_signed;
  bool is_float = false;
};
constexpr TypeName kTypeNames[] = {
    {"signed char", 1, true},   {"int8", 1, true},          {"int8_t", 1, true},
    {"uchar", 1, false},        {"unsigned char", 1, false}, {"uint8", 1, false},
    {"uint8_t", 1, false},      {"short", 2, true},         {"short int", 2, true},
    {"signed short", 2, true},  {"signed short int", 2, true}, {"int16", 2, true},
    {"int16_t", 2, true},       {"ushort", 2, false},       {"unsigned short", 2, false},
    {"unsigned short int", 2, false}, {"uint16", 2, false}, {"uint16_t", 2, false},
    {"int", 4, true},           {"signed int", 4, true},    {"int32", 4, true},
    {"int32_t", 4, true},       {"uint", 4, false},         {"unsigned int", 4, false},
    {"uint32", 4, false},       {"uint32_t", 4, false},     {"longlong", 8, true},
    {"long long", 8, true},     {"int64", 8, true},         {"int64_t", 8, true},
    {"ulonglong", 8, false},    {"unsigned long long", 8, false}, {"uint64", 8, false},
    {"uint64_t", 8, false},     {"float", 4, true, true},   {"double", 8, true, true},
};

/// Fields of the format that change nothing here.
constexpr std::string_view kIgnored[] = {"content",   "number",       "min",         "max",       "old min",
                                         "oldmin",    "old max",      "oldmax",      "block size", "blocksize",
                                         "axis mins", "axismins",     "axis maxs",   "axismaxs",  "centers",
                                         "centerings", "labels",      "units",       "sample units", "sampleunits",
                                         "thicknesses", "kinds",      "measurement frame"};

struct Field {
  std::string value;
  int line = 0;
};

/// A key/value's text: `\\` and `\n` stand for themselves.
std::string unescaped(std::string_view t) {
  std::string out;
  for (std::size_t i = 0; i < t.size(); ++i) {
    if (t[i] == '\\' && i + 1 < t.size()) {
      ++i;
      out += t[i] == 'n' ? '\n' : t[i];
    } else {
      out += t[i];
    }
  }
  return out;
}

class Parser {
 public:
  Parser(std::string_view text, const std::string& file, const VolumeLimits& limits, NrrdUse use)
      : text_(text), file_(file), limits_(limits), image_(use == NrrdUse::image) {}

  Result<NrrdHeader, ImportFailure> run() {
    using Step = Result<void, ImportFailure> (Parser::*)();
    for (const Step step : {&Parser::split, &Parser::type_and_encoding, &Parser::sizes, &Parser::axes}) {
      if (auto r = (this->*step)(); !r) return std::unexpected(r.error());
    }
    return out_;
  }

 private:
  std::unexpected<ImportFailure> refuse(ImportError code, std::string_view key, std::string detail = {}) const {
    const auto it = fields_.find(std::string(key));
    std::string where = file_;
    if (it != fields_.end()) where += ":" + std::to_string(it->second.line);
    return fail(code, where + " " + std::string(key), std::move(detail));
  }
  std::unexpected<ImportFailure> refuse_line(ImportError code, int line) const {
    return fail(code, file_ + ":" + std::to_string(line));
  }
  const std::string* field(std::string_view key) const {
    const auto it = fields_.find(std::string(key));
    return it == fields_.end() ? nullptr : &it->second.value;
  }

  Result<void, ImportFailure> split() {
    std::string_view rest = text_;
    for (int line = 1; !rest.empty(); ++line) {
      const auto end = rest.find('\n');
      std::string_view t = rest.substr(0, end);
      rest = end == rest.npos ? std::string_view{} : rest.substr(end + 1);
      if (t.ends_with('\r')) t.remove_suffix(1);
      if (line == 1) {
        if (t.size() != 8 || !t.starts_with("NRRD000")) return refuse_line(ImportError::unknown_format, 1);
        if (t[7] < '1' || t[7] > '5') return fail(ImportError::unsupported, file_ + ":1", std::string(t));
        continue;
      }
      if (t.starts_with('#')) continue;
      // A field is "name: value", a key/value "key:=value"; the first of the two marks decides.
      const auto colon = t.find(':');
      if (colon == t.npos || colon + 1 >= t.size()) return refuse_line(ImportError::bad_header, line);
      if (t[colon + 1] == '=') {
        if (auto r = key_value(t.substr(0, colon), t.substr(colon + 2), line); !r) return r;
      } else {
        const std::string key = lower(trimmed(t.substr(0, colon)));
        if (!fields_.emplace(key, Field{std::string(trimmed(t.substr(colon + 1))), line}).second)
          return refuse(ImportError::bad_header, key, "twice");
      }
    }
    for (const auto& [key, value] : fields_) {
      if (std::ranges::find(kIgnored, key) != std::end(kIgnored)) continue;
      static constexpr std::string_view read[] = {"type",  "dimension",       "space",        "space dimension", "sizes",
                                                  "endian", "space directions", "space origin", "space units",
                                                  "encoding", "spacings"};
      static constexpr std::string_view refused[] = {"data file", "datafile", "line skip", "lineskip", "byte skip",
                                                     "byteskip"};
      if (std::ranges::find(read, key) != std::end(read)) continue;
      if (std::ranges::find(refused, key) != std::end(refused)) {
        if (value.value == "0") continue;
        return refuse(ImportError::unsupported, key);
      }
      return refuse(ImportError::bad_header, key);
    }
    return {};
  }

  Result<void, ImportFailure> key_value(std::string_view key, std::string_view value, int line) {
    if (!key.starts_with("tissue ")) return {};
    unsigned code = 0;
    const std::string_view digits = key.substr(7);
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), code);
    if (error != std::errc{} || end != digits.data() + digits.size() || code >= kTissueCodes)
      return refuse_line(ImportError::bad_tissue, line);
    if (!codes_named_[code]) codes_named_.set(code);
    else return refuse_line(ImportError::bad_tissue, line);
    const std::string name = unescaped(value);
    if (code >= 16) {
      out_.names[static_cast<std::uint8_t>(code)] = name;
    } else if (code >= kTissueKeys.size() || kTissueKeys[code] != name) {
      return refuse_line(ImportError::bad_tissue, line);
    }
    return {};
  }

  Result<void, ImportFailure> type_and_encoding() {
    const std::string* type = field("type");
    if (!type) return refuse(ImportError::bad_header, "type");
    const auto known = std::ranges::find(kTypeNames, std::string_view(lower(*type)), &TypeName::name);
    if (known == std::end(kTypeNames) || (known->is_float && !image_)) return refuse(ImportError::unsupported, "type", *type);
    out_.sample_bytes = known->bytes;
    out_.sample_signed = known->is_signed;
    out_.sample_float = known->is_float;

    const std::string* encoding = field("encoding");
    if (!encoding) return refuse(ImportError::bad_header, "encoding");
    const std::string e = lower(*encoding);
    if (e != "gzip" && e != "gz" && e != "raw") return refuse(ImportError::unsupported, "encoding", *encoding);
    out_.gzip = e != "raw";

    const std::string* endian = field("endian");
    if (!endian && out_.sample_bytes > 1) return refuse(ImportError::bad_header, "endian");
    if (endian) {
      const std::string n = lower(*endian);
      if (n != "little" && n != "big") return refuse(ImportError::bad_header, "endian", *endian);
      out_.big_endian = n == "big";
    }
    return {};
  }

  Result<void, ImportFailure> sizes() {
    const std::string* dimension = field("dimension");
    if (!dimension) return refuse(ImportError::bad_header, "dimension");
    if (*dimension != "3" && *dimension != "4") return refuse(ImportError::bad_sizes, "dimension", *dimension);
    first_ = *dimension == "4" ? 1u : 0u;

    const std::string* text = field("sizes");
    if (!text) return refuse(ImportError::bad_header, "sizes");
    const auto list = tokens(*text);
    if (list.size() != first_ + 3) return refuse(ImportError::bad_sizes, "sizes", *text);
    std::vector<std::size_t> size;
    for (const std::string_view word : list) {
      std::size_t n = 0;
      const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), n);
      if (error == std::errc::result_out_of_range) return refuse(ImportError::too_large, "sizes", *text);
      if (error != std::errc{} || end != word.data() + word.size() || n == 0)
        return refuse(ImportError::bad_sizes, "sizes", *text);
      size.push_back(n);
    }
    if (first_ == 1) {
      out_.samples = size[0] <= 4 ? static_cast<int>(size[0]) : 0;
      if (size[0] == 2 && out_.sample_bytes == 2 && !out_.sample_signed)
        out_.content = NrrdHeader::Content::tissue_and_s;
      else if (image_ && (size[0] == 3 || size[0] == 4) && out_.sample_bytes == 1)
        out_.content = NrrdHeader::Content::colours;
      else if (size[0] != 1)  // channels: no tissue codes
        return refuse(ImportError::unsupported, "sizes", *text);
    }
    const Vec3 sizes(size[first_], size[first_ + 1], size[first_ + 2]);
    if (auto passed = passed_file_limit(sizes, limits_); !passed.empty()) return refuse(ImportError::too_large, "sizes", std::move(passed));
    out_.file_size = IVec3(sizes);
    return {};
  }

  /// Turns of the file's space into right-anterior-superior: minus for an axis that points the other way.
  Result<Vec3, ImportFailure> space_signs() const {
    const std::string* space = field("space");
    if (!space) {
      if (const std::string* n = field("space dimension"); n && *n != "3")
        return refuse(ImportError::bad_orientation, "space dimension", *n);
      return Vec3(1.0);
    }
    const std::string s = lower(*space);
    if (s == "right-anterior-superior" || s == "ras" || s == "3d-right-handed" || s == "scanner-xyz") return Vec3(1.0);
    if (s == "left-posterior-superior" || s == "lps") return Vec3(-1.0, -1.0, 1.0);
    if (s == "left-anterior-superior" || s == "las") return Vec3(-1.0, 1.0, 1.0);
    return refuse(ImportError::bad_orientation, "space", *space);
  }

  Result<void, ImportFailure> axes() {
    const std::string* units = field("space units");
    const std::size_t skipped = units ? 0 : first_;  // `units`, for spacings, has one for the colours too
    if (!units && image_ && !field("space directions")) units = field("units");
    const auto words = units ? tokens(*units) : std::vector<std::string_view>();
    for (std::size_t i = skipped; i < words.size(); ++i) {
      const double mm = words[i] == "\"mm\"" ? 1.0 : words[i] == "\"um\"" ? 1e-3 : words[i] == "\"cm\"" ? 10.0 : words[i] == "\"m\"" ? 1000.0 : 0.0;
      if (!image_ && mm != 1.0) return refuse(ImportError::bad_spacing, "space units", *units);
      out_.unit_mm = i == skipped || mm == out_.unit_mm ? mm : 0.0;  // of axes that differ none is known
    }
    const auto signs = space_signs();
    if (!signs) return std::unexpected(signs.error());

    std::array<Vec3, 3> direction{};
    std::string_view key = "space directions";
    if (const std::string* text = field(key)) {
      const auto list = tokens(*text);
      if (list.size() != first_ + 3) return refuse(ImportError::bad_header, key, *text);
      for (std::size_t i = 0; i < 3; ++i) {
        const auto v = vector3(list[first_ + i]);
        if (!v) return refuse(ImportError::bad_header, key, *text);
        direction[i] = *v * *signs;
      }
    } else {
      key = "spacings";
      const std::string* spacings = field(key);
      if (!spacings && !image_) return refuse(ImportError::bad_spacing, key);
      static const std::string none = "nan nan nan nan";
      if (!spacings) spacings = &none;
      const auto list = tokens(*spacings);
      if (list.size() != first_ + 3 && spacings != &none) return refuse(ImportError::bad_header, key, *spacings);
      for (std::size_t i = 0; i < 3; ++i) {
        const auto n = number(list[first_ + i]);
        if (!n) return refuse(ImportError::bad_header, key, *spacings);
        if (*n <= 0.0) return refuse(ImportError::bad_header, key, *spacings);
        direction[i][static_cast<int>(i)] = *n * (*signs)[static_cast<int>(i)];
      }
    }
    return image_ ? keep(direction, *signs) : place(direction, key, *signs);
  }

  /// An image's own steps; where one is not a number, the lengths are not known at all.
  Result<void, ImportFailure> keep(std::array<Vec3, 3> direction, Vec3 signs) {
    const auto known = [](Vec3 d) { return std::isfinite(d.x + d.y + d.z) && d != Vec3(0.0); };
    out_.spacing_known = out_.unit_mm > 0.0 && std::ranges::all_of(direction, known);
    out_.sides_known = field("space") != nullptr;
    if (!std::ranges::all_of(direction, known)) {
      direction = {Vec3(signs.x, 0, 0), Vec3(0, signs.y, 0), Vec3(0, 0, signs.z)};
    }
    const double unit = out_.unit_mm > 0.0 ? out_.unit_mm : 1.0;
    for (std::size_t i = 0; i < 3; ++i) out_.step_mm[i] = direction[i] * unit;
    if (const std::string* text = field("space origin")) {
      const auto v = vector3(trimmed(*text));
      if (!v) return refuse(ImportError::bad_header, "space origin", *text);
      const Vec3 at = *v * signs * unit;
      if (std::isfinite(at.x + at.y + at.z)) out_.first_mm = at;
    }
    return {};
  }

  Result<void, ImportFailure> place(const std::array<Vec3, 3>& direction, std::string_view key, Vec3 signs) {
    std::array<double, 3> edge{};
    std::array<bool, 3> taken{};
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 d = direction[i];
      const Vec3 a = glm::abs(d);
      // A NaN fails here too: "not spatial" is for the colour axis only.
      if (!(a.x + a.y + a.z > 0.0) || !std::isfinite(a.x + a.y + a.z)) return refuse(ImportError::bad_spacing, key);
      const int along = a.x >= a.y && a.x >= a.z ? 0 : a.y >= a.z ? 1 : 2;
      for (int k = 0; k < 3; ++k) {
        // Six printed digits of a direction that is meant to be straight.
        if (k != along && a[k] > 1e-5 * a[along]) return refuse(ImportError::bad_orientation, key);
      }
      if (taken[static_cast<std::size_t>(along)]) return refuse(ImportError::bad_orientation, key);
      taken[static_cast<std::size_t>(along)] = true;
      edge[i] = a[along];
      out_.axis[i] = along;
      out_.reversed[i] = d[along] < 0.0;
    }
    const double voxel = edge[0];
    if (!(voxel >= limits_.min_voxel_mm && voxel <= limits_.max_voxel_mm)) return refuse(ImportError::bad_spacing, key);
    for (const double e : edge) {
      if (std::abs(e - voxel) > 1e-4 * voxel) return refuse(ImportError::bad_spacing, key);
    }
    Vec3 first_mm(0.0);
    if (const std::string* text = field("space origin")) {
      const auto v = vector3(trimmed(*text));
      if (!v) return refuse(ImportError::bad_header, "space origin", *text);
      first_mm = *v * signs;
      if (!std::isfinite(first_mm.x + first_mm.y + first_mm.z)) return refuse(ImportError::bad_header, "space origin");
    }
    out_.grid.voxel_mm = voxel;
    out_.grid.origin_mm = first_mm;
    for (std::size_t i = 0; i < 3; ++i) {
      const int to = out_.axis[i];
      const int n = out_.file_size[static_cast<int>(i)];
      out_.grid.size[to] = n;
      if (out_.reversed[i]) out_.grid.origin_mm[to] -= voxel * (n - 1);
    }
    return {};
  }

  std::string_view text_;
  const std::string& file_;
  const VolumeLimits& limits_;
  bool image_;
  std::map<std::string, Field> fields_;
  std::bitset<kTissueCodes> codes_named_;
  std::size_t first_ = 0;  // of the spatial axes
  NrrdHeader out_;
};

}  // namespace

Result<NrrdHeader, ImportFailure> parse_nrrd_header(std::string_view text, const std::string& file,
                                                    const VolumeLimits& limits, NrrdUse use) {
  return Parser(text, file, limits, use).run();
}

std::string nrrd_header_of(const VoxelVolume& volume) {
  const Grid& g = volume.grid;
  const std::string v = exact(g.voxel_mm);
  std::string out =
      "NRRD0005\n"
      "# Cusp specimen: per voxel its tissue and its solid fraction in 1/65535\n"
      "type: uint16\n"
      "dimension: 4\n"
      "space: right-anterior-superior\n";
  out += "sizes: 2 " + std::to_string(g.size.x) + " " + std::to_string(g.size.y) + " " + std::to_string(g.size.z) + "\n";
  out += "space directions: none (" + v + ",0,0) (0," + v + ",0) (0,0," + v + ")\n";
  out +=
      "centerings: none cell cell cell\n"
      "kinds: list space space space\n"
      "endian: little\n"
      "encoding: gzip\n";
  out += "space origin: (" + exact(g.origin_mm.x) + "," + exact(g.origin_mm.y) + "," + exact(g.origin_mm.z) + ")\n";
  out += "space units: \"mm\" \"mm\" \"mm\"\n";

  std::bitset<kTissueCodes> present;
  for (const Tissue t : volume.tissue) present.set(index_of(t));
  for (std::size_t code = 1; code < kTissueKeys.size(); ++code) {
    if (present[code]) out += "tissue " + std::to_string(code) + ":=" + std::string(kTissueKeys[code]) + "\n";
  }
  for (const auto& [code, name] : volume.names) {
    std::string escaped;
    for (const char c : name) {
      if (c == '\\') escaped += '\\';
      escaped += c;
    }
    out += "tissue " + std::to_string(code) + ":=" + escaped + "\n";
  }
  return out + "\n";
}

}  // namespace cusp::scenarios
