/// Changes to a path that is laid: shaken, with another bur, or with strokes added. Frame: specimen. Millimetres. Any thread.
#pragma once

#include "engine/tool/bur.h"
#include "scenarios/operators/plan.h"
#include "scenarios/shapes/target.h"

namespace cusp::scenarios {

struct CutTools {
  const Specimen& specimen;
  const TargetShape& target;
  const Bur& bur;
};

/// The bur scaled about its pivot until its radius is wider by `by_mm`.
[[nodiscard]] Bur wider(const Bur& bur, double by_mm);
void raise(Plan& plan, double by_mm);
/// Every cutting stroke in steps, each led off its line by up to `most_mm` along each axis. The same path shakes alike.
void shake(Plan& plan, double most_mm);
/// At last the bur goes `deep_mm` below the floor, at places of the floor that are 1.3 mm apart. False if it cuts no floor.
bool add_pits(Plan& plan, const CutTools& tools, double deep_mm);
/// At last from the floor to `deep_mm` below the pulp's nearest roof. False if there is no pulp.
bool add_way_into_pulp(Plan& plan, const Scenario& scenario, const Specimen& specimen, double deep_mm);
/// At last from above, `deep_mm` into the neighbour, where the bur spares the own tooth. False if there is no such place.
bool add_nick(Plan& plan, const CutTools& tools, double deep_mm);

}  // namespace cusp::scenarios
