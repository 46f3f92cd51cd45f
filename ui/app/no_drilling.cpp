#include "ui/app/desktop.h"

namespace cusp {

void Desktop::drill(const Exercise& exercise) {
  tell_failure({local(exercise.scenario.title), tr("This build has no drilling screen.")});
}

}  // namespace cusp
