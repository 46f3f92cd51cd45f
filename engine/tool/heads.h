/// Profiles of cutting heads from a catalogue's figures. Lengths in mm; the tip is at t = -radius, the head's end at
/// length - radius. Figures that make no convex solid give no profile.
/// Only + - * / sqrt: the same figures make the same profile everywhere.
#pragma once

#include <optional>

#include "engine/tool/profile.h"

namespace cusp::engine {

/// A flat end of tip_radius and a straight flank to top_radius. Straight fissure (both the radius), tapered fissure and
/// flat-end taper (wider at the top), inverted cone (wider at the tip). The wider of the two is the bur's radius.
std::optional<Profile> flat_head(double tip_radius, double top_radius, double length);

/// A ball of tip_radius and a flank that touches it: dome fissure (both the radius), round-end taper (wider at the top).
std::optional<Profile> round_end_head(double tip_radius, double top_radius, double length);

/// A flat end, a rounded corner of corner_radius, and a flank that narrows to top_radius: pear, long pear. If
/// corner_radius is the radius, the end is half a ball.
std::optional<Profile> pear_head(double radius, double corner_radius, double top_radius, double length);

/// A flank that bulges from a rounded tip over the widest place, widest_at from the tip, to top_radius: flame, football.
std::optional<Profile> oval_head(double radius, double tip_radius, double widest_at, double top_radius, double length);

}  // namespace cusp::engine
