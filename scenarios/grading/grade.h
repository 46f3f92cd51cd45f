/// A grade: measured values against a rubric, with reasons as codes and arguments, never as sentences.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/vec.h"
#include "scenarios/format/scenario.h"

namespace cusp::scenarios {

/// One measured quantity of the final volume or of the process.
struct Measure {
  std::string metric;              // key
  bool measured = true;            // false: could not be measured; never zero
  double value = 0;
  double uncertainty = 0;          // same unit, one-sided
  std::string unit;                // "%", "mm3", "mm", "deg", "s", "N"
  std::optional<Vec3> where_mm;    // place of the worst, for the pin on the tooth
};

inline Measure not_measured(std::string metric, std::string unit) {
  return {std::move(metric), false, 0.0, 0.0, std::move(unit), std::nullopt};
}

struct CriterionGrade {
  std::string id;                  // metric key
  Measure measure;
  std::string band;                // "ideal", "acceptable", "fail", "borderline" (edge nearer than the uncertainty), "not_measured",
                                   // "not_expressible" (measured, but beyond the device: no points)
  double points = 0, points_max = 0;  // of Grade::score_max; not rounded (maxima.h rounds). Evaluator 2: of the weight
  std::string reason_code;         // "full", "too_deep", "too_shallow", "too_little", "too_much", "too_dry", "too_warm",
                                   // "little_drilled", "not_measured" or "needs_dof"
  std::map<std::string, double> reason_args;  // "value", "limit", "lost"; of little_drilled "share" (0 to 1), "lost";
                                              // of needs_dof "value" (axes it needs), "limit" (axes of the device)
  bool counts_with_target = false;  // points only as far as the target was cut (mark_counted_with_target)
};

struct Grade {
  double score = 0;                // of 100
  double score_max = 100;
  double pass_mark = 70;
  bool passed = false;
  std::vector<std::string> critical;      // critical events that happened
  std::vector<CriterionGrade> criteria;   // in the rubric's order
  std::string evaluator = "14";           // version of measuring and marking; rises when a figure changes.
                                          // 2: what is kept intact counts in proportion to what was drilled
                                          // 3: points are of 100, evidence lies on the cut surface
                                          // 4: so does every depth, width, form and push; walls of a tree by face name
                                          // 5: isthmus at the cavosurface, axial wall below the pulpal floor, floor off rounded edges, contact by its gap
                                          // 6: no scratch is a wall of a ridge
                                          // 7: the pulp ends at its smoothed border, not at its voxels' corners
                                          // 8: the margin counts by its length
                                          // 9: a ridge cut through, a region gone whole and a target left out cost their points
                                          // 10: a box far off its target is measured; over-cut beside a leaning wall is that wall's
                                          // and an offset of a difference has its faces where they are cut
                                          // 11: nothing is left over a pulp that is gone whole, a step within a metric's range has an
                                          // edge, and a force counts once the proxy has converged
                                          // 12: the clearance is to the neighbour as it stood, however deep it was cut; a target whose
                                          // walls pass midway between voxels is known as well as any other; a hole is a depth
                                          // 13: of a tree too, and a box that is cut through has its height; a ridge counts from the
                                          // foot of its wall; nothing is left over the pulp of a tooth that is gone whole
                                          // 14: no ridge between plastic neighbours, of which it measured the far side
};

/// In points. Rounding moves a sum of criteria by less than 1e-12; people read tenths of a point. Test:
/// tests/scenarios/grading/pass_mark_test.cpp.
inline constexpr double kScoreSlack = 1e-6;

/// Whether the score is the pass mark or above it, but for the rounding of a sum. False if one of them is not a number.
[[nodiscard]] constexpr bool reaches(double score, double mark) noexcept { return score >= mark - kScoreSlack; }

}  // namespace cusp::scenarios
