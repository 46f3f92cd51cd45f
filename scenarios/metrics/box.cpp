#include "scenarios/metrics/box.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "scenarios/metrics/surface_search.h"
#include "scenarios/teeth/own_tissues.h"

namespace cusp::scenarios {

namespace {

/// A border between tissues, as the mean over 25 lines: over a wall, and at its least or most (measured: proximal_test).
constexpr double kJunctionVoxels = 0.35, kJunctionPlaceVoxels = 0.6;
/// Thicker than any dentine or enamel between an axial wall and the junction.
constexpr double kFurthestJunctionMm = 4.0;

double mm2_of(const CutFace& face) noexcept { return std::sqrt(glm::dot(face.area_mm2, face.area_mm2)); }

/// Mean height of a face, over its area.
double mean_z(const std::vector<CutFace>& faces) noexcept {
  double sum = 0, area = 0;
  for (const CutFace& face : faces) {
    sum += mm2_of(face) * face.middle_mm.z;
    area += mm2_of(face);
  }
  return sum / area;
}

/// Height of a closed line beside a place: at its point that is nearest in plan.
double line_height(const std::vector<Vec3>& line, Vec3 p) noexcept {
  double nearest = std::numeric_limits<double>::max(), z = 0;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const Vec2 a(line[i].x, line[i].y), b(line[i + 1].x, line[i + 1].y), at(p.x, p.y);
    const double t = nearest_on_segment(at, a, b);
    const Vec2 off = at - (a + t * (b - a));
    if (glm::dot(off, off) >= nearest) continue;
    nearest = glm::dot(off, off);
    z = line[i].z + t * (line[i + 1].z - line[i].z);
  }
  return z;
}

bool is_enamel(Tissue t) noexcept { return t == Tissue::enamel || t == Tissue::carious_enamel; }
bool is_dentine(Tissue t) noexcept { return t == Tissue::dentine || t == Tissue::carious_dentine || t == kFirmCariousDentine; }

enum class Starts : std::uint8_t { in_dentine, in_enamel };

/// Length along a line until its tissue changes from dentine to enamel, or the other way; nullopt where another tissue or the
/// air comes first.
std::optional<double> to_change(const Specimen& specimen, const NearestVoxel& voxels, Vec3 from, Vec3 way, Starts starts) noexcept {
  const bool from_dentine = starts == Starts::in_dentine;
  const double step = 0.25 * specimen.grid().voxel_mm;
  IVec3 last(std::numeric_limits<int>::min());
  for (double mm = 0.0; mm <= kFurthestJunctionMm; mm += step) {
    const IVec3 v = voxels.of(from + mm * way);
    if (v == last) continue;
    last = v;
    const Tissue t = specimen.tissue(v);
    if (from_dentine ? is_enamel(t) : is_dentine(t)) return mm - 0.5 * step;
    if (!was_solid(specimen, v) || !(from_dentine ? is_dentine(t) : is_enamel(t))) return std::nullopt;
  }
  return std::nullopt;
}

/// Signed depth in dentine at one place of the axial wall; `into_void`: its normal.
std::optional<double> depth_in_dentine(const Specimen& specimen, Vec3 at, Vec3 into_void) noexcept {
  const double voxel = specimen.grid().voxel_mm;
  const NearestVoxel voxels(specimen.grid());
  const Vec3 aside = std::fabs(into_void.z) < 0.9 ? Vec3(0, 0, 1) : Vec3(1, 0, 0);
  const Vec3 u = glm::normalize(glm::cross(into_void, aside)), w = glm::cross(into_void, u);
  double sum = 0;
  int lines = 0;
  for (int i = -2; i <= 2; ++i)
    for (int j = -2; j <= 2; ++j) {
      const Vec3 from = at + 0.43 * voxel * (static_cast<double>(i) * u + static_cast<double>(j) * w);
      const bool dentine = is_dentine(specimen.tissue(voxels.of(from)));
      // In dentine the junction lies outwards, through what was removed; in enamel it lies inwards.
      const std::optional<double> mm = to_change(specimen, voxels, from, dentine ? into_void : -into_void, dentine ? Starts::in_dentine : Starts::in_enamel);
      if (!mm) continue;
      sum += dentine ? *mm : -*mm;
      ++lines;
    }
  return lines >= 13 ? std::optional(sum / lines) : std::nullopt;
}

void add(const char* key, const std::optional<MeasuredLength>& one, std::vector<Measure>& out) {
  if (one) out.push_back({key, true, one->mm, one->uncertainty_mm, "mm", one->at_mm});
  else out.push_back(not_measured(key, "mm"));
}

}  // namespace

std::optional<MeasuredLength> gingival_above_cej(const CutFaces& faces, const Reference& reference, std::optional<Vec3> through) {
  const std::vector<CutFace>& floor = faces.of(FaceName::gingival_floor);
  const ToothLandmarks* landmarks = floor.empty() && !through ? nullptr : reference.landmarks();
  if (landmarks == nullptr || landmarks->cej.size() < 3) return std::nullopt;
  const double place_mm = reference.point_sigma_mm(), line_mm = reference.landmark_sigma_mm(MarkKind::cej);
  const double known_mm = std::sqrt(place_mm * place_mm + line_mm * line_mm);
  MeasuredLength out{std::numeric_limits<double>::max(), known_mm, Vec3(0.0)};
  const auto offer = [&](Vec3 at) {
    const double mm = at.z - line_height(landmarks->cej, at);
    if (mm >= out.mm) return;
    out.mm = mm;
    out.at_mm = at;
  };
  for (const CutFace& face : floor) offer(face.middle_mm);
  if (through) offer(*through);
  return out;
}

std::optional<MeasuredLength> box_height(const CutFaces& faces, const Reference& reference, std::optional<Vec3> through) {
  const std::vector<CutFace>&gingival = faces.of(FaceName::gingival_floor), &pulpal = faces.of(FaceName::pulpal_floor);
  if (pulpal.empty() || (gingival.empty() && !through)) return std::nullopt;
  const double low = gingival.empty() ? through->z : mean_z(gingival);
  return MeasuredLength{mean_z(pulpal) - low, std::sqrt(2.0) * reference.point_sigma_mm(), gingival.empty() ? *through : gingival.front().middle_mm};
}

std::optional<AxialDepth> axial_past_junction(const CutFaces& faces, const Reference& reference) {
  const double voxel = reference.specimen().grid().voxel_mm;
  const std::vector<CutFace>& pulpal = faces.of(FaceName::pulpal_floor);
  const double below = pulpal.empty() ? std::numeric_limits<double>::max() : mean_z(pulpal);
  std::optional<AxialDepth> out;
  double sum = 0, area = 0;
  for (const CutFace& face : faces.of(FaceName::axial_wall)) {
    if (face.middle_mm.z >= below) continue;
    const double mm2 = mm2_of(face);
    const std::optional<Facing> target = mm2 > 0.0 ? reference.shape().facing(face.middle_mm, face.area_mm2 / mm2) : std::nullopt;
    const std::optional<double> mm = target ? depth_in_dentine(reference.specimen(), face.middle_mm, target->into_void) : std::nullopt;
    if (!mm) continue;
    const MeasuredLength one{*mm, kJunctionPlaceVoxels * voxel, face.middle_mm};
    if (!out) out = AxialDepth{one, one, one};
    if (*mm < out->least.mm) out->least = one;
    if (*mm > out->most.mm) out->most = one;
    sum += mm2 * *mm;
    area += mm2;
  }
  if (out) out->mean = {sum / area, kJunctionVoxels * voxel, out->least.at_mm};
  return out;
}

void add_box(const CutFaces& faces, const Reference& reference, const Volume& volume, std::vector<Measure>& out) {
  const std::optional<Vec3> through = lowest_cut_through(reference, volume, FaceName::gingival_floor);
  add("gingival_above_cej", gingival_above_cej(faces, reference, through), out);
  add("box_height", box_height(faces, reference, through), out);
  const std::optional<AxialDepth> axial = axial_past_junction(faces, reference);
  const auto part = [&](MeasuredLength AxialDepth::* one) { return axial ? std::optional((*axial).*one) : std::nullopt; };
  add("axial_past_junction_least", part(&AxialDepth::least), out);
  add("axial_past_junction_mean", part(&AxialDepth::mean), out);
  add("axial_past_junction_most", part(&AxialDepth::most), out);
}

}  // namespace cusp::scenarios
