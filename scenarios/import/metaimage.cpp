#include "scenarios/import/metaimage.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <optional>

#include "scenarios/import/header_text.h"
#include "scenarios/import/limit_figures.h"
#include "scenarios/import/packed_data.h"
#include "scenarios/import/samples.h"

namespace cusp::scenarios {
namespace {

constexpr std::size_t kMaxMetaHeaderBytes = 65536;  // of a scanner's with notes: a few KiB
constexpr int kMaxFiles = 4096;
std::string too_many_files(std::size_t files) {
  return text_of({LimitKind::file_count, static_cast<double>(files), kMaxFiles});
}

struct ElementType {
  std::string_view name;
  int bytes;
  bool is_signed;
  bool is_float = false;
};
// Sizes as MetaIO has them: a MET_LONG is four bytes on every machine.
constexpr ElementType kElementTypes[] = {
    {"MET_CHAR", 1, true},       {"MET_UCHAR", 1, false}, {"MET_SHORT", 2, true},      {"MET_USHORT", 2, false},
    {"MET_INT", 4, true},        {"MET_UINT", 4, false},  {"MET_LONG", 4, true},       {"MET_ULONG", 4, false},
    {"MET_LONG_LONG", 8, true},  {"MET_ULONG_LONG", 8, false}, {"MET_FLOAT", 4, true, true}, {"MET_DOUBLE", 8, true, true}};

struct Header {
  std::map<std::string, std::string> field;
  std::vector<std::string> list;  // lines after "ElementDataFile = LIST"
};

Result<Header, ImportFailure> read_header(std::istream& in, const std::string& name) {
  Header out;
  std::size_t bytes = 0;
  for (int at = 1;; ++at) {
    std::string line;
    bool ended = false;
    for (char c; !ended && in.get(c); ended = c == '\n') {
      if (++bytes > kMaxMetaHeaderBytes) return fail(ImportError::bad_header, name);
      if (c == '\0') return fail(at == 1 ? ImportError::unknown_format : ImportError::bad_header, name + ":" + std::to_string(at));
      if (c != '\n' && c != '\r') line += c;
    }
    const std::string_view text = trimmed(line);
    const bool listing = out.field.contains("elementdatafile");
    if (text.empty() && !ended) {
      if (listing) return out;
      return fail(in.bad() ? ImportError::io : at == 1 ? ImportError::unknown_format : ImportError::truncated, name);
    }
    if (text.empty() || text.starts_with('#')) continue;
    if (listing) {
      out.list.emplace_back(text);
      if (out.list.size() > kMaxFiles) return fail(ImportError::too_large, name, too_many_files(out.list.size()));
      continue;
    }
    const auto mark = text.find('=');
    if (mark == text.npos)
      return fail(at == 1 ? ImportError::unknown_format : ImportError::bad_header, name + ":" + std::to_string(at));
    const std::string key = lower(trimmed(text.substr(0, mark)));
    if (!out.field.emplace(key, trimmed(text.substr(mark + 1))).second)
      return fail(ImportError::bad_header, name + ":" + std::to_string(at) + " " + key, "twice");
    if (key == "elementdatafile" && lower(out.field[key]) != "list") return out;
  }
}

/// Millimetres of a DistanceUnits; 0: a name that is not known.
double unit_mm_of(std::string_view name) {
  return name == "mm" ? 1.0 : name == "um" ? 1e-3 : name == "cm" ? 10.0 : 0.0;
}

/// The key whose numbers lay_out() refused. `turn`: nine, as TransformMatrix has them.
std::string_view key_at_fault(ImportError error, const std::vector<double>& turn) {
  if (error == ImportError::bad_header) return "Offset";
  if (error != ImportError::bad_spacing) return "TransformMatrix";
  for (std::size_t row = 0; row < 3; ++row) {
    const double length = std::hypot(turn[3 * row], turn[3 * row + 1], turn[3 * row + 2]);
    if (!(length > 0.0) || !std::isfinite(length)) return "TransformMatrix";
  }
  return "ElementSpacing";
}

/// "%d" or "%03d" in a pattern replaced by a number; nothing for any other pattern.
std::optional<std::string> numbered(const std::string& pattern, int n) {
  const auto at = pattern.find('%');
  if (at == pattern.npos) return std::nullopt;
  const auto end = pattern.find('d', at);
  if (end == pattern.npos || end - at > 3 || pattern.find('%', at + 1) != pattern.npos) return std::nullopt;
  const std::string width = pattern.substr(at + 1, end - at - 1);
  std::string digits = std::to_string(n);
  if (!width.empty()) {
    const auto wide = whole_number<unsigned>(width);
    if (!wide || n < 0) return std::nullopt;
    if (width.front() == '0' && digits.size() < *wide) digits.insert(0, *wide - digits.size(), '0');
  }
  return pattern.substr(0, at) + digits + pattern.substr(end + 1);
}

class Reader {
 public:
  Reader(std::istream& in, std::uintmax_t bytes, const std::string& name, const SideFiles& beside,
         const VolumeLimits& limits, const ImportProgress& progress)
      : in_(in), bytes_(bytes), name_(name), beside_(beside), limits_(limits), progress_(progress) {}

  Result<Image, ImportFailure> run() {
    auto header = read_header(in_, name_);
    if (!header) return std::unexpected(header.error());
    header_ = std::move(*header);
    using Step = Result<void, ImportFailure> (Reader::*)();
    for (const Step step : {&Reader::samples, &Reader::place, &Reader::files, &Reader::data}) {
      if (auto r = (this->*step)(); !r) return std::unexpected(r.error());
    }
    return std::move(out_);
  }

 private:
  std::unexpected<ImportFailure> refuse(ImportError code, std::string_view key, std::string detail = {}) const {
    return fail(code, name_ + " " + std::string(key), std::move(detail));
  }
  const std::string* field(std::initializer_list<std::string_view> names) const {
    for (const std::string_view n : names) {
      const auto it = header_.field.find(lower(n));
      if (it != header_.field.end()) return &it->second;
    }
    return nullptr;
  }
  enum class Otherwise : std::uint8_t { no, yes };
  bool is_true(std::initializer_list<std::string_view> names, Otherwise otherwise = Otherwise::no) const {
    const std::string* text = field(names);
    return text ? lower(*text) == "true" || *text == "1" : otherwise == Otherwise::yes;
  }
  /// So many finite numbers; an empty list when the key is not there.
  Result<std::vector<double>, ImportFailure> numbers(std::initializer_list<std::string_view> names, std::size_t count) const {
    std::vector<double> out;
    const std::string* text = field(names);
    if (!text) return out;
    for (const std::string_view word : tokens(*text)) {
      const auto n = number(word);
      if (!n) return refuse(ImportError::bad_header, *names.begin());
      out.push_back(*n);
    }
    if (out.size() != count) return refuse(ImportError::bad_header, *names.begin());
    return out;
  }

  Result<void, ImportFailure> samples() {
    if (const std::string* type = field({"ObjectType"}); type && lower(*type) != "image")
      return refuse(ImportError::unsupported, "ObjectType");
    const std::string* dimension = field({"NDims"});
    if (!dimension) return fail(ImportError::unknown_format, name_);
    if (*dimension != "3") return refuse(ImportError::bad_sizes, "NDims");
    if (!is_true({"BinaryData"}, Otherwise::yes)) return refuse(ImportError::unsupported, "BinaryData");
    packing_ = is_true({"CompressedData"}) ? Packing::deflate : Packing::raw;
    const std::string* type = field({"ElementType"});
    if (!type) return refuse(ImportError::bad_header, "ElementType");
    const auto known = std::ranges::find(kElementTypes, std::string_view(*type), &ElementType::name);
    if (known == std::end(kElementTypes)) return refuse(ImportError::unsupported, "ElementType");
    format_ = {known->bytes, known->is_signed, known->is_float,
               is_true({"BinaryDataByteOrderMSB", "ElementByteOrderMSB"})};
    if (const std::string* n = field({"ElementNumberOfChannels"}); n && *n != "1") {
      if ((*n != "3" && *n != "4") || known->bytes != 1) return refuse(ImportError::unsupported, "ElementNumberOfChannels");
      channels_ = *n == "3" ? 3 : 4;
    }
    return {};
  }

  Result<void, ImportFailure> place() {
    const auto sizes = numbers({"DimSize"}, 3);
    if (!sizes) return std::unexpected(sizes.error());
    if (sizes->empty()) return refuse(ImportError::bad_sizes, "DimSize");
    for (std::size_t i = 0; i < 3; ++i) {
      const double n = (*sizes)[i];
      if (!(n >= 1.0) || n != std::floor(n)) return refuse(ImportError::bad_sizes, "DimSize");
    }
    const Vec3 voxels((*sizes)[0], (*sizes)[1], (*sizes)[2]);
    if (auto passed = passed_file_limit(voxels, limits_); !passed.empty()) return refuse(ImportError::too_large, "DimSize", std::move(passed));
    const IVec3 size(voxels);
    auto spacing = numbers({"ElementSpacing", "ElementSize"}, 3);
    const auto origin = numbers({"Offset", "Position", "Origin"}, 3);
    auto turn = numbers({"TransformMatrix", "Rotation", "Orientation"}, 9);
    if (!spacing) return std::unexpected(spacing.error());
    if (!origin) return std::unexpected(origin.error());
    if (!turn) return std::unexpected(turn.error());
    const std::string* unit = field({"DistanceUnits"});
    // Without a unit: millimetres, as the programs that write none mean it.
    double unit_mm = unit ? unit_mm_of(lower(*unit)) : 1.0;
    const bool has_lengths = !spacing->empty() && std::ranges::all_of(*spacing, [](double n) { return std::isfinite(n) && n > 0.0; });
    out_.spacing_known = has_lengths && unit_mm > 0.0;
    if (!has_lengths) *spacing = {1.0, 1.0, 1.0};
    if (!out_.spacing_known) unit_mm = 1.0;
    out_.sides_known = !turn->empty();  // a header that was typed beside raw data has none
    if (turn->empty()) *turn = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    std::array<Vec3, 3> step{};
    const Vec3 ras(-1.0, -1.0, 1.0);
    for (std::size_t i = 0; i < 3; ++i)
      step[i] = ras * Vec3((*turn)[3 * i], (*turn)[3 * i + 1], (*turn)[3 * i + 2]) * ((*spacing)[i] * unit_mm);
    const Vec3 first = origin->empty() ? Vec3(0.0) : ras * Vec3((*origin)[0], (*origin)[1], (*origin)[2]) * unit_mm;
    const auto layout = lay_out(size, step, first, limits_);
    if (!layout) return refuse(layout.error(), key_at_fault(layout.error(), *turn));
    out_.layout = *layout;
    return {};
  }

  /// The names of the files that hold the data; none when the header's own file does.
  Result<void, ImportFailure> files() {
    const std::string* text = field({"ElementDataFile"});
    if (!text) return refuse(ImportError::bad_header, "ElementDataFile");
    if (const std::string* skip = field({"HeaderSize"}); skip && *skip != "0") return refuse(ImportError::unsupported, "HeaderSize");
    if (lower(*text) == "local") return {};
    if (lower(*text) == "list") {
      files_ = header_.list;
    } else if (text->find('%') != text->npos) {
      const auto word = tokens(*text);
      if (word.size() != 4) return refuse(ImportError::bad_header, "ElementDataFile");
      const auto low = whole_number<int>(word[1]), high = whole_number<int>(word[2]), by = whole_number<int>(word[3]);
      if (!low || !high || !by || *by < 1 || *by > 1000000 || *low < 0 || *high < *low || *high > 1000000)
        return refuse(ImportError::bad_header, "ElementDataFile");
      for (int n = *low; n <= *high; n += *by) {
        const auto one = numbered(std::string(word[0]), n);
        if (!one) return refuse(ImportError::unsupported, "ElementDataFile");
        files_.push_back(*one);
        if (files_.size() > kMaxFiles) return refuse(ImportError::too_large, "ElementDataFile", too_many_files(files_.size()));
      }
    } else {
      files_.push_back(*text);
    }
    // As many files as slices, or one for all.
    if (files_.size() != 1 && files_.size() != static_cast<std::size_t>(out_.layout.file_size.z))
      return refuse(ImportError::bad_sizes, "ElementDataFile");
    for (const std::string& one : files_) {
      if (one.empty() || one == ".." || one == "." || one.find_first_of("/\\:") != one.npos)
        return refuse(ImportError::unsupported, "ElementDataFile");
    }
    return {};
  }

  Result<void, ImportFailure> data() {
    const IVec3 size = out_.layout.file_size;
    const auto slice = static_cast<std::uintmax_t>(size.x) * static_cast<std::uintmax_t>(size.y) *
                       static_cast<std::uintmax_t>(format_.bytes * channels_);
    const bool local = files_.empty();
    const int slices_a_file = local || files_.size() == 1 ? size.z : 1;
    const std::uintmax_t needed = slice * static_cast<std::uintmax_t>(slices_a_file);
    SideFile side;
    // Every named file must exist and be long enough before memory is reserved.
    for (std::size_t i = 0; files_.size() > 1 && i < files_.size(); ++i) {
      side = beside_(files_[i]);
      if (!side.in) return fail(ImportError::missing_file, files_[i]);
      if (!data_can_be_there(*side.in, {side.bytes, needed}, packing_)) return fail(ImportError::truncated, files_[i]);
    }
    for (int k = 0; k < size.z; k += slices_a_file) {
      const std::string file = local ? name_ : files_[files_.size() == 1 ? 0 : static_cast<std::size_t>(k)];
      if (!local) {
        side = beside_(file);
        if (!side.in) return fail(ImportError::missing_file, file);
      }
      std::istream& from = local ? in_ : *side.in;
      if (!data_can_be_there(from, {local ? bytes_ : side.bytes, needed}, packing_)) return fail(ImportError::truncated, file);
      if (k == 0) {
        out_.value.resize(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) * static_cast<std::size_t>(size.z));
      }
      PackedSource source(from, packing_);
      for (int n = k; n < k + slices_a_file; ++n) {
        if (progress_) progress_(static_cast<double>(n) / size.z);
        if (const auto r = read_slice(source, n); !r) return fail(r.error(), file);
      }
      if (const auto r = source.expect_end(); !r) return fail(r.error(), file);
    }
    if (const auto r = tidy_values(out_); !r) return fail(r.error(), name_);
    out_.kind = channels_ > 1 ? ImageKind::colours : kind_of_values(out_.value);
    return {};
  }

  Result<void, ImportError> read_slice(PackedSource& source, int k) {
    const IVec3 size = out_.layout.file_size;
    const auto voxel = static_cast<std::size_t>(format_.bytes * channels_);
    std::vector<std::byte> row(static_cast<std::size_t>(size.x) * voxel);
    for (int j = 0; j < size.y; ++j) {
      if (auto r = source.read(row); !r) return r;
      for (int i = 0; i < size.x; ++i) {
        const std::byte* p = &row[static_cast<std::size_t>(i) * voxel];
        out_.value[out_.layout.place(i, j, k)] = channels_ > 1 ? colour_value(p, channels_)
                                                               : static_cast<float>(sample_value(p, format_));
      }
    }
    return {};
  }

  std::istream& in_;
  std::uintmax_t bytes_;
  const std::string& name_;
  const SideFiles& beside_;
  const VolumeLimits& limits_;
  const ImportProgress& progress_;
  Header header_;
  SampleFormat format_;
  int channels_ = 1;
  Packing packing_ = Packing::raw;
  std::vector<std::string> files_;
  Image out_;
};

}  // namespace

Result<Image, ImportFailure> read_metaimage(std::istream& in, std::uintmax_t bytes, const std::string& name,
                                            const SideFiles& beside, const VolumeLimits& limits,
                                            const ImportProgress& progress) {
  return Reader(in, bytes, name, beside, limits, progress).run();
}

Result<Image, ImportFailure> read_metaimage(const std::filesystem::path& file, const VolumeLimits& limits,
                                            const ImportProgress& progress) {
  std::ifstream in;
  const auto bytes = open_volume_file(file, in);
  if (!bytes) return std::unexpected(bytes.error());
  const SideFiles beside = [&](const std::string& name) {
    SideFile side;
    auto opened = std::make_unique<std::ifstream>();
    if (const auto length = open_volume_file(file.parent_path() / name, *opened)) {
      side.bytes = *length;
      side.in = std::move(opened);
    }
    return side;
  };
  return read_metaimage(in, *bytes, file.filename().string(), beside, limits, progress);
}

}  // namespace cusp::scenarios
