#include "scenarios/teeth/tooth.h"

#include <algorithm>
#include <optional>

#include "scenarios/teeth/arch.h"
#include "scenarios/teeth/find_landmarks.h"
#include "scenarios/teeth/gums.h"
#include "scenarios/teeth/own_tissues.h"
#include "scenarios/teeth/shared_shape.h"
#include "scenarios/teeth/tables.h"
#include "scenarios/teeth/two_threads.h"
#include "scenarios/teeth/voxels.h"

namespace cusp::scenarios {
namespace {

constexpr double kShapeShare = 0.25;     // of the time, measured at 0.1 mm
constexpr double kSceneryVoxelMm = 0.2;  // what the grooves of scenery are widened for
constexpr double kGumStepMm = 0.6;       // of scenery: gums have no finer form than 0.4 mm
constexpr double kSeamMm = 0.05;         // nearer to the gums of voxels those of the scenery are not drawn
constexpr double kFootMm = 0.8;          // more than the rounding of their lower edge
constexpr double kTuckMm = 0.15;         // depth of their edge below it: its chords of 0.6 mm stay within

bool stopped(ToothCancel cancel) { return cancel != nullptr && cancel->load(); }

/// Everything grows in the frame of the tables; what is of quadrant 2 or 4 is turned round at the end.
int other_side(int fdi) {
  constexpr int kOther[5] = {0, 2, 1, 4, 3};
  return 10 * kOther[fdi / 10] + fdi % 10;
}

/// A tooth and those beside it, standing. The first is the one that was asked for.
struct Row {
  bool mirrored = false;
  ToothLandmarks landmarks;
  std::vector<PlacedLesion> lesions;
  std::vector<Standing> teeth;

  /// From an FDI number of the request to one of the tables' frame, and back.
  int turned(int fdi) const { return mirrored ? other_side(fdi) : fdi; }
};

Result<Row, ToothFailure> stand(const ToothRequest& request, ToothCancel cancel) {
  if (!(request.voxel_mm >= kMinToothVoxelMm && request.voxel_mm <= kMaxToothVoxelMm)) {
    return fail(ToothError::bad_voxel_size, "voxel_mm", std::to_string(request.voxel_mm));
  }
  const auto choice = table_for(request.fdi);
  if (!choice) return std::unexpected(choice.error());
  if (stopped(cancel)) return fail(ToothError::cancelled, "tooth");
  Row row;
  row.mirrored = choice->mirrored;
  const int fdi = row.turned(request.fdi);
  std::vector<int> fdis{fdi};
  if (request.neighbours) {
    for (const Proximal side : {Proximal::mesial, Proximal::distal}) {
      if (const int beside = neighbour_fdi(fdi, side)) fdis.push_back(beside);
    }
  }
  std::vector<std::shared_ptr<const ToothShape>> shapes(fdis.size());
  in_two_threads(static_cast<int>(fdis.size()), [&](int i) {
    const auto at = static_cast<std::size_t>(i);
    shapes[at] = i == 0 ? shared_shape(*choice->table, request.seed, request.voxel_mm)
                        : shape_in_mouth(fdis[at], request.seed, request.voxel_mm);
  });
  Standing own;
  own.fdi = fdi;
  own.shape = std::move(shapes[0]);
  row.landmarks = find_landmarks(*own.shape);
  for (const Lesion& lesion : request.lesions) {
    const auto placed = PlacedLesion::place(lesion, *own.shape, row.landmarks);
    if (!placed) return fail(ToothError::unknown_site, lesion.site);
    row.lesions.push_back(*placed);
  }
  row.teeth.push_back(std::move(own));
  for (std::size_t i = 1; i < fdis.size(); ++i) {
    const Proximal side = fdis[i] == neighbour_fdi(fdi, Proximal::mesial) ? Proximal::mesial : Proximal::distal;
    row.teeth.push_back(stand_beside(row.teeth.front(), side, std::move(shapes[i])));
  }
  return row;
}

Result<Tooth, ToothFailure> grown(const ToothRequest& request, Row& row, ToothCancel cancel,
                                  const ToothProgress& progress) {
  std::vector<ToothBody> bodies;
  for (const Standing& s : row.teeth) {
    const bool own = bodies.empty();
    const ToothMaterial material = request.typodont ? ToothMaterial::typodont
                                   : own            ? ToothMaterial::natural
                                                    : ToothMaterial::neighbour;
    bodies.emplace_back(*s.shape, s.place, material, own ? row.lesions : std::vector<PlacedLesion>{});
  }
  const bool gums = request.gingiva || request.bone;
  const double steps = static_cast<double>(bodies.size() + (gums ? 1 : 0));
  double done = 0.0;
  const auto grow = [&](const Body& body) {
    const double from = kShapeShare + (1.0 - kShapeShare) * done / steps;
    const double to = kShapeShare + (1.0 - kShapeShare) * (done + 1.0) / steps;
    done += 1.0;
    const ToothProgress part = [&](double share) {
      if (progress) progress(from + (to - from) * share);
    };
    return voxels_of(body, request.voxel_mm, cancel, part, 0.0);
  };
  std::vector<VoxelVolume> parts;
  for (const ToothBody& body : bodies) {
    auto part = grow(body);
    if (!part) return std::unexpected(part.error());
    parts.push_back(std::move(*part));
  }
  Tooth out;
  out.volume = parts.size() == 1 ? std::move(parts.front()) : united(parts);
  parts.clear();
  if (gums) {
    std::vector<const ToothBody*> all;
    for (const ToothBody& body : bodies) all.push_back(&body);
    auto around = grow(Gums(all, {request.gingiva, request.bone}));
    if (!around) return std::unexpected(around.error());
    out.volume = embedded(std::move(out.volume), *around);
  }
  for (const auto& [code, name] : own_tissue_names()) {
    const bool there = std::ranges::find(out.volume.tissue, Tissue{code}) != out.volume.tissue.end();
    if (there) out.volume.names[code] = name;
  }
  out.landmarks = row.landmarks;
  for (std::size_t i = 1; i < row.teeth.size(); ++i) {
    const Standing& s = row.teeth[i];
    out.neighbours.push_back({row.turned(s.fdi), s.contact_mm, s.gap_mm});
  }
  if (row.mirrored) {
    out.volume = mirrored(out.volume);
    out.landmarks = mirrored(std::move(out.landmarks));
    for (Neighbour& n : out.neighbours) n.contact_mm.x = -n.contact_mm.x;
  }
  return out;
}

/// The teeth beyond a neighbour, in the order of the jaw: mesially over the midline to the other side's
/// third molar, distally to this side's.
std::vector<int> beyond(int neighbour, Proximal side) {
  std::vector<int> out;
  for (int at = neighbour; at != 0;) {
    const bool over = side == Proximal::mesial && at % 10 == 1;
    at = neighbour_fdi(at, side);
    if (over) side = Proximal::distal;
    if (at != 0) out.push_back(at);
  }
  return out;
}

/// Gums of voxels less their rounded lower edge, over which those of the jaw go straight on.
class WithoutFoot final : public Body {
 public:
  explicit WithoutFoot(const Gums& gums) : gums_(gums) {}
  double outside(Vec3 p) const noexcept override { return std::max(gums_.outside(p), gums_.floor_mm() + kFootMm - p.z); }
  Tissue inside(Vec3 p, double outside_mm) const noexcept override { return gums_.inside(p, outside_mm); }
  Tissue skin(Vec3 p) const noexcept override { return gums_.skin(p); }
  Tissue whole(Vec3 p, double far) const noexcept override { return gums_.whole(p, far); }
  Vec3 low() const noexcept override { return gums_.low(); }
  Vec3 high() const noexcept override { return gums_.high(); }

 private:
  const Gums& gums_;
};

/// The gums of a whole jaw where they are no voxels; what of the teeth stands in them is covered.
SceneryMesh gums_of(const ToothRequest& request, const Row& row, const std::vector<ToothBody>& rest,
                    std::vector<SceneryMesh>& meshes) {
  const Gums::Parts parts{request.gingiva, request.bone};
  std::vector<ToothBody> near;
  for (const Standing& s : row.teeth) near.emplace_back(*s.shape, s.place, ToothMaterial::natural);
  std::vector<const ToothBody*> voxels, all;
  for (const ToothBody& body : near) voxels.push_back(&body);
  all = voxels;
  for (const ToothBody& body : rest) all.push_back(&body);
  const Gums whole(all, parts);
  SceneryMesh out = mesh_of(whole, kGumStepMm);
  out.within = request.bone ? Tissue::bone : Tissue::gingiva;
  const Gums own(voxels, parts);
  cover(out, WithoutFoot(own), kSeamMm);
  tuck_in(out, own, kTuckMm);
  in_two_threads(static_cast<int>(meshes.size()), [&](int i) { cover(meshes[static_cast<std::size_t>(i)], whole, -kGumStepMm); });
  return out;
}

Result<std::vector<JawSurface>, ToothFailure> rest_of(const ToothRequest& request, const Row& row, double step_mm,
                                                      ToothCancel cancel) {
  const int fdi = row.teeth.front().fdi;
  std::vector<int> fdis;
  std::vector<const Standing*> begins;  // for each of them the neighbour that its chain begins at
  for (std::size_t i = 1; i < row.teeth.size(); ++i) {
    // The neighbour of a central incisor is of the other side already: from there the way leads backwards.
    const bool mesial = row.teeth[i].fdi == neighbour_fdi(fdi, Proximal::mesial) && fdi % 10 != 1;
    for (const int next : beyond(row.teeth[i].fdi, mesial ? Proximal::mesial : Proximal::distal)) {
      begins.push_back(&row.teeth[i]);
      fdis.push_back(next);
    }
  }
  std::vector<std::shared_ptr<const ToothShape>> shapes(fdis.size());
  in_two_threads(static_cast<int>(fdis.size()), [&](int i) {
    const auto at = static_cast<std::size_t>(i);
    shapes[at] = shape_in_mouth(fdis[at], request.seed, kSceneryVoxelMm);
  });
  std::vector<Standing> rest;
  rest.reserve(fdis.size());
  for (std::size_t i = 0; i < fdis.size(); ++i) {
    const bool first = i == 0 || begins[i] != begins[i - 1];
    const Standing& before = first ? *begins[i] : rest.back();
    const Proximal side = fdis[i] == neighbour_fdi(before.fdi, Proximal::mesial) ? Proximal::mesial : Proximal::distal;
    rest.push_back(stand_beside(before, side, std::move(shapes[i])));
  }
  std::vector<SceneryMesh> meshes(rest.size());
  const ToothMaterial material = request.typodont ? ToothMaterial::typodont : ToothMaterial::natural;
  std::vector<ToothBody> bodies;
  bodies.reserve(rest.size());
  for (const Standing& s : rest) bodies.emplace_back(*s.shape, s.place, material);
  in_two_threads(static_cast<int>(rest.size()), [&](int i) {
    const auto at = static_cast<std::size_t>(i);
    meshes[at] = mesh_of(bodies[at], step_mm);
    meshes[at].within = request.typodont ? Tissue::plastic : Tissue::dentine;
  });
  if (stopped(cancel)) return fail(ToothError::cancelled, "jaw");
  std::optional<SceneryMesh> gums;
  if (request.gingiva || request.bone) {
    gums = gums_of(request, row, bodies, meshes);
    if (row.mirrored) mirror(*gums);
  }
  std::vector<JawSurface> out;
  for (std::size_t i = 0; i < rest.size(); ++i) {
    if (row.mirrored) mirror(meshes[i]);
    out.push_back({row.turned(rest[i].fdi), std::move(meshes[i])});
  }
  // From the patient's right to the left.
  std::ranges::sort(out, {}, [](const JawSurface& s) {
    const int quadrant = s.fdi / 10, number = s.fdi % 10;
    return quadrant == 1 || quadrant == 4 ? -number : number;
  });
  if (gums) out.push_back({0, std::move(*gums)});
  return out;
}

}  // namespace

Result<Tooth, ToothFailure> grow_tooth(const ToothRequest& request, ToothCancel cancel, const ToothProgress& progress) {
  auto row = stand(request, cancel);
  if (!row) return std::unexpected(row.error());
  if (progress) progress(kShapeShare);
  if (stopped(cancel)) return fail(ToothError::cancelled, "tooth");
  return grown(request, *row, cancel, progress);
}

Result<std::vector<JawSurface>, ToothFailure> rest_of_jaw(const ToothRequest& request, double scenery_step_mm,
                                                          ToothCancel cancel) {
  ToothRequest near = request;
  near.neighbours = true;
  auto row = stand(near, cancel);
  if (!row) return std::unexpected(row.error());
  return rest_of(request, *row, scenery_step_mm, cancel);
}

Result<VoxelVolume, ToothFailure> make_tooth(const ToothRequest& request, ToothCancel cancel,
                                             const ToothProgress& progress) {
  auto tooth = grow_tooth(request, cancel, progress);
  if (!tooth) return std::unexpected(tooth.error());
  return std::move(tooth->volume);
}

Result<ToothLandmarks, ToothFailure> tooth_landmarks(const ToothRequest& request) {
  if (!(request.voxel_mm >= kMinToothVoxelMm && request.voxel_mm <= kMaxToothVoxelMm)) {
    return fail(ToothError::bad_voxel_size, "voxel_mm", std::to_string(request.voxel_mm));
  }
  const auto choice = table_for(request.fdi);
  if (!choice) return std::unexpected(choice.error());
  ToothLandmarks landmarks = find_landmarks(*shared_shape(*choice->table, request.seed, request.voxel_mm));
  return choice->mirrored ? mirrored(std::move(landmarks)) : landmarks;
}

}  // namespace cusp::scenarios
