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

}  // namespace cusp::test
