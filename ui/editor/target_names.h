/// Several targets in one tree (named_targets of scenarios/format/region.h): their names, titles and criteria. Pure functions.
#pragma once

#include <string>

#include "ui/editor/region_parts.h"

namespace cusp::ui {

/// A direct part of a union at the root.
bool can_be_target(const Region& whole, const PartPath& path);
/// Gives the part of the root's union a title in one language, and a name with its first title. English has the same text while it has
/// none of its own. Without the last title the name goes. Pre: can_be_target().
void set_target_title(Region& part, const Region& whole, const std::string& language, const std::string& text);
/// Clears names where none can stand, and removes the criteria of targets that `before` had and the exercise has no more. The criteria
/// of the one that is left measure the whole.
void settle_targets(const Scenario& before, Scenario& after);

}  // namespace cusp::ui
