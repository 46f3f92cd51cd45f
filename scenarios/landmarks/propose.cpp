#include "scenarios/landmarks/propose.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scenarios/landmarks/neck_line.h"
#include "scenarios/landmarks/plan_fit.h"
#include "scenarios/landmarks/valley.h"
#include "scenarios/teeth/find_landmarks.h"
#include "scenarios/teeth/shape.h"
#include "scenarios/teeth/shared_shape.h"
#include "scenarios/teeth/tables.h"

namespace cusp::scenarios {

namespace {

constexpr double kTableVoxelMm = 0.1;
/// A crown that is further off the average one is another tooth's: nothing of it is named, mm (the README's table has the fits).
constexpr double kMostOffMm = 0.6;
constexpr double kCuspReachMm = 1.2, kPitReachMm = 0.4, kLineReachMm = 0.35;
/// A contact lies at most this far below where the average tooth has it.
constexpr double kContactBelowMm = 2.0;
/// The outermost places within this of the furthest are one flat contact, whose middle is taken.
constexpr double kFlatMm = 0.02;
constexpr double kHalfAxisMm = 5.0;  // of the drawn mesial axis

class Proposer {
 public:
  Proposer(const VoxelVolume& volume, int fdi, const ToothShape& table, Hand hand)
      : tooth_(volume), table_(table), marks_(find_landmarks(table)), hand_(hand) {
    out_.fdi = fdi;
  }

  bool is_empty() const noexcept { return tooth_.empty(); }

  SpecimenLandmarks run() {
    long_axis();
    fit_ = fit_plan(tooth_, table_, hand_);
    neck_ = neck_line(tooth_, fit_.centre_mm);
    if (!neck_.empty()) add(MarkKind::cej, {}, neck_);
    if (fit_.off_mm > kMostOffMm) return std::move(out_);
    mesial_axis();
    for (const SurfacePlace& one : marks_.cusp_tips) place(MarkKind::cusp_tip, one, kCuspReachMm, Looks::for_high);
    for (const SurfacePlace& one : marks_.pits) place(MarkKind::pit, one, kPitReachMm, Looks::for_low);
    for (const SurfaceLine& one : marks_.fissures) line(MarkKind::fissure, one, Looks::for_low);
    for (const SurfaceLine& one : marks_.marginal_ridges) line(MarkKind::marginal_ridge, one, Looks::for_high);
    outermost(MarkKind::contact, "mesial", fit_.mesial, below_top(marks_.mesial_contact) + kContactBelowMm);
    outermost(MarkKind::contact, "distal", -fit_.mesial, below_top(marks_.distal_contact) + kContactBelowMm);
    outermost(MarkKind::contour, "buccal", fit_.buccal, neck_below(fit_.buccal));
    outermost(MarkKind::contour, "lingual", -fit_.buccal, neck_below(-fit_.buccal));
    return std::move(out_);
  }

 private:
  void add(MarkKind kind, std::string name, std::vector<Vec3> points) {
    out_.marks.push_back({kind, std::move(name), std::move(points), MarkState::proposed});
  }
  double below_top(Vec3 table_place) const noexcept { return table_.high().z - table_place.z; }
  /// How far below the top the neck lies on that side: by the CEJ, else as on the average tooth.
  double neck_below(Vec2 way) const noexcept {
    if (neck_.empty()) return table_.high().z;
    const auto along = [way](const Vec3& p) { return glm::dot(Vec2(p.x, p.y), way); };
    return tooth_.top_mm() - std::ranges::max(neck_, {}, along).z;
  }
  void long_axis() {
    const auto axis = tooth_.long_axis();
    if (!axis) return;
    const Vec3 middle = tooth_.centroid_mm();
    add(MarkKind::long_axis, {}, {middle - kHalfAxisMm * *axis, middle + kHalfAxisMm * *axis});
  }
  void mesial_axis() {
    const double z = tooth_.height_mm(fit_.centre_mm).value_or(tooth_.top_mm());
    add(MarkKind::mesial_axis, {}, {Vec3(fit_.centre_mm, z), Vec3(fit_.centre_mm + kHalfAxisMm * fit_.mesial, z)});
  }
  void place(MarkKind kind, const SurfacePlace& expected, double reach_mm, Looks looks) {
    const auto found = extreme_near(tooth_, fit_.to_specimen({expected.at_mm.x, expected.at_mm.y}), reach_mm, looks);
    if (found) add(kind, expected.name, {*found});
  }
  void line(MarkKind kind, const SurfaceLine& expected, Looks looks) {
    std::vector<Vec2> plan;
    for (const Vec3& p : expected.points_mm) plan.push_back(fit_.to_specimen({p.x, p.y}));
    std::vector<Vec3> found = line_near(tooth_, plan, kLineReachMm, looks);
    if (found.size() > kMostMarkPoints) found.resize(kMostMarkPoints);
    if (!found.empty()) add(kind, expected.name, std::move(found));
  }
  /// The place of the crown that lies furthest along a way.
  void outermost(MarkKind kind, std::string name, Vec2 way, double deepest_mm) {
    const std::vector<Vec3> surface = tooth_.surface_above(tooth_.top_mm() - deepest_mm);
    const auto along = [way](const Vec3& p) { return glm::dot(Vec2(p.x, p.y), way); };
    if (surface.empty()) return;
    const double furthest = along(std::ranges::max(surface, {}, along));
    Vec3 sum(0.0);
    int count = 0;
    for (const Vec3& p : surface) {
      if (along(p) < furthest - kFlatMm) continue;
      sum += p;
      ++count;
    }
    add(kind, std::move(name), {sum / static_cast<double>(count)});
  }

  ToothSurface tooth_;
  const ToothShape& table_;
  ToothLandmarks marks_;  // in the table's frame
  Hand hand_;
  PlanFit fit_;
  std::vector<Vec3> neck_;
  SpecimenLandmarks out_;
};

}  // namespace

Result<SpecimenLandmarks, Failure<ProposeError>> propose_landmarks(const VoxelVolume& volume, int fdi) {
  const auto choice = table_for(fdi);
  if (!choice) return fail(ProposeError::unknown_fdi, std::to_string(fdi));
  const auto shape = shared_shape(*choice->table, 0, kTableVoxelMm);
  Proposer proposer(volume, fdi, *shape, choice->mirrored ? Hand::mirrored : Hand::as_table);
  if (proposer.is_empty()) return fail(ProposeError::no_tooth, {});
  return proposer.run();
}

double proposal_error(MarkKind kind, double voxel_mm) noexcept {
  switch (kind) {
    case MarkKind::long_axis: return 9.0;
    case MarkKind::mesial_axis: return 5.0;
    case MarkKind::cusp_tip: return 0.2;
    case MarkKind::pit: return 0.3;
    case MarkKind::fissure: return 0.5;
    case MarkKind::marginal_ridge: return 0.2;
    case MarkKind::contact: return 0.5;
    case MarkKind::contour: return 0.2;
    case MarkKind::cej: return 3.0 * voxel_mm;
  }
  return 0.0;
}

}  // namespace cusp::scenarios
