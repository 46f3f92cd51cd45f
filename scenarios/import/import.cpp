#include "scenarios/import/import.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <new>
#include <exception>
#include <set>

#include "scenarios/import/mesh_distance.h"
#include "scenarios/import/triangle_mesh.h"

namespace cusp {
namespace {

std::string short_text(double value) {
  char buffer[32];
  return {buffer, std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::general, 6).ptr};
}
/// In the file's axes, as another program shows it, but in millimetres.
std::string place(Vec3 at) { return " (" + short_text(at.x) + "," + short_text(at.y) + "," + short_text(at.z) + ")"; }

Result<void, ImportFailure> check_options(const MeshImport& what) {
  if (!(what.unit_mm > 0.0) || !std::isfinite(what.unit_mm)) return fail(ImportError::bad_option, "unit-mm");
  if (what.mend_holes_mm && !(*what.mend_holes_mm >= 0.0)) return fail(ImportError::bad_option, "mend-holes-mm");
  if (!(what.voxel_mm >= what.limits.min_voxel_mm && what.voxel_mm <= what.limits.max_voxel_mm))
    return fail(ImportError::bad_option, "voxel-mm");
  if (what.tissues.empty()) return fail(ImportError::no_mesh, what.path.filename().string());
  std::set<std::string> names;
  for (const auto& [name, tissue] : what.tissues) {
    if (!names.insert(name).second) return fail(ImportError::bad_option, "tissue " + name);
    if (tissue == Tissue::empty || index_of(tissue) >= kTissueCodes)
      return fail(ImportError::bad_tissue, "tissue " + name);
  }
  return {};
}

struct Part {
  TriangleMesh mesh;  // specimen frame, mm
  Tissue tissue = Tissue::empty;
  MeshCheck checked;
};

/// All meshes, each under a name that is its own.
Result<std::vector<TriangleMesh>, ImportFailure> read_files(const std::filesystem::path& path,
                                                            const std::vector<std::filesystem::path>& more) {
  auto all = read_meshes(path);
  if (!all || more.empty()) return all;
  std::set<std::string> taken;
  const auto name_them = [&](std::vector<TriangleMesh>& meshes, const std::filesystem::path& file) {
    for (TriangleMesh& m : meshes) {
      const std::string name = meshes.size() == 1 ? file.stem().string() : file.stem().string() + ": " + m.name;
      m.name = name;
      for (int n = 2; !taken.insert(m.name).second; ++n) m.name = name + " (" + std::to_string(n) + ")";
    }
  };
  name_them(*all, path);
  for (const std::filesystem::path& file : more) {
    auto next = read_meshes(file);
    if (!next) return next;
    name_them(*next, file);
    for (TriangleMesh& m : *next) all->push_back(std::move(m));
  }
  return all;
}

void mend(TriangleMesh& mesh, const MeshImport& what, std::vector<ImportRemark>* remarks) {
  const MeshRepair done = repair(mesh, *what.mend_holes_mm / what.unit_mm);
  if (!remarks) return;
  const auto say = [&](RemarkCode code, std::size_t count, std::vector<double> more = {}) {
    if (count == 0) return;
    more.insert(more.begin(), static_cast<double>(count));
    remarks->push_back({code, mesh.name, std::move(more)});
  };
  say(RemarkCode::points_joined, done.points_joined);
  say(RemarkCode::triangles_dropped, done.triangles_dropped);
  say(RemarkCode::triangles_turned, done.triangles_turned);
  say(RemarkCode::holes_closed, done.holes_closed, {done.widest_hole * what.unit_mm});
}

/// Where the widest gap is; how many there are and how wide the first ones, for the log.
std::unexpected<ImportFailure> refuse_open(const TriangleMesh& mesh, const MeshCheck& in_file, const MeshImport& what) {
  const std::vector<MeshGap> gaps = gaps_of(mesh);
  const Vec3 at = gaps.empty() ? in_file.bad_edge : gaps.front().middle();
  std::string detail = std::to_string(gaps.size());
  for (std::size_t i = 0; i < std::min(gaps.size(), kMaxGapsTold); ++i)
    detail += (i == 0 ? ": " : ", ") + short_text(gaps[i].width() * what.unit_mm) + " mm";
  return fail(ImportError::mesh_open, mesh.name + place(at * what.unit_mm), std::move(detail));
}

/// The chosen meshes, checked, those of more volume first: what contains another comes before it.
Result<std::vector<Part>, ImportFailure> choose(std::vector<TriangleMesh> meshes, const MeshImport& what,
                                                std::vector<ImportRemark>* remarks) {
  std::vector<Part> parts;
  for (const auto& [name, tissue] : what.tissues) {
    const auto it = std::ranges::find(meshes, name, &TriangleMesh::name);
    if (it == meshes.end()) return fail(ImportError::mesh_not_found, name);
    Part part{std::move(*it), tissue, {}};
    it->name.clear();
    if (part.mesh.triangles.empty()) return fail(ImportError::mesh_empty, name);
    if (what.mend_holes_mm) mend(part.mesh, what, remarks);
    const MeshCheck in_file = check(part.mesh);
    if (!in_file.closed) return refuse_open(part.mesh, in_file, what);
    if (!in_file.oriented) return fail(ImportError::mesh_not_oriented, name + place(in_file.bad_edge * what.unit_mm));
    for (Vec3& p : part.mesh.points) p = turned_up(p, what.up) * what.unit_mm;
    part.checked = check(part.mesh);
    if (!std::isfinite(part.checked.volume)) return fail(ImportError::too_large, what.path.filename().string());
    if (part.checked.volume == 0.0) return fail(ImportError::mesh_empty, name);
    parts.push_back(std::move(part));
  }
  std::ranges::sort(parts, [](const Part& a, const Part& b) {
    const double va = std::abs(a.checked.volume), vb = std::abs(b.checked.volume);
    return va != vb ? va > vb : a.mesh.name < b.mesh.name;
  });
  return parts;
}

/// Voxel centres at odd multiples of half a voxel, kPadVoxels about the box of all parts.
Result<Grid, ImportFailure> grid_about(const std::vector<Part>& parts, const MeshImport& what) {
  Vec3 low = parts.front().checked.low, high = parts.front().checked.high;
  for (const Part& p : parts) {
    low = glm::min(low, p.checked.low);
    high = glm::max(high, p.checked.high);
  }
  const Vec3 first = glm::floor(low / what.voxel_mm) - double{kPadVoxels};
  const Vec3 size = glm::ceil(high / what.voxel_mm) + double{kPadVoxels} - first;
  const double edge = std::max({size.x, size.y, size.z});
  if (!(edge <= what.limits.max_edge_voxels) ||
      !(size.x * size.y * size.z <= static_cast<double>(what.limits.max_voxels)))
    return fail(ImportError::too_large, what.path.filename().string(),
                short_text(size.x) + " x " + short_text(size.y) + " x " + short_text(size.z) + " voxels");
  Grid grid;
  grid.voxel_mm = what.voxel_mm;
  grid.size = IVec3(size);
  grid.origin_mm = (first + 0.5) * what.voxel_mm;
  return grid;
}

/// Share of a voxel at this distance that is inside, for a face across it.
double coverage(float distance) noexcept { return std::clamp(0.5 - static_cast<double>(distance), 0.0, 1.0); }

/// The piece of `grid` about a shell, with its first voxel's place in `grid`.
struct Piece {
  Grid grid;
  IVec3 first{0};
};
Piece piece_about(const MeshCheck& shell, const Grid& grid) {
  Piece out{grid, IVec3(glm::floor((shell.low - grid.origin_mm) / grid.voxel_mm)) - kDistanceReach};
  out.first = glm::max(out.first, IVec3(0));
  const IVec3 last = IVec3(glm::ceil((shell.high - grid.origin_mm) / grid.voxel_mm)) + kDistanceReach;
  out.grid.size = glm::min(last, grid.size - 1) - out.first + 1;
  out.grid.origin_mm = grid.centre_mm(out.first);
  return out;
}

/// Calls each(index in grid, s of the shell) about a shell. False when what it encloses is not what its triangles say:
/// it has turned itself inside out somewhere. A face is off by at most a tenth of a voxel, a small shell by two per cent.
template <class Each>
bool for_each_voxel(const TriangleMesh& shell, const Grid& grid, const ImportProgress& progress, Each each) {
  const MeshCheck c = check(shell);
  const Piece piece = piece_about(c, grid);
  const std::vector<float> d = mesh_distance(shell, piece.grid, progress);
  double voxels = 0.0;
  std::size_t i = 0;
  for (int z = 0; z < piece.grid.size.z; ++z)
    for (int y = 0; y < piece.grid.size.y; ++y) {
      std::size_t to = grid.index(piece.first + IVec3(0, y, z));
      for (int x = 0; x < piece.grid.size.x; ++x, ++i, ++to) {
        voxels += coverage(d[i]);
        each(to, solid_from_distance(static_cast<double>(d[i])));
      }
    }
  const double v = grid.voxel_mm;
  return std::abs(voxels * v * v * v - std::abs(c.volume)) <= 0.02 * std::abs(c.volume) + 0.1 * c.area * v;
}

/// s of one part alone: its solids less its cavities.
Result<void, ImportFailure> solids_of(const Part& part, const Grid& grid, std::vector<std::uint16_t>& s,
                                      const ImportProgress& progress) {
  const std::string& name = part.mesh.name;
  const Shells shells = shells_of(part.mesh);
  const auto all = static_cast<double>(part.mesh.triangles.size());
  double before = 0.0;
  const auto share_of = [&](const TriangleMesh& shell) {
    const double first = before / all, wide = static_cast<double>(shell.triangles.size()) / all;
    before += static_cast<double>(shell.triangles.size());
    return [&progress, first, wide](double share) { progress(first + wide * share); };
  };
  std::ranges::fill(s, std::uint16_t{0});
  for (const TriangleMesh& shell : shells.solids) {
    if (!for_each_voxel(shell, grid, share_of(shell), [&](std::size_t i, std::uint16_t solid) { s[i] = std::max(s[i], solid); }))
      return fail(ImportError::mesh_ambiguous, name);
  }
  bool within = true;
  for (const TriangleMesh& shell : shells.cavities) {
    const bool sound = for_each_voxel(shell, grid, share_of(shell), [&](std::size_t i, std::uint16_t hollow) {
      within &= hollow != kSolid || s[i] != 0;
      s[i] = std::min(s[i], static_cast<std::uint16_t>(kSolid - hollow));
    });
    if (!sound || !within) return fail(ImportError::mesh_ambiguous, name);
  }
  if (std::ranges::none_of(s, [](std::uint16_t v) { return v >= kHalf; })) return fail(ImportError::nothing_solid, name);
  return {};
}

/// Lays a part over those before it: it wins where it is, and where it is the nearest.
void lay(const std::vector<std::uint16_t>& s, Tissue tissue, VoxelVolume& volume) {
  for (std::size_t i = 0; i < s.size(); ++i) {
    if (s[i] >= kHalf || (volume.s[i] < kHalf && s[i] > volume.s[i])) volume.tissue[i] = tissue;
    volume.s[i] = std::max(volume.s[i], s[i]);
  }
}

}  // namespace

double guessed_unit_mm(double longest) noexcept {
  constexpr double tooth = 4.0, jaw = 200.0;
  for (const double unit : kUsualUnitsMm) {
    if (longest * unit >= tooth && longest * unit <= jaw) return unit;
  }
  return 1.0;
}

Result<std::vector<MeshInfo>, ImportFailure> list_meshes(const std::filesystem::path& path,
                                                         const std::vector<std::filesystem::path>& more) {
  const auto meshes = read_files(path, more);
  if (!meshes) return std::unexpected(meshes.error());
  std::vector<MeshInfo> out;
  for (const TriangleMesh& m : *meshes) {
    const MeshCheck c = check(m);
    MeshInfo info{m.name, m.triangles.size(), c.low, c.high, std::abs(c.volume), c.closed, c.oriented, {}, 0, {}};
    if (!c.closed) {
      info.gaps = gaps_of(m);
      info.gap_count = info.gaps.size();
      if (info.gaps.size() > kMaxGapsTold) info.gaps.resize(kMaxGapsTold);
    } else if (!c.oriented) {
      info.turned_at = c.bad_edge;
    }
    out.push_back(std::move(info));
  }
  return out;
}

Result<VoxelVolume, ImportFailure> import_mesh(const MeshImport& what, const ImportProgress& progress,
                                               std::vector<ImportRemark>* remarks) {
  const auto report = [&](double share) {
    if (progress) progress(share);
  };
  if (auto r = check_options(what); !r) return std::unexpected(r.error());
  report(0.0);
  auto meshes = read_files(what.path, what.more);
  if (!meshes) return std::unexpected(meshes.error());
  report(0.2);
  const auto parts = choose(std::move(*meshes), what, remarks);
  if (!parts) return std::unexpected(parts.error());
  const auto grid = grid_about(*parts, what);
  if (!grid) return std::unexpected(grid.error());
  try {
    VoxelVolume out(*grid);
    std::vector<std::uint16_t> s(grid->voxels());
    for (std::size_t i = 0; i < parts->size(); ++i) {
      const double wide = 0.7 / static_cast<double>(parts->size()), first = 0.3 + wide * static_cast<double>(i);
      report(first);
      if (auto r = solids_of((*parts)[i], *grid, s, [&](double share) { report(first + wide * share); }); !r) return std::unexpected(r.error());
      lay(s, (*parts)[i].tissue, out);
    }
    report(1.0);
    return out;
  } catch (const std::bad_alloc&) {
    return fail(ImportError::out_of_memory, what.path.filename().string());
  } catch (const std::exception& e) {
    return fail(ImportError::mesh_ambiguous, what.path.filename().string(), e.what());
  }
}

}  // namespace cusp
