/// A tooth with its neighbours as voxels and the rest of its jaw as scenery, as an exercise opens them.
#pragma once

#include <utility>
#include <vector>

#include "scenarios/teeth/tooth.h"
#include "tests/modules.h"

namespace cusp::test {

struct Jaw {
  Tooth tooth;
  std::vector<JawSurface> scenery;
};

inline Result<Jaw, ToothFailure> grow_jaw(ToothRequest request, double scenery_step_mm = kSceneryStepMm) {
  request.neighbours = true;
  auto tooth = grow_tooth(request);
  if (!tooth) return std::unexpected(tooth.error());
  auto rest = rest_of_jaw(request, scenery_step_mm);
  if (!rest) return std::unexpected(rest.error());
  return Jaw{std::move(*tooth), std::move(*rest)};
}

}  // namespace cusp::test
