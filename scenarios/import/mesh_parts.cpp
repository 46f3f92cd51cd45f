#include "scenarios/import/mesh_parts.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "scenarios/import/limit_figures.h"
#include "scenarios/import/mesh_distance.h"

namespace cusp::scenarios {
namespace {

std::string short_text(double value) {
  char buffer[32];
  return {buffer, std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::general, 6).ptr};
}
/// In the file's axes, as another program shows it, but in millimetres.
std::string place(Vec3 at) { return " (" + short_text(at.x) + "," + short_text(at.y) + "," + short_text(at.z) + ")"; }

/// Share of a mesh's own area from which a cap makes a shell of it: a speck that a scanner missed is far smaller, the open
/// end of a crown far larger.
constexpr double kShellShare = 0.02;

/// Mends a part in the file's units; what was done to it.
void mend(MeshPart& part, const MeshImport& what, std::vector<ImportRemark>& remarks) {
  const MeshRepair done = repair(part.mesh, *what.mend_holes_mm / what.unit_mm);
  part.first_cap = part.mesh.triangles.size() - done.cap_triangles;
  const auto report = [&](RemarkCode code, std::size_t count, std::vector<double> more = {}) {
    if (count == 0) return;
    more.insert(more.begin(), static_cast<double>(count));
    remarks.push_back({code, part.mesh.name, std::move(more)});
  };
  report(RemarkCode::points_joined, done.points_joined);
  report(RemarkCode::triangles_dropped, done.triangles_dropped);
  report(RemarkCode::triangles_turned, done.triangles_turned);
  report(RemarkCode::holes_closed, done.holes_closed, {done.widest_hole * what.unit_mm});
  const double mm2 = what.unit_mm * what.unit_mm;
  if (done.largest_cap > kShellShare * done.own_area)
    remarks.push_back({RemarkCode::shell_capped, part.mesh.name, {done.cap_area * mm2, done.cap_area / done.own_area, static_cast<double>(index_of(part.tissue))}});
}

/// Where the widest gap is; how many there are and how wide the first ones, for the log.
std::unexpected<ImportFailure> refuse_open(const TriangleMesh& mesh, const MeshCheck& in_file, const MeshImport& what) {
  const std::vector<MeshGap> gaps = gaps_of(mesh);
  const Vec3 at = gaps.empty() ? in_file.bad_edge : gaps.front().middle();
  std::string detail = std::to_string(gaps.size());
  for (std::size_t i = 0; i < std::min(gaps.size(), kMaxGapsListed); ++i)
    detail += (i == 0 ? ": " : ", ") + short_text(gaps[i].width() * what.unit_mm) + " mm";
  return fail(ImportError::mesh_open, mesh.name + place(at * what.unit_mm), std::move(detail));
}

}  // namespace

Result<std::vector<MeshPart>, ImportFailure> choose_parts(std::vector<TriangleMesh> meshes, const MeshImport& what,
                                                          std::vector<ImportRemark>& remarks) {
  std::vector<MeshPart> parts;
  for (const auto& [name, tissue] : what.tissues) {
    const auto it = std::ranges::find(meshes, name, &TriangleMesh::name);
    if (it == meshes.end()) return fail(ImportError::mesh_not_found, name);
    MeshPart part{std::move(*it), tissue, {}, 0, {}};
    it->name.clear();
    if (part.mesh.triangles.empty()) return fail(ImportError::mesh_empty, name);
    part.first_cap = part.mesh.triangles.size();
    if (what.mend_holes_mm) mend(part, what, remarks);
    const MeshCheck in_file = check(part.mesh);
    if (!in_file.closed) return refuse_open(part.mesh, in_file, what);
    if (!in_file.oriented) return fail(ImportError::mesh_not_oriented, name + place(in_file.bad_edge * what.unit_mm));
    if (const auto turned = turned_outside(part.mesh); !turned.empty())
      part.turned_at = place(middle_of(part.mesh, turned.front()) * what.unit_mm);
    for (Vec3& p : part.mesh.points) p = turned_up(p, what.up) * what.unit_mm;
    part.checked = check(part.mesh);
    if (!std::isfinite(part.checked.volume)) return fail(ImportError::too_large, what.path.filename().string());
    if (part.checked.volume == 0.0 && !part.turned_at.empty()) return fail(ImportError::mesh_not_oriented, name + part.turned_at);
    if (part.checked.volume == 0.0) return fail(ImportError::mesh_empty, name);
    if (part.checked.volume < 0.0) remarks.push_back({RemarkCode::inside_out, name});
    parts.push_back(std::move(part));
  }
  return parts;
}

Result<Grid, ImportFailure> grid_about(const std::vector<MeshPart>& parts, const MeshImport& what) {
  Vec3 low = parts.front().checked.low, high = parts.front().checked.high;
  for (const MeshPart& p : parts) {
    low = glm::min(low, p.checked.low);
    high = glm::max(high, p.checked.high);
  }
  const Vec3 first = glm::floor(low / what.voxel_mm) - double{kPadVoxels};
  const Vec3 size = glm::ceil(high / what.voxel_mm) + double{kPadVoxels} - first;
  if (const auto passed = passed_limit(size, high - low, what.voxel_mm, what.limits))
    return fail(ImportError::too_large, what.path.filename().string(), text_of(*passed));
  Grid grid;
  grid.voxel_mm = what.voxel_mm;
  grid.size = IVec3(size);
  grid.origin_mm = (first + 0.5) * what.voxel_mm;
  return grid;
}

namespace {

/// Share of a voxel at this distance that is inside, for a face across it.
double coverage(float distance) noexcept { return std::clamp(0.5 - static_cast<double>(distance), 0.0, 1.0); }

/// The part of `grid` about a shell, with its first voxel's place in `grid`.
struct Subgrid {
  Grid grid;
  IVec3 first{0};
};
Subgrid subgrid_about(const MeshCheck& shell, const Grid& grid) {
  Subgrid out{grid, IVec3(glm::floor((shell.low - grid.origin_mm) / grid.voxel_mm)) - kDistanceReach};
  out.first = glm::max(out.first, IVec3(0));
  const IVec3 last = IVec3(glm::ceil((shell.high - grid.origin_mm) / grid.voxel_mm)) + kDistanceReach;
  out.grid.size = glm::min(last, grid.size - 1) - out.first + 1;
  out.grid.origin_mm = grid.centre_mm(out.first);
  return out;
}

/// Calls each(index in grid, s of the shell) about a shell. False if the voxels' volume differs from the triangles': the
/// shell is inside out somewhere. A face is off by at most a tenth of a voxel, a small shell by two per cent.
template <class Each>
bool for_each_voxel(const TriangleMesh& shell, const Grid& grid, const ImportProgress& progress, Each each) {
  const MeshCheck c = check(shell);
  const Subgrid box = subgrid_about(c, grid);
  const std::vector<float> d = mesh_distance(shell, box.grid, progress);
  double voxels = 0.0;
  std::size_t i = 0;
  for (int z = 0; z < box.grid.size.z; ++z)
    for (int y = 0; y < box.grid.size.y; ++y) {
      std::size_t to = grid.index(box.first + IVec3(0, y, z));
      for (int x = 0; x < box.grid.size.x; ++x, ++i, ++to) {
        voxels += coverage(d[i]);
        each(to, solid_from_distance(static_cast<double>(d[i])));
      }
    }
  const double v = grid.voxel_mm;
  return std::abs(voxels * v * v * v - std::abs(c.volume)) <= 0.02 * std::abs(c.volume) + 0.1 * c.area * v;
}

}  // namespace

Result<PartField, ImportFailure> field_of(const MeshPart& part, const Grid& grid, const ImportProgress& progress) {
  const std::string& name = part.mesh.name;
  const Subgrid box = subgrid_about(part.checked, grid);
  PartField out{box.first, box.grid.size, std::vector<std::uint16_t>(box.grid.voxels())};
  std::vector<std::uint16_t>& s = out.s;
  const Shells shells = shells_of(part.mesh);
  const auto all = static_cast<double>(part.mesh.triangles.size());
  double before = 0.0;
  const auto share_of = [&](const TriangleMesh& shell) {
    const double first = before / all, wide = static_cast<double>(shell.triangles.size()) / all;
    before += static_cast<double>(shell.triangles.size());
    return [&progress, first, wide](double share) { progress(first + wide * share); };
  };
  for (const TriangleMesh& shell : shells.solids) {
    if (!for_each_voxel(shell, box.grid, share_of(shell), [&](std::size_t i, std::uint16_t solid) { s[i] = std::max(s[i], solid); }))
      return fail(ImportError::mesh_ambiguous, name);
  }
  bool within = true;
  for (const TriangleMesh& shell : shells.cavities) {
    const bool sound = for_each_voxel(shell, box.grid, share_of(shell), [&](std::size_t i, std::uint16_t hollow) {
      within &= hollow != kSolid || s[i] != 0;
      s[i] = std::min(s[i], static_cast<std::uint16_t>(kSolid - hollow));
    });
    if (!within && !part.turned_at.empty()) return fail(ImportError::mesh_not_oriented, name + part.turned_at);
    if (!sound || !within) return fail(ImportError::mesh_ambiguous, name);
  }
  if (std::ranges::none_of(s, [](std::uint16_t v) { return v >= kHalf; })) return fail(ImportError::nothing_solid, name);
  return out;
}

}  // namespace cusp::scenarios
