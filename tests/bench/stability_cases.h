/// What methods are put through in `stability`, a row for each case, guard and hand. In the order of the map.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "tests/bench/options.h"
#include "tests/bench/rows.h"
#include "tests/bench/stability_run.h"

namespace cusp::bench {

struct CaseName {
  std::string_view key, label;  // as rows have it; as a person reads it
};

/// Stiffness swept to the limit (stability_kmax.h).
inline constexpr std::array<CaseName, 6> kPressCases = {{{"face", "face"},
                                                         {"edge", "edge"},
                                                         {"corner", "corner"},
                                                         {"groove", "60\u00b0 groove"},
                                                         {"pit", "fitting pit"},
                                                         {"channel", "own channel"}}};
/// Ways at one stiffness.
inline constexpr std::array<CaseName, 11> kWayCases = {{{"thin-wall", "thin wall, 1 m/s"},
                                                        {"tissues", "enamel to dentine"},
                                                        {"vanishing", "tissue vanishes"},
                                                        {"islands", "islands left"},
                                                         {"fragment", "fragment cut loose"},
                                                        {"narrow-slot", "slot too narrow"},
                                                        {"start-inside", "starts inside"},
                                                        {"volume-edge", "edge of the volume"},
                                                        {"voxel-size", "voxels 0.2 to 0.04"},
                                                        {"late-ticks", "ticks late to 50 ms"},
                                                        {"grip-weight", "weight of the grip"}}};
/// What a device or a session does wrong while the bur is in contact.
inline constexpr std::array<CaseName, 8> kFaultCases = {{{"frozen", "frozen"},
                                                         {"jump", "jumps 20 mm"},
                                                         {"nan", "not a number"},
                                                         {"infinite", "infinite"},
                                                         {"out-of-range", "out of range"},
                                                         {"device-gone", "device vanishes"},
                                                         {"specimen-exchange", "specimen exchanged"},
                                                         {"bur-exchange", "bur exchanged"}}};
/// The paper's three.
inline constexpr std::array<CaseName, 3> kTaskCases = {
    {{"displacement", "displacement"}, {"exploration", "exploration"}, {"perforation", "perforation"}}};

inline constexpr std::int64_t kMostRuns = 10000;

/// What a row is measured with.
struct CaseRun {
  std::string_view key;
  Method method = Method::surface;
  bool guard = true;
  Setting setting;
  double voxel_mm = 10.0 / 128;
  double bur_radius_mm = 0.25;
  double budget_s = 1.0;  // of the core's time: no further run is begun after it; one always is
  std::int64_t most_runs = kMostRuns;
  std::uint64_t seed = 1;
  bool settle = false;  // a k_max that five seeds leave open is found again with more (stability_sets.h)
};

/// One row. Pre: the key is of kWayCases, kFaultCases or kTaskCases.
Row run_case(const CaseRun& what);

Row row_of(const CaseRun& what);
Row run_thin_wall(const CaseRun& what);
Row run_way(const CaseRun& what);
Row run_vanishing(const CaseRun& what);
Row run_fragment(const CaseRun& what);
Row run_start_inside(const CaseRun& what);
Row run_weight(const CaseRun& what);
Row run_fault(const CaseRun& what);
Row run_task(const CaseRun& what);

}  // namespace cusp::bench
