// The report's camera sees the place where points were lost. An id buffer, drawn here without OpenGL and without blending, counts
// the pixels of the surface about the place: what the tooth and its surroundings leave of it. And what is painted there lies there.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scenarios/grading/grader.h"
#include "scenarios/library/library.h"
#include "scenarios/metrics/evidence_patch.h"
#include "scenarios/metrics/measure.h"
#include "scenarios/metrics/reference.h"
#include "scenarios/operators/fault_cut.h"
#include "scenarios/specimens/specimens.h"
#include "tests/full_run.h"
#include "tests/modules.h"
#include "ui/render/place_view.h"
#include "ui/render/scenery_look.h"

namespace cusp::test {
namespace {

constexpr double kRegionMm = 0.5;    // about a place: what its ring in the report surrounds
constexpr double kLeastUnhidden = 0.2;  // of the region's pixels when nothing hides it
constexpr double kLeastSurface = 0.2;   // of its surface, slant included, at the places of the quick test
constexpr double kBesidePatchMm = 2.5;  // a lesion's place lies in the lesion, its patch on the surface
constexpr int kSidePx = 400;

struct Triangle {
  std::array<Vec3, 3> corner;
  bool of_region = false;
  double area_mm2() const { return 0.5 * glm::length(glm::cross(corner[1] - corner[0], corner[2] - corner[0])); }
};

void add_triangles(const PatchStore& mesh, std::vector<Triangle>& out) {
  for (const auto& [brick, patch] : mesh.patches())
    for (std::size_t i = 0; i + 2 < patch.indices.size(); i += 3) {
      Triangle& one = out.emplace_back();
      for (std::size_t k = 0; k < 3; ++k) {
        const float* at = patch.vertices[patch.indices[i + k]].position_mm;
        one.corner[k] = {at[0], at[1], at[2]};
      }
    }
}

/// The nearest triangle of each pixel: of the region or not.
class IdBuffer {
 public:
  explicit IdBuffer(const Camera& camera) : camera_(camera) {}
  void draw(const Triangle& triangle);
  enum class Side : char { none, back, front };
  int region_px(Side side) const { return static_cast<int>(std::ranges::count(of_region_, side)); }

 private:
  Camera camera_;
  std::vector<double> nearness_ = std::vector<double>(kSidePx * kSidePx, 0.0);  // 1 / distance: straight in the picture
  std::vector<Side> of_region_ = std::vector<Side>(kSidePx * kSidePx, Side::none);
};

void IdBuffer::draw(const Triangle& triangle) {
  std::array<glm::dvec2, 3> at;
  std::array<double, 3> near;
  for (std::size_t k = 0; k < 3; ++k) {
    const double far = glm::dot(triangle.corner[k] - camera_.eye_mm(), camera_.forward());
    const auto px = camera_.project(triangle.corner[k], {kSidePx, kSidePx});
    if (!px || far <= 0.0) return;
    at[k] = *px;
    near[k] = 1.0 / far;
  }
  const auto cross = [](glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; };
  const double whole = cross(at[1] - at[0], at[2] - at[0]);
  if (whole == 0.0) return;
  const bool front = whole < 0.0;  // y points down
  const auto [left, right] = std::minmax({at[0].x, at[1].x, at[2].x});
  const auto [top, bottom] = std::minmax({at[0].y, at[1].y, at[2].y});
  for (int y = std::max(0, static_cast<int>(top)); y <= std::min<double>(kSidePx - 1, bottom); ++y)
    for (int x = std::max(0, static_cast<int>(left)); x <= std::min<double>(kSidePx - 1, right); ++x) {
      const glm::dvec2 p(x + 0.5, y + 0.5);
      const double b = cross(p - at[0], at[2] - at[0]) / whole, c = cross(at[1] - at[0], p - at[0]) / whole;
      if (b < 0.0 || c < 0.0 || b + c > 1.0) continue;
      const double nearness = near[0] + b * (near[1] - near[0]) + c * (near[2] - near[0]);
      const std::size_t i = static_cast<std::size_t>(y * kSidePx + x);
      if (nearness <= nearness_[i]) continue;
      nearness_[i] = nearness;
      of_region_[i] = !triangle.of_region ? Side::none : front ? Side::front : Side::back;
    }
}

/// What a camera shows of the surface within kRegionMm of a place.
struct Shown {
  double of_unhidden = 0.0;  // 1 where nothing hides it
  double of_surface = 0.0;   // 1 where all of it also faces the eye
};

Shown shown_of(const Camera& camera, std::vector<Triangle>& triangles, std::size_t of_tooth, Vec3 place) {
  IdBuffer picture(camera), alone(camera);
  double area = 0.0;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    Triangle& one = triangles[i];
    const Vec3 middle = (one.corner[0] + one.corner[1] + one.corner[2]) / 3.0;
    one.of_region = i < of_tooth && glm::length(middle - place) < kRegionMm;
    picture.draw(one);
    if (!one.of_region) continue;
    area += one.area_mm2();
    alone.draw(one);
  }
  using enum IdBuffer::Side;
  const double px = camera.px_per_mm(kSidePx), seen = picture.region_px(front);
  const int whole = alone.region_px(front) + alone.region_px(back);
  return area > 0.0 && whole > 0 ? Shown{seen / whole, seen / (area * px * px)} : Shown{};
}

/// An exercise, cut with one fault after the other.
class Faulty {
 public:
  explicit Faulty(Scenario scenario)
      : scenario_(std::move(scenario)), specimen_(Specimen::build(*make_specimen(scenario_.specimen, {}), reading_of(scenario_.method))),
        against_(std::make_shared<const Reference>(scenario_, specimen_)), plan_(plan_target(scenario_, *specimen_)) {
    if (const auto scenery = scenery_of(scenario_.specimen))
      for (const BakedPatch& patch : scenery->patches()) beside_.put(patch);
  }
  /// Each place that a grade names as the cause of a loss is seen, and least_surface of the surface about it. Returns how many; nullopt where there is no such fault.
  std::optional<int> expect_places_shown(SizedFault fault, double least_surface) const {
    const auto cut = fault_cut(fault, scenario_, *specimen_, plan_);
    if (!cut) return std::nullopt;
    const auto whole = std::make_shared<Volume>(specimen_);
    if (!cut_along(*cut, *whole)) return std::nullopt;
    const Volume& volume = *whole;
    const EvidencePatches patches(against_, whole);
    PatchStore tooth;
    for (BakedPatch& patch : PatchFeed::build_mesh(volume, {}).patches) tooth.put(std::move(patch));
    std::vector<Triangle> triangles;
    add_triangles(tooth, triangles);
    const std::size_t of_tooth = triangles.size();
    add_triangles(beside_, triangles);
    const std::vector<Measure> measures = measure(*against_, volume, Process::lasting(1.0 + cut->dry_s, cut->dry_s));
    int places = 0;
    for (const CriterionGrade& one : grade(scenario_, measures).criteria) {
      if (one.points > one.points_max - 0.01 || !one.measure.where_mm) continue;
      ++places;
      expect_patch(patches, one, scenarios::key_of(fault));
      const Vec3 place = shown_place(one.id, patches.of(one.id), *one.measure.where_mm);
      const Camera from = Camera::about(place, 6.0);  // about a crown, as the report's
      const Camera to = look_at_place(from, {&tooth, &beside_}, place);
      const Shown shown = shown_of(to, triangles, of_tooth, place);
      if (full_run()) std::printf("%s %s %s: %.2f %.2f\n", scenario_.key.c_str(), scenarios::key_of(fault).c_str(), one.id.c_str(), shown.of_unhidden, shown.of_surface);
      EXPECT_GE(shown.of_unhidden, kLeastUnhidden) << scenario_.key << ' ' << scenarios::key_of(fault) << ' ' << one.id;
      EXPECT_GE(shown.of_surface, least_surface) << scenario_.key << ' ' << scenarios::key_of(fault) << ' ' << one.id;
    }
    return places;
  }

 private:
  /// Of a measure of tissue that found something.
  void expect_patch(const EvidencePatches& patches, const CriterionGrade& lost, const std::string& fault) const {
    const Measure& m = lost.measure;
    const bool found = lost.id == "contact_broken" ? m.value == 0.0 : m.value > 0.0;  // a contact that stands; an open one loses points
    if (!TissuePatches::has(lost.id) || !m.measured || !found) return;                // where too little of the target is cut
    const EvidencePatch patch = patches.of(lost.id);
    double far = 1e9;
    for (const auto& triangle : patch.triangles)
      for (const Vec3 corner : triangle) far = std::min(far, glm::length(corner - *m.where_mm));
    for (const auto& line : patch.lines) far = std::min(far, glm::length(line[0] - *m.where_mm));
    EXPECT_LE(far, kBesidePatchMm) << scenario_.key << ' ' << fault << ' ' << lost.id << ": " << m.value;
  }

  Scenario scenario_;
  std::shared_ptr<const Specimen> specimen_;
  std::shared_ptr<const Reference> against_;
  Plan plan_;
  PatchStore beside_;
};

/// A built-in exercise in a third of the time.
Scenario coarse(std::string_view key) {
  Scenario out = *load_builtin(key);
  out.specimen.voxel_mm = 0.2;
  return out;
}

TEST(IdBuffer, CountsWhatIsHiddenAndWhatLeansAway) {
  // A square of 1 mm faces the eye; another half as wide stands before it.
  const auto square = [](double z, double half_x, std::vector<Triangle>& out) {
    const Vec3 a(-half_x, -0.5, z), b(half_x, -0.5, z), c(half_x, 0.5, z), d(-half_x, 0.5, z);
    out.push_back({{a, b, c}});
    out.push_back({{a, c, d}});
  };
  Camera above = Camera::about(Vec3(0.0), 1.0);
  above.set_angles(0.0, std::numbers::pi / 2 - 0.01);
  std::vector<Triangle> one, both;
  square(0.0, 0.5, one);
  EXPECT_NEAR(shown_of(above, one, one.size(), Vec3(0.0)).of_surface, 1.0, 0.02);
  both = one;
  square(0.1, 0.25, both);
  EXPECT_NEAR(shown_of(above, both, one.size(), Vec3(0.0)).of_unhidden, 0.5, 0.04);
  Camera slant = above;
  slant.set_angles(0.0, std::numbers::pi / 6);
  const Shown leaning = shown_of(slant, one, one.size(), Vec3(0.0));
  EXPECT_NEAR(leaning.of_unhidden, 1.0, 1e-9);
  EXPECT_NEAR(leaning.of_surface, 0.5, 0.03);
}

TEST(EvidenceView, ShowsThePlacesOfLostPointsOnABlockAndATooth) {
  for (const auto& [key, faults] : std::initializer_list<std::pair<const char*, std::vector<SingleFault>>>{
           {"channel-1", {SingleFault::too_deep, SingleFault::too_wide}},
           {"class-1-25", {SingleFault::undermined}}}) {
    const Faulty exercise(coarse(key));
    int places = 0;
    for (const SingleFault fault : faults) places += exercise.expect_places_shown({fault, FaultSize::large}, kLeastSurface).value_or(0);
    EXPECT_GT(places, 0) << key;
  }
}

struct EveryEvidence : testing::TestWithParam<std::string_view> {};

TEST_P(EveryEvidence, IsShownWhateverTheFault) {
  if (!full_run()) GTEST_SKIP() << "half a minute an exercise; ./check --full sets CUSP_FULL";
  const Faulty exercise(coarse(GetParam()));
  for (const SingleFaultRow& fault : single_faults()) exercise.expect_places_shown({fault.fault, FaultSize::large}, 0.0);
}

INSTANTIATE_TEST_SUITE_P(Exercises, EveryEvidence, testing::ValuesIn(builtin_scenarios().begin(), builtin_scenarios().end()),
                         [](const auto& which) {
                           std::string name(which.param);
                           std::ranges::replace(name, '-', '_');
                           return name;
                         });

}  // namespace
}  // namespace cusp::test
