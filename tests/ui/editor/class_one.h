/// The draft that most tests of the editor begin with.
#pragma once

#include "scenarios/library/library.h"
#include "tests/modules.h"
#include "ui/editor/editor_model.h"

namespace cusp::test {

inline EditorStart class_one() {
  const Scenario s = *load_builtin("class-1-36");
  EditorStart start{s, s, {}};
  start.draft.version = s.version + 1;
  return start;
}

/// What growing the average 36 finds, as far as the checks read it (box from `cusp specimen tooth --fdi 36`, rounded out).
inline SpecimenFacts facts_of_36() {
  return {{-7, -7, -16}, {7, 7, 8}, 0.1, {Tissue::enamel, Tissue::dentine, Tissue::cementum, Tissue::pulp}};
}

}  // namespace cusp::test
