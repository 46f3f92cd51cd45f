/// What stands about a specimen to be looked at and never drilled, such as the other teeth of a jaw: baked once, drawn
/// beside the specimen's own mesh, and cut in sections. Plain values; any thread.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "scenarios/format/scenario.h"
#include "scenarios/import/import_error.h"
#include "scenarios/teeth/scenery.h"
#include "scenarios/teeth/tooth.h"
#include "ui/modules.h"
#include "ui/render/patch_feed.h"

namespace cusp::ui {

class SceneryLook {
 public:
  explicit SceneryLook(std::vector<SceneryMesh> meshes);

  /// What lies open, in patches of some millimetres that a frame may skip. `brick` counts them.
  const std::vector<BakedPatch>& patches() const noexcept { return patches_; }
  const std::vector<SceneryMesh>& meshes() const noexcept { return meshes_; }
  /// Of the meshes, as many.
  const std::vector<Box>& boxes() const noexcept { return boxes_; }
  const Box& bounds() const noexcept { return bounds_; }
  std::size_t bytes() const noexcept;

 private:
  std::vector<SceneryMesh> meshes_;
  std::vector<Box> boxes_;
  std::vector<BakedPatch> patches_;
  Box bounds_;
};

/// The scenery that a specimen asks for; null where it asks for none, or where none can be grown. Seconds the first time;
/// the last one asked for is kept, so that drilling, report and picture share it. Null, too, once *cancel is true before it has grown.
/// `grow`: instead of make_scenery().
using GrowScenery = std::function<Result<std::vector<JawSurface>, ImportFailure>()>;
std::shared_ptr<const SceneryLook> scenery_of(const SpecimenSource& source, ToothCancel cancel = nullptr, const GrowScenery& grow = {});

}  // namespace cusp::ui
