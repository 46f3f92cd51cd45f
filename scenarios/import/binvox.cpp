#include "scenarios/import/binvox.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <set>
#include <sstream>

#include "scenarios/import/header_text.h"
#include "scenarios/import/limit_figures.h"
#include "scenarios/import/packed_data.h"
#include "scenarios/import/whole_file.h"

namespace cusp::scenarios {
namespace {

constexpr std::size_t kMaxLine = 256;

/// One line of the header, without its end; nothing when it is too long or the file ends in it.
std::optional<std::string> line_of(std::istream& in) {
  std::string line;
  for (char c; in.get(c);) {
    if (c == '\n') {
      if (line.ends_with('\r')) line.pop_back();
      return line;
    }
    if (line.size() == kMaxLine) return std::nullopt;
    line += c;
  }
  return std::nullopt;
}

/// Places in [z][y][x] in the file's order: x slowest, then z, then y.
template <class Each>
void for_each_place(IVec3 size, Each each) {
  const auto nx = static_cast<std::size_t>(size.x), ny = static_cast<std::size_t>(size.y);
  for (std::size_t x = 0; x < nx; ++x)
    for (std::size_t z = 0; z < static_cast<std::size_t>(size.z); ++z)
      for (std::size_t y = 0; y < ny; ++y) each(x + nx * (y + ny * z));
}

/// Fills the values run by run; refuses runs that stop short of the last voxel or go past it.
Result<void, ImportError> read_runs(std::istream& in, Binvox& out) {
  std::size_t left = 0;
  char value = 0;
  bool short_of = false;
  for_each_place(out.size, [&](std::size_t place) {
    while (left == 0 && !short_of) {
      char count = 0;
      if (!in.get(value) || !in.get(count)) short_of = true;
      else left = static_cast<unsigned char>(count);
    }
    if (short_of) return;
    out.value[place] = static_cast<std::uint8_t>(value);
    --left;
  });
  if (short_of) return std::unexpected(in.bad() ? ImportError::io : ImportError::truncated);
  if (left > 0) return std::unexpected(ImportError::corrupt);
  return {};
}

}  // namespace

Result<Binvox, ImportFailure> read_binvox(std::istream& in, std::uintmax_t bytes, const std::string& name,
                                          const VolumeLimits& limits) {
  auto line = line_of(in);
  if (!line || !line->starts_with("#binvox")) return fail(ImportError::unknown_format, name);
  if (trimmed(line->substr(7)) != "1") return fail(ImportError::unsupported, name + ":1");
  Binvox out;
  bool sized = false;
  std::set<std::string, std::less<>> keys;
  for (int at = 2;; ++at) {
    const auto where = [&] { return name + ":" + std::to_string(at); };
    line = line_of(in);
    if (!line) return fail(in.eof() ? ImportError::truncated : ImportError::bad_header, where());
    const auto word = tokens(*line);
    if (word.empty() || word[0].starts_with('#')) continue;
    if (word[0] == "data") break;
    if (!keys.emplace(word[0]).second) return fail(ImportError::bad_header, where(), "twice");
    std::array<double, 3> numbers{};
    const std::size_t wanted = word[0] == "scale" ? 1 : 3;
    if (word.size() != wanted + 1) return fail(ImportError::bad_header, where());
    for (std::size_t i = 0; i < wanted; ++i) {
      const auto n = number(word[i + 1]);
      if (!n || !std::isfinite(*n)) return fail(ImportError::bad_header, where());
      numbers[i] = *n;
    }
    if (word[0] == "dim") {
      for (const double n : numbers)
        if (!(n >= 1.0) || n != std::floor(n)) return fail(ImportError::bad_sizes, where());
      if (auto passed = passed_file_limit({numbers[0], numbers[1], numbers[2]}, limits); !passed.empty())
        return fail(ImportError::too_large, where(), std::move(passed));
      // Depth, height, width: along x, z and y.
      out.size = {static_cast<int>(numbers[0]), static_cast<int>(numbers[2]), static_cast<int>(numbers[1])};
      sized = true;
    } else if (word[0] == "translate") {
      out.translate = {numbers[0], numbers[1], numbers[2]};
    } else if (word[0] == "scale") {
      if (!(numbers[0] > 0.0)) return fail(ImportError::bad_spacing, where());
      out.scale = numbers[0];
    } else {
      return fail(ImportError::bad_header, where());
    }
  }
  if (!sized) return fail(ImportError::bad_sizes, name + " dim");
  const std::size_t voxels = static_cast<std::size_t>(out.size.x) * static_cast<std::size_t>(out.size.y) *
                             static_cast<std::size_t>(out.size.z);
  // Two bytes hold at most 255 voxels.
  if (!data_can_be_there(in, {bytes, (voxels + 254) / 255 * 2}, Packing::raw)) return fail(ImportError::truncated, name);
  out.value.resize(voxels);
  if (const auto r = read_runs(in, out); !r) return fail(r.error(), name);
  return out;
}

Result<Binvox, ImportFailure> read_binvox(const std::filesystem::path& file, const VolumeLimits& limits) {
  std::ifstream in;
  const auto bytes = open_volume_file(file, in);
  if (!bytes) return std::unexpected(bytes.error());
  return read_binvox(in, *bytes, file.filename().string(), limits);
}

Result<void, ImportFailure> write_binvox(const Binvox& what, const std::filesystem::path& file) {
  const std::string name = file.filename().string();
  const auto voxels = static_cast<std::size_t>(what.size.x) * static_cast<std::size_t>(what.size.y) *
                      static_cast<std::size_t>(what.size.z);
  if (what.size.x < 1 || what.size.y < 1 || what.size.z < 1 || what.value.size() != voxels)
    return fail(ImportError::bad_sizes, name);
  std::string bytes = "#binvox 1\ndim " + std::to_string(what.size.x) + " " + std::to_string(what.size.z) + " " +
                      std::to_string(what.size.y) + "\ntranslate " + exact(what.translate.x) + " " +
                      exact(what.translate.y) + " " + exact(what.translate.z) + "\nscale " + exact(what.scale) + "\ndata\n";
  std::uint8_t value = 0;
  unsigned run = 0;
  const auto end_run = [&] {
    if (run == 0) return;
    bytes += static_cast<char>(value);
    bytes += static_cast<char>(run);
    run = 0;
  };
  for_each_place(what.size, [&](std::size_t place) {
    if (run == 255 || (run > 0 && what.value[place] != value)) end_run();
    value = what.value[place];
    ++run;
  });
  end_run();
  if (auto done = write_whole_file(file, bytes); !done) return fail(ImportError::io, name, done.error().message());
  return {};
}

Result<Image, ImportFailure> image_of(const Binvox& what, const std::string& name, const VolumeLimits& limits) {
  const double voxel = what.scale / std::max({what.size.x, what.size.y, what.size.z});
  const auto layout = lay_out(what.size, {Vec3(voxel, 0, 0), Vec3(0, voxel, 0), Vec3(0, 0, voxel)},
                              what.translate + 0.5 * voxel, limits);
  if (!layout) return fail(layout.error(), name);
  Image out;
  out.layout = *layout;
  out.kind = ImageKind::labels;
  out.spacing_known = false;
  out.value.assign(what.value.begin(), what.value.end());
  if (kind_of_values(out.value) != ImageKind::labels) out.kind = ImageKind::grey;
  return out;
}

Binvox binvox_of(const VoxelVolume& volume) {
  const Grid& g = volume.grid;
  Binvox out;
  out.size = g.size;
  out.scale = g.voxel_mm * std::max({g.size.x, g.size.y, g.size.z});
  out.translate = g.origin_mm - 0.5 * g.voxel_mm;
  out.value.resize(volume.s.size());
  for (std::size_t i = 0; i < out.value.size(); ++i) out.value[i] = volume.s[i] >= kHalf ? 1 : 0;
  return out;
}

}  // namespace cusp::scenarios
