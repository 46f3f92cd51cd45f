/// Several targets of one exercise (named_targets of scenarios/format/region.h), each measured as if it were alone: on its own
/// cavity, with its own region. Immutable; any thread but the haptic one.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/volume/volume.h"
#include "scenarios/format/scenario.h"
#include "scenarios/modules.h"
#include "scenarios/shapes/target.h"

namespace cusp::scenarios {

class Reference;

/// The named targets that the rubric asks for, in the order of SeveralTargets::asked().
[[nodiscard]] std::vector<const Region*> asked_targets(const Scenario& scenario);

class SeveralTargets {
 public:
  struct One {
    std::string name;
    std::size_t part;  // of the whole target's union
    std::shared_ptr<const Reference> reference;
  };

  /// Those that the rubric asks for: tens of milliseconds each.
  SeveralTargets(const Scenario& scenario, const std::shared_ptr<const Specimen>& specimen);
  std::span<const One> asked() const noexcept { return asked_; }
  /// The one part of the whole target that reaches into a box, by its number; nullopt: none does, or several do.
  [[nodiscard]] std::optional<std::size_t> only_part(Vec3 low, Vec3 high) const noexcept;
  /// The volume with the cuts of this target alone: those within it, and those that lie nearer to it than to any other part. Where
  /// two cavities meet beside their targets, each ends half-way, as at a wall.
  [[nodiscard]] Volume cavity(const Volume& volume, const One& target) const;

 private:
  /// How far p lies on the other side of the border of the target's own cuts, mm, at least; below 0: of its own.
  double beyond_mm(std::size_t part, Vec3 p) const noexcept;

  std::vector<TargetShape> parts_;
  double rounding_mm_ = 0;  // of the whole, where its parts meet
  std::vector<One> asked_;
};

}  // namespace cusp::scenarios
