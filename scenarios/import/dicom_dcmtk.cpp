// The one file that knows DCMTK. What is asked of a file is listed in read_slice and pixels_of, and nothing else of it is
// kept: neither names nor dates nor numbers of patients.
#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dcrledrg.h>
#include <dcmtk/dcmdata/dctk.h>
#include <dcmtk/dcmjpeg/djdecode.h>
#include <dcmtk/oflog/oflog.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <map>
#include <new>
#include <optional>
#include <vector>

#include "scenarios/import/foreign_images.h"
#include "scenarios/import/header_text.h"
#include "scenarios/import/limit_figures.h"

namespace cusp::scenarios {
namespace {

constexpr std::size_t kMaxFiles = 4096;       // in one folder; a full-body series has 2,000
constexpr double kSameStep = 0.01;            // share by which the steps between slices may differ
constexpr double kAsidePixels = 0.1;          // that a slice may lie beside the line through the first and the last
constexpr double kSkew = 0.01;                // of an orientation's vectors from unit length and a right angle
constexpr std::uintmax_t kMaxFileBytes = std::uintmax_t{256} << 20;

/// A packed pixel takes at least a 64th of a byte: RLE halves each of its bytes to a 64th, JPEG lossless has a bit for it.
constexpr std::uintmax_t kMostPacked = 64;

/// Packings without loss whose decoders the library has. JPEG with loss moves the surfaces, and stays refused.
bool unpackable(E_TransferSyntax syntax) {
  return syntax == EXS_RLELossless || syntax == EXS_JPEGProcess14 || syntax == EXS_JPEGProcess14SV1;
}

/// DCMTK 3.6.9 deprecates isEncapsulated(); 3.6.7 has nothing else. A template leaves out the call that is missing.
template <class Syntax>
bool encapsulated(const Syntax& syntax) {
  if constexpr (requires { syntax.usesEncapsulatedFormat(); }) {
    return syntax.usesEncapsulatedFormat();
  } else {
    return syntax.isEncapsulated();
  }
}

struct Slice {
  std::filesystem::path file;
  std::string series;
  int columns = 0, rows = 0;
  Vec3 across{1, 0, 0}, down{0, 1, 0};  // along a row, along a column; left-posterior-superior
  Vec3 first_mm{0.0};                   // centre of the first pixel
  bool placed = false;                  // the file holds its position
  double pixel_across_mm = 1.0, pixel_down_mm = 1.0;
  bool spacing_known = true;
  double stated_step_mm = 0.0;          // between slices, as the file states it; their thickness where it does not; 0: neither
  std::optional<double> location_mm;    // along the series, where no place is given
  double number = 0.0;                  // of the slice in the series, where not even that is
  double slope = 1.0, intercept = 0.0;
  double along = 0.0;  // place along the normal, mm
  bool packed = false;
};

std::optional<double> real(DcmItem& set, const DcmTagKey& key, unsigned long at = 0) {
  OFString text;
  if (set.findAndGetOFString(key, text, at).bad() || text.empty()) return std::nullopt;
  // The library's own reader takes the 1 of "1,25" for all of it.
  const auto value = number(text.c_str());
  return value && std::isfinite(*value) ? value : std::nullopt;
}

/// Whether there is text, and it is no number.
bool is_no_number(DcmItem& set, const DcmTagKey& key) {
  OFString text;
  return set.findAndGetOFString(key, text).good() && !text.empty() && !real(set, key);
}

std::optional<Vec3> vector3(DcmItem& set, const DcmTagKey& key, unsigned long from) {
  Vec3 out(0.0);
  for (unsigned long i = 0; i < 3; ++i) {
    const auto n = real(set, key, from + i);
    if (!n) return std::nullopt;
    out[static_cast<int>(i)] = *n;
  }
  return out;
}

std::optional<Uint16> whole(DcmItem& set, const DcmTagKey& key) {
  Uint16 value = 0;
  if (set.findAndGetUint16(key, value).bad()) return std::nullopt;
  return value;
}

/// The slice's head without its pixels.
Result<Slice, ImportFailure> read_slice(const std::filesystem::path& file) {
  const std::string name = file.filename().string();
  DcmFileFormat format;
  const OFCondition read = format.loadFileUntilTag(file.c_str(), EXS_Unknown, EGL_noChange, 1024, ERM_autoDetect, DCM_PixelData);
  if (read.bad()) return fail(ImportError::corrupt, name, read.text());
  DcmDataset& set = *format.getDataset();
  Slice out;
  out.file = file;
  OFString text;
  if (set.findAndGetOFString(DCM_SeriesInstanceUID, text).good()) out.series = text.c_str();
  const auto rows = whole(set, DCM_Rows), columns = whole(set, DCM_Columns);
  if (!rows || !columns || *rows == 0 || *columns == 0) return fail(ImportError::bad_sizes, name + " Rows");
  out.rows = *rows;
  out.columns = *columns;
  if (whole(set, DCM_SamplesPerPixel).value_or(1) != 1) return fail(ImportError::unsupported, name + " SamplesPerPixel");
  if (set.findAndGetOFString(DCM_PhotometricInterpretation, text).good() && text != "MONOCHROME2")
    return fail(ImportError::unsupported, name + " PhotometricInterpretation");
  if (real(set, DCM_NumberOfFrames).value_or(1.0) > 1.0) return fail(ImportError::unsupported, name + " NumberOfFrames");
  out.packed = encapsulated(DcmXfer(set.getOriginalXfer()));
  if (out.packed && !unpackable(set.getOriginalXfer())) return fail(ImportError::unsupported, name + " TransferSyntaxUID");
  const auto down = real(set, DCM_PixelSpacing, 0), across = real(set, DCM_PixelSpacing, 1);
  out.spacing_known = down && across && *down > 0.0 && *across > 0.0;
  if (out.spacing_known) {
    out.pixel_down_mm = *down;
    out.pixel_across_mm = *across;
  }
  // Thick slices may overlap, thin ones may lie apart: their thickness is the second choice.
  const double between = real(set, DCM_SpacingBetweenSlices).value_or(0.0);
  out.stated_step_mm = between > 0.0 ? between : real(set, DCM_SliceThickness).value_or(0.0);
  const auto at = vector3(set, DCM_ImagePositionPatient, 0);
  const auto a = vector3(set, DCM_ImageOrientationPatient, 0), d = vector3(set, DCM_ImageOrientationPatient, 3);
  out.placed = at && a && d;
  if (out.placed) {
    out.first_mm = *at;
    out.across = *a;
    out.down = *d;
  }
  out.location_mm = real(set, DCM_SliceLocation);
  out.number = real(set, DCM_InstanceNumber).value_or(0.0);
  if (is_no_number(set, DCM_RescaleSlope)) return fail(ImportError::bad_header, name + " RescaleSlope");
  if (is_no_number(set, DCM_RescaleIntercept)) return fail(ImportError::bad_header, name + " RescaleIntercept");
  out.slope = real(set, DCM_RescaleSlope).value_or(1.0);
  out.intercept = real(set, DCM_RescaleIntercept).value_or(0.0);
  if (out.slope == 0.0) return fail(ImportError::bad_header, name + " RescaleSlope");
  return out;
}

/// A file that is no slice, by its fault, and the series that it names; empty if it names none.
struct DamagedSlice {
  std::string series;
  ImportFailure why;
};
DamagedSlice damaged_slice(const std::filesystem::path& file, const ImportFailure& why) {
  DcmFileFormat format;
  // What stands before the fault stays in the data set.
  static_cast<void>(format.loadFileUntilTag(file.c_str(), EXS_Unknown, EGL_noChange, 1024, ERM_autoDetect, DCM_PixelData));
  OFString text;
  const bool named = format.getDataset()->findAndGetOFString(DCM_SeriesInstanceUID, text).good();
  return {named ? std::string(text.c_str()) : std::string(), why};
}

bool is_skewed(const Slice& s) {
  return std::max({std::abs(glm::length(s.across) - 1.0), std::abs(glm::length(s.down) - 1.0), std::abs(glm::dot(s.across, s.down))}) > kSkew;
}

/// Slices of a series; 0 if none of them has an orientation that is one: another series of the folder goes first.
std::size_t usable_slices(const std::vector<Slice>& slices) { return std::ranges::all_of(slices, is_skewed) ? 0 : slices.size(); }

/// The slices that belong together: those of the given file's series, or the largest series of a folder.
Result<std::vector<Slice>, ImportFailure> slices_of(const std::filesystem::path& path, std::size_t& series,
                                                    const ImportProgress& progress) {
  const std::string name = path.filename().string();
  std::error_code ec;
  const bool folder = std::filesystem::is_directory(path, ec);
  std::optional<std::string> wanted;
  if (!folder) {
    const auto given = read_slice(path);
    if (!given) return std::unexpected(given.error());
    wanted = given->series;
    if (wanted->empty()) {
      series = 1;
      return std::vector<Slice>{*given};
    }
  }
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder ? path : path.parent_path(), ec)) {
    std::error_code of_entry;  // a link that leads nowhere is no slice, and the folder is read on
    if (!entry.is_regular_file(of_entry) || entry.file_size(of_entry) > kMaxFileBytes || !looks_like_dicom(entry.path())) continue;
    files.push_back(entry.path());
    if (files.size() > kMaxFiles)
      return fail(ImportError::too_large, name, text_of({LimitKind::file_count, static_cast<double>(files.size()), kMaxFiles}));
  }
  if (ec) return fail(ImportError::io, name, ec.message());
  if (!folder && std::ranges::none_of(files, [&](const auto& f) { return f.filename() == path.filename(); })) files.push_back(path);
  std::ranges::sort(files);  // so that what is read never hangs on the order in which a disk lists it
  std::map<std::string, std::vector<Slice>> all;
  std::optional<ImportFailure> first_failure;
  std::vector<DamagedSlice> damaged;
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (progress) progress(0.4 * static_cast<double>(i) / static_cast<double>(files.size()));
    auto slice = read_slice(files[i]);
    if (slice) {
      all[slice->series].push_back(std::move(*slice));
      continue;
    }
    if (!first_failure) first_failure = slice.error();
    if (slice.error().code != ImportError::unsupported) damaged.push_back(damaged_slice(files[i], slice.error()));
  }
  if (all.empty()) return std::unexpected(first_failure.value_or(ImportFailure{ImportError::unknown_format, name}));
  series = all.size();
  const auto chosen = wanted ? all.find(*wanted)
                             : std::ranges::max_element(all, {}, [](const auto& s) { return usable_slices(s.second); });
  if (chosen == all.end()) return fail(ImportError::corrupt, name);
  // Without its last slice a series looks whole.
  const auto of_it = std::ranges::find(damaged, chosen->first, &DamagedSlice::series);
  if (of_it != damaged.end() && !chosen->first.empty()) return std::unexpected(of_it->why);
  return std::move(chosen->second);
}

struct SliceStep {
  Vec3 mm{0.0};       // from one slice to the next
  bool known = true;  // the files hold its length
};

/// From the first place to the last in equal steps; a slice that is shifted in its plane is refused.
Result<SliceStep, ImportFailure> step_of_places(const std::vector<Slice>& slices, Vec3 normal) {
  const Slice& first = slices.front();
  const Vec3 step = (slices.back().first_mm - first.first_mm) / static_cast<double>(slices.size() - 1);
  const double limit = kAsidePixels * std::min(first.pixel_across_mm, first.pixel_down_mm);
  for (std::size_t i = 1; i < slices.size(); ++i) {
    const Vec3 off = slices[i].first_mm - first.first_mm - static_cast<double>(i) * step;
    if (glm::length(off - glm::dot(off, normal) * normal) > limit)
      return fail(ImportError::bad_spacing, slices[i].file.filename().string() + " ImagePositionPatient");
  }
  return SliceStep{step};
}

/// In order along the normal, evenly spaced, all alike; and the step from one to the next.
Result<SliceStep, ImportFailure> put_in_order(std::vector<Slice>& slices, const std::string& name) {
  const Slice& like = slices.front();
  const Vec3 normal = glm::cross(like.across, like.down);
  const bool placed = std::ranges::all_of(slices, &Slice::placed);
  const bool located = std::ranges::all_of(slices, [](const Slice& s) { return s.location_mm.has_value(); });
  const char* ordered_by = placed ? " ImagePositionPatient" : located ? " SliceLocation" : " InstanceNumber";
  for (Slice& s : slices) {
    if (s.placed != like.placed)
      return fail(ImportError::bad_header, (s.placed ? like : s).file.filename().string() + " ImagePositionPatient");
    if (placed && is_skewed(s)) return fail(ImportError::bad_orientation, s.file.filename().string() + " ImageOrientationPatient");
    if (s.rows != like.rows || s.columns != like.columns) return fail(ImportError::bad_sizes, s.file.filename().string() + " Rows");
    const Vec3 turned = glm::abs(s.across - like.across) + glm::abs(s.down - like.down);
    if (placed && turned.x + turned.y + turned.z > 1e-3)
      return fail(ImportError::bad_orientation, s.file.filename().string() + " ImageOrientationPatient");
    if (std::abs(s.pixel_across_mm - like.pixel_across_mm) + std::abs(s.pixel_down_mm - like.pixel_down_mm) > 1e-4)
      return fail(ImportError::bad_spacing, s.file.filename().string() + " PixelSpacing");
    s.along = placed ? glm::dot(s.first_mm, normal) : located ? *s.location_mm : s.number;
  }
  std::ranges::sort(slices, [](const Slice& a, const Slice& b) { return a.along != b.along ? a.along < b.along : a.file < b.file; });
  const double stated_mm = slices.front().stated_step_mm;
  const bool stated = stated_mm > 0.0 && std::ranges::all_of(slices, [&](const Slice& s) { return std::abs(s.stated_step_mm - stated_mm) <= kSameStep * stated_mm; });
  const SliceStep as_stated{normal * (stated ? stated_mm : 1.0), stated};
  if (slices.size() == 1) return as_stated;
  std::vector<double> steps;
  for (std::size_t i = 1; i < slices.size(); ++i) steps.push_back(slices[i].along - slices[i - 1].along);
  std::vector<double> sorted = steps;
  std::ranges::sort(sorted);
  const double usual = sorted[sorted.size() / 2];
  for (std::size_t i = 0; i < steps.size(); ++i) {
    // Two slices in one place, or one that is missing.
    if (!(usual > 0.0) || std::abs(steps[i] - usual) > kSameStep * usual + 1e-3)
      return fail(ImportError::bad_spacing, slices[i + 1].file.filename().string() + ordered_by, name);
  }
  if (placed) return step_of_places(slices, normal);
  if (located) return SliceStep{normal * ((slices.back().along - slices.front().along) / static_cast<double>(slices.size() - 1))};
  return as_stated;
}

constexpr float kNoNumber = std::numeric_limits<float>::quiet_NaN();

/// Stored words that fill up a picture and were never measured (PS3.3, C.7.5.1.1.2); none where the file names none.
struct Padding {
  std::int32_t least = 1, most = 0;
  bool holds(std::int32_t word) const noexcept { return word >= least && word <= most; }
};
Padding padding_of(DcmItem& set) {
  const bool is_signed = whole(set, DCM_PixelRepresentation).value_or(0) == 1;
  const auto word = [&](const DcmTagKey& key) -> std::optional<std::int32_t> {
    Sint16 as_signed = 0;
    const auto bits = set.findAndGetSint16(key, as_signed).good() ? static_cast<Uint16>(as_signed) : whole(set, key);
    if (!bits) return std::nullopt;
    return is_signed ? std::int32_t{static_cast<Sint16>(*bits)} : std::int32_t{*bits};
  };
  const auto value = word(DCM_PixelPaddingValue);
  if (!value) return {};
  const std::int32_t limit = word(DCM_PixelPaddingRangeLimit).value_or(*value);
  return {std::min(*value, limit), std::max(*value, limit)};
}

/// CT numbers of one slice into its layer; what is padding becomes no number.
Result<void, ImportFailure> pixels_of(const Slice& slice, const ImageLayout& layout, int k, std::vector<float>& value) {
  const std::string name = slice.file.filename().string();
  DcmFileFormat format;
  const OFCondition read = format.loadFile(slice.file.c_str(), EXS_Unknown, EGL_noChange);
  if (read.bad()) return fail(ImportError::corrupt, name, read.text());
  DcmDataset& set = *format.getDataset();
  if (slice.packed && set.chooseRepresentation(EXS_LittleEndianExplicit, nullptr).bad()) return fail(ImportError::corrupt, name + " PixelData");
  const unsigned allocated = whole(set, DCM_BitsAllocated).value_or(16);
  const unsigned stored = whole(set, DCM_BitsStored).value_or(static_cast<Uint16>(allocated));
  const bool is_signed = whole(set, DCM_PixelRepresentation).value_or(0) == 1;
  if ((allocated != 8 && allocated != 16) || stored == 0 || stored > allocated) return fail(ImportError::unsupported, name + " BitsAllocated");
  if (whole(set, DCM_HighBit).value_or(static_cast<Uint16>(stored - 1)) != stored - 1) return fail(ImportError::unsupported, name + " HighBit");
  const Uint16* words = nullptr;
  const Uint8* bytes = nullptr;
  unsigned long count = 0;
  const OFCondition got = allocated == 16 ? set.findAndGetUint16Array(DCM_PixelData, words, &count)
                                          : set.findAndGetUint8Array(DCM_PixelData, bytes, &count);
  const auto needed = static_cast<unsigned long>(slice.rows) * static_cast<unsigned long>(slice.columns);
  if (got.bad() || (!words && !bytes) || count < needed) return fail(ImportError::truncated, name);
  const std::int32_t sign = is_signed ? std::int32_t{1} << (stored - 1) : 0;
  const std::int32_t mask = static_cast<std::int32_t>((std::uint32_t{1} << stored) - 1);
  const Padding padding = padding_of(set);
  std::size_t i = 0;
  for (int y = 0; y < slice.rows; ++y)
    for (int x = 0; x < slice.columns; ++x, ++i) {
      // Whole words are compared: padding may need more bits than are stored of a measure.
      std::int32_t word = words ? words[i] : bytes[i];
      if (words && is_signed) word = static_cast<Sint16>(words[i]);
      std::int32_t raw = word & mask;
      if (raw & sign) raw -= 2 * sign;
      value[layout.place(x, y, k)] = padding.holds(word) ? kNoNumber : static_cast<float>(raw * slice.slope + slice.intercept);
    }
  return {};
}

Result<DicomSeries, ImportFailure> read(const std::filesystem::path& path, const VolumeLimits& limits, const ImportProgress& progress) {
  const std::string name = path.filename().string();
  DicomSeries out;
  auto slices = slices_of(path, out.series, progress);
  if (!slices) return std::unexpected(slices.error());
  out.slices = slices->size();
  const auto step = put_in_order(*slices, name);
  if (!step) return std::unexpected(step.error());
  const Slice& first = slices->front();
  const Vec3 ras(-1.0, -1.0, 1.0);
  const IVec3 size(first.columns, first.rows, static_cast<int>(slices->size()));
  const auto layout = lay_out(size, {ras * first.across * first.pixel_across_mm, ras * first.down * first.pixel_down_mm, ras * step->mm},
                              ras * first.first_mm, limits);
  if (!layout) {
    auto passed = passed_file_limit(size, limits);
    return fail(layout.error(), passed.empty() ? name + " ImagePositionPatient" : name, std::move(passed));
  }
  std::uintmax_t bytes = 0;  // that these files can hold of pixels
  std::error_code ec;
  for (const Slice& s : *slices) bytes += (s.packed ? kMostPacked : 1) * std::filesystem::file_size(s.file, ec);
  const auto voxels = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) * static_cast<std::size_t>(size.z);
  if (bytes < voxels) return fail(ImportError::truncated, name);
  out.image.layout = *layout;
  out.image.spacing_known = first.spacing_known && step->known;
  out.image.sides_known = first.placed;  // as put_in_order() has seen, all are or none is
  out.image.kind = ImageKind::grey;
  out.image.value.resize(voxels);
  for (std::size_t k = 0; k < slices->size(); ++k) {
    if (progress) progress(0.4 + 0.6 * static_cast<double>(k) / static_cast<double>(slices->size()));
    if (auto r = pixels_of((*slices)[k], *layout, static_cast<int>(k), out.image.value); !r) return std::unexpected(r.error());
  }
  if (const auto r = tidy_values(out.image); !r) return fail(r.error(), name);
  return out;
}

}  // namespace

bool looks_like_dicom(const std::filesystem::path& file) {
  std::error_code ec;
  if (!std::filesystem::is_regular_file(file, ec)) return false;  // a pipe would wait for its other end
  std::ifstream in(file, std::ios::binary);
  char head[132] = {};
  in.read(head, sizeof head);
  return in.gcount() == sizeof head && std::equal(head + 128, head + 132, "DICM");
}

Result<DicomSeries, ImportFailure> read_dicom(const std::filesystem::path& path, const VolumeLimits& limits,
                                              const ImportProgress& progress) {
  const std::string name = path.filename().string();
  // DCMTK logs what it meets, and that may be somebody's name.
  OFLog::configure(OFLogger::OFF_LOG_LEVEL);
  static const bool decoders = [] {
    DcmRLEDecoderRegistration::registerCodecs();
    DJDecoderRegistration::registerCodecs();
    return true;
  }();
  static_cast<void>(decoders);
  std::error_code ec;
  const auto status = std::filesystem::status(path, ec);
  if (!std::filesystem::exists(status)) return fail(ImportError::missing_file, name);
  if (!std::filesystem::is_regular_file(status) && !std::filesystem::is_directory(status)) return fail(ImportError::io, name);
  try {
    return read(path, limits, progress);
  } catch (const std::bad_alloc&) {
    return fail(ImportError::out_of_memory, name);
  } catch (const std::exception& e) {
    return fail(ImportError::corrupt, name, e.what());
  }
}

}  // namespace cusp::scenarios
