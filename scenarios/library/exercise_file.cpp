#include "scenarios/library/exercise_file.h"

#include <algorithm>
#include <fstream>
#include <optional>
#include <spanstream>
#include <system_error>

#include "scenarios/format/content_hash.h"
#include "scenarios/format/read.h"
#include "scenarios/format/write.h"
#include "scenarios/import/nrrd.h"
#include "scenarios/import/whole_file.h"
#include "scenarios/library/tar.h"
#include "scenarios/specimens/taken_codes.h"

namespace cusp::scenarios {
namespace {

constexpr std::string_view kMark = "cusp-exercise", kScenario = "scenario.json";
constexpr std::size_t kMostEntries = 3;

template <class T>
using Read = Result<T, ExerciseFileFailure>;

std::unexpected<ExerciseFileFailure> refuse(FormatError code, std::string_view where, std::string detail = {}) {
  return std::unexpected(ExerciseFileFailure(FormatFailure{code, std::string(where), std::move(detail)}));
}

std::string mark_text(const ContentHash& content) {
  return "format " + std::to_string(kExerciseFileFormat) + "\ncontent " + content.hex() + '\n';
}

ContentHash content_of(const Scenario& scenario, const std::vector<std::byte>& volume) {
  if (!scenario.specimen.generator.empty()) return content_hash(scenario);
  return content_hash(scenario, {{scenario.specimen.volume, volume}});
}

std::string_view view_of(const std::vector<std::byte>& bytes) { return {reinterpret_cast<const char*>(bytes.data()), bytes.size()}; }

/// The content hash that the mark names, as hex digits.
Read<std::string> content_named(std::string_view mark) {
  constexpr std::string_view format = "format ", content = "\ncontent ";
  constexpr std::size_t hex = 64;
  if (!mark.starts_with(format)) return refuse(FormatError::foreign_file, kMark);
  mark.remove_prefix(format.size());
  const std::size_t digits = std::min(mark.find_first_not_of("0123456789"), mark.size());
  const std::string number(mark.substr(0, digits));
  if (number != std::to_string(kExerciseFileFormat)) return refuse(FormatError::newer_format, kMark, number);
  mark.remove_prefix(digits);
  if (!mark.starts_with(content) || mark.size() != content.size() + hex + 1 || mark.back() != '\n')
    return refuse(FormatError::damaged, kMark);
  return std::string(mark.substr(content.size(), hex));
}

void put_name_first(ExerciseFileFailure& failure, const std::filesystem::path& path) {
  if (auto* format = std::get_if<FormatFailure>(&failure))
    format->where = path.filename().string() + (format->where.empty() ? "" : "#" + format->where);
}

}  // namespace

bool names_exercise_file(std::string_view name) noexcept {
  const auto small = [](char c) noexcept { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
  return name.size() >= kExerciseFileSuffix.size() &&
         std::ranges::equal(name.substr(name.size() - kExerciseFileSuffix.size()), kExerciseFileSuffix, {}, small);
}

Result<void, ExerciseFileFailure> check_exercise_file(const ExerciseFile& file) {
  std::optional<SpecimenFacts> facts;
  if (file.scenario.specimen.generator.empty()) {
    const auto volume = voxels_of(file);
    if (!volume) return std::unexpected(ExerciseFileFailure(volume.error()));
    if (auto taken = refuse_taken_codes(*volume, file.scenario.specimen.volume)) return std::unexpected(ExerciseFileFailure(std::move(*taken)));
    facts = facts_of(*volume);
  }
  std::vector<Finding> findings = validate(file.scenario, facts ? &*facts : nullptr);
  if (has_error(findings)) return std::unexpected(ExerciseFileFailure(std::move(findings.front())));  // errors come first
  return {};
}

Result<std::string, ExerciseFileFailure> exercise_file_bytes(const ExerciseFile& file) {
  Scenario scenario = file.scenario;
  scenario.specimen.volume = tar_name(scenario.specimen.volume);
  const std::string mark = mark_text(content_of(scenario, file.volume)), json = canonical_json(scenario);
  std::vector<TarEntry> entries = {{std::string(kMark), mark}, {std::string(kScenario), json}};
  if (scenario.specimen.generator.empty()) entries.push_back({scenario.specimen.volume, view_of(file.volume)});
  std::string bytes = write_tar(entries);
  if (bytes.size() > kMaxExerciseFileBytes) return refuse(FormatError::too_large, file.scenario.specimen.volume);
  return bytes;
}

Result<void, ExerciseFileFailure> write_exercise_file(const ExerciseFile& file, const std::filesystem::path& path) {
  const auto bytes = exercise_file_bytes(file);
  if (!bytes) return std::unexpected(bytes.error());
  if (auto done = write_whole_file(path, *bytes); !done) {
    return refuse(FormatError::unwritable, path.filename().string(), done.error().message());
  }
  return {};
}

Result<ExerciseFile, ExerciseFileFailure> parse_exercise_file(std::string_view bytes) {
  if (bytes.size() > kMaxExerciseFileBytes) return refuse(FormatError::too_large, {});
  const auto entries = read_tar(bytes, kMostEntries);
  if (!entries) return std::unexpected(ExerciseFileFailure(entries.error()));
  if (entries->front().name != kMark) return refuse(FormatError::foreign_file, entries->front().name);
  const auto content = content_named(entries->front().data);
  if (!content) return std::unexpected(content.error());
  if (entries->size() < 2 || (*entries)[1].name != kScenario) return refuse(FormatError::missing_file, kScenario);
  auto scenario = read_scenario((*entries)[1].data);
  if (!scenario) return std::unexpected(ExerciseFileFailure(scenario.error()));
  ExerciseFile out{std::move(*scenario), {}};
  const bool with_volume = out.scenario.specimen.generator.empty();
  if (with_volume && entries->size() < 3) return refuse(FormatError::missing_file, out.scenario.specimen.volume);
  if (entries->size() == 3) {
    const TarEntry& last = entries->back();
    if (!with_volume || last.name != out.scenario.specimen.volume) return refuse(FormatError::unnamed_file, last.name);
    const auto* first = reinterpret_cast<const std::byte*>(last.data.data());
    out.volume.assign(first, first + last.data.size());
  }
  if (content_of(out.scenario, out.volume).hex() != *content) return refuse(FormatError::damaged, {});
  if (auto fits = check_exercise_file(out); !fits) return std::unexpected(fits.error());
  return out;
}

Result<VoxelVolume, ImportFailure> voxels_of(const ExerciseFile& file) {
  const std::string_view bytes = view_of(file.volume);
  std::ispanstream in(std::span(bytes.data(), bytes.size()));
  return read_nrrd(in, bytes.size(), file.scenario.specimen.volume);
}

Result<ExerciseFile, ExerciseFileFailure> read_exercise_file(const std::filesystem::path& path) {
  const std::string name = path.filename().string();
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return refuse(FormatError::unreadable, name);
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error) return refuse(FormatError::unreadable, name, error.message());
  if (size > kMaxExerciseFileBytes) return refuse(FormatError::too_large, name);
  std::ifstream in(path, std::ios::binary);
  std::string bytes(static_cast<std::size_t>(size), '\0');
  in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (!in) return refuse(FormatError::unreadable, name);
  auto file = parse_exercise_file(bytes);
  if (!file) put_name_first(file.error(), path);
  return file;
}

}  // namespace cusp::scenarios
