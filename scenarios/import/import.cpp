#include "scenarios/import/import.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <new>
#include <set>

#include "scenarios/import/header_text.h"
#include "scenarios/import/mesh_parts.h"
#include "scenarios/import/part_precedence.h"
#include "scenarios/import/size_question.h"
#include "scenarios/import/triangle_mesh.h"

namespace cusp::scenarios {
namespace {

Result<void, ImportFailure> check_options(const MeshImport& what) {
  if (!(what.unit_mm > 0.0) || !std::isfinite(what.unit_mm)) return fail(ImportError::bad_option, "unit-mm");
  if (what.mend_holes_mm && !(*what.mend_holes_mm >= 0.0)) return fail(ImportError::bad_option, "mend-holes-mm");
  if (!(what.voxel_mm >= what.limits.min_voxel_mm && what.voxel_mm <= what.limits.max_voxel_mm))
    return fail(ImportError::bad_option, "voxel-mm");
  if (what.tissues.empty()) return fail(ImportError::no_mesh, what.path.filename().string());
  std::set<std::string> names;
  for (const auto& [name, tissue] : what.tissues) {
    if (!names.insert(name).second) return fail(ImportError::bad_option, "tissue " + name);
    if (tissue == Tissue::empty || !is_tissue_code(index_of(tissue)))
      return fail(ImportError::bad_tissue, "tissue " + name);
  }
  return {};
}

/// All meshes, each under a name that is its own.
Result<std::vector<TriangleMesh>, ImportFailure> read_files(const std::filesystem::path& path,
                                                            const std::vector<std::filesystem::path>& more) {
  auto all = read_meshes(path);
  if (!all || more.empty()) return all;
  std::set<std::string> taken;
  const auto name_them = [&](std::vector<TriangleMesh>& meshes, const std::filesystem::path& file) {
    for (TriangleMesh& m : meshes) {
      const std::string stem = utf8_name(file.stem().string());
      const std::string name = meshes.size() == 1 ? stem : stem + ": " + m.name;
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

/// Of the chosen meshes, which stand as they were asked for.
PartOrder order_of(const MeshImport& what, const std::vector<MeshPart>& parts, const std::vector<PartField>& fields, const Grid& grid) {
  if (what.precedence == PartPrecedence::innermost) return innermost_first(parts, fields, grid);
  PartOrder out(parts.size());
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = i;
  return out;
}

double code_of(const MeshPart& part) { return static_cast<double>(index_of(part.tissue)); }

void note_order(const MeshImport& what, const PartOrder& order, const std::vector<MeshPart>& parts, std::vector<ImportRemark>& noted) {
  if (order.size() < 2) return;
  const double given = what.precedence == PartPrecedence::given ? 1.0 : 0.0;
  for (std::size_t n = 0; n < order.size(); ++n) {
    const MeshPart& part = parts[order[n]];
    noted.push_back({RemarkCode::precedence, part.mesh.name, {static_cast<double>(n + 1), code_of(part), given}});
  }
}

void note_overlap(const PartOverlap& o, const std::vector<MeshPart>& parts, std::vector<ImportRemark>& noted) {
  const MeshPart &winner = parts[o.winner], &loser = parts[o.loser];
  noted.push_back({o.within ? RemarkCode::part_within : RemarkCode::parts_overlap, winner.mesh.name,
                   {o.mm3, code_of(winner), code_of(loser)}, loser.mesh.name});
}

void note_size(const std::vector<MeshPart>& parts, std::vector<ImportRemark>& noted) {
  Vec3 low = parts.front().checked.low, high = parts.front().checked.high;
  for (const MeshPart& p : parts) {
    low = glm::min(low, p.checked.low);
    high = glm::max(high, p.checked.high);
  }
  if (auto remark = odd_size(high - low)) noted.push_back(std::move(*remark));
}

/// As MeshInfo::left_open.
double left_open(TriangleMesh mesh) {
  repair(mesh, 0.0);
  const std::vector<MeshGap> gaps = gaps_of(mesh);
  return gaps.empty() ? 0.0 : gaps.front().width();
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
  auto meshes = read_files(path, more);
  if (!meshes) return std::unexpected(meshes.error());
  std::vector<MeshInfo> out;
  for (TriangleMesh& m : *meshes) {
    const MeshCheck c = check(m);
    MeshInfo info{m.name, m.triangles.size(), c.low, c.high, std::abs(c.volume), c.closed, c.oriented, {}, 0, {}, 0.0};
    if (!c.closed) {
      info.gaps = gaps_of(m);
      info.gap_count = info.gaps.size();
      if (info.gaps.size() > kMaxGapsListed) info.gaps.resize(kMaxGapsListed);
      info.left_open = left_open(std::move(m));
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
  std::vector<ImportRemark> noted;
  const auto parts = choose_parts(std::move(*meshes), what, noted);
  if (!parts) return std::unexpected(parts.error());
  const auto grid = grid_about(*parts, what);
  if (!grid) return std::unexpected(grid.error());
  try {
    std::vector<PartField> fields;
    for (std::size_t i = 0; i < parts->size(); ++i) {
      const double wide = 0.6 / static_cast<double>(parts->size()), first = 0.3 + wide * static_cast<double>(i);
      report(first);
      auto field = field_of((*parts)[i], *grid, [&](double share) { report(first + wide * share); });
      if (!field) return std::unexpected(field.error());
      fields.push_back(std::move(*field));
    }
    const PartOrder order = order_of(what, *parts, fields, *grid);
    note_order(what, order, *parts, noted);
    for (const PartOverlap& overlap : overlaps_of(order, fields, *grid)) note_overlap(overlap, *parts, noted);
    note_size(*parts, noted);
    VoxelVolume out = put_together(order, *parts, fields, *grid);
    report(1.0);
    if (remarks) *remarks = std::move(noted);
    return out;
  } catch (const std::bad_alloc&) {
    return fail(ImportError::out_of_memory, what.path.filename().string());
  } catch (const std::exception& e) {
    return fail(ImportError::mesh_ambiguous, what.path.filename().string(), e.what());
  }
}

}  // namespace cusp::scenarios
