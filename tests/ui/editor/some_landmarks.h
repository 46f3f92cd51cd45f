/// Landmarks that tests of the editor begin with: of a tooth 36 from a file, each proposed.
#pragma once

#include "scenarios/format/landmark.h"
#include "tests/modules.h"

namespace cusp::test {

/// In the order of the list: axis, two cusp tips, a closed junction.
inline SpecimenLandmarks some_landmarks() {
  SpecimenLandmarks out;
  out.fdi = 36;
  out.marks = {{MarkKind::long_axis, {}, {Vec3(0, 0, -8), Vec3(0, 0, 6)}, MarkState::proposed},
               {MarkKind::cusp_tip, "MB", {Vec3(2, 2, 7)}, MarkState::proposed},
               {MarkKind::cusp_tip, "DL", {Vec3(-2, -2, 6.5)}, MarkState::proposed},
               {MarkKind::cej, {}, {Vec3(4, 0, 0), Vec3(0, 4, 0), Vec3(-4, 0, 0), Vec3(4, 0, 0)}, MarkState::proposed}};
  return out;
}

}  // namespace cusp::test
