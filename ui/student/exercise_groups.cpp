#include "ui/student/exercise_groups.h"

#include <algorithm>

#include "ui/student/course.h"

namespace cusp::ui {
namespace {

bool has_leaf(const Region& region, RegionKind kind) {
  return region.kind == kind || std::ranges::any_of(region.parts, [&](const Region& part) { return has_leaf(part, kind); });
}

bool has_face(const Region& region, FaceName face) {
  return std::ranges::any_of(region.faces, [&](const auto& named) { return named.second == face; }) ||
         std::ranges::any_of(region.parts, [&](const Region& part) { return has_face(part, face); });
}

}  // namespace

ExerciseGroup group_of(const Scenario& scenario) {
  if (scenario.specimen.generator.empty()) return ExerciseGroup::other;
  if (scenario.specimen.generator != "tooth") return ExerciseGroup::block;
  if (!scenario.specimen.lesions.empty() || has_leaf(scenario.target, RegionKind::lesion)) return ExerciseGroup::caries;
  return has_face(scenario.target, FaceName::gingival_floor) ? ExerciseGroup::class_2 : ExerciseGroup::class_1;
}

QString group_name(ExerciseGroup group) {
  switch (group) {
    case ExerciseGroup::class_1: return CourseModel::tr("Class I");
    case ExerciseGroup::class_2: return CourseModel::tr("Class II");
    case ExerciseGroup::caries: return CourseModel::tr("Caries");
    case ExerciseGroup::other: return CourseModel::tr("Imported specimens");
    case ExerciseGroup::block: break;
  }
  return CourseModel::tr("Practice blocks");
}

}  // namespace cusp::ui
