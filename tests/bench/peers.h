/// Other programs' figures, for the chart: built unmodified and measured elsewhere, on a 2-vCPU EPYC VM, g++ 12, -O3
/// -march=native, one pinned core, 128^3 voxels in 10 mm, device point 0.3 mm below the offset surface. The speed is
/// that of a slide at 50 mm/s; the angle is the mean over face and sphere (R 4 mm), of that slide or, where none was
/// taken, of presses.
#pragma once

#include <array>
#include <string_view>

namespace cusp::bench {

struct Peer {
  std::string_view name;
  double burr_radius_mm;
  double updates_per_s;
  double face_deg, sphere_deg;
  bool pressed;  // the angle is of presses
};

inline constexpr std::array<Peer, 7> kPeers = {{
    {"CHAI3D 3.3.0", 0.25, 75e3, 17.8, 25.5, false},
    {"Kobra, Chan's proxy", 0.25, 99e3, 16.6, 11.6, true},
    {"Kobra, Agus' penalty", 0.25, 447e3, 8.8, 7.4, true},
    {"iMSTK, exact distance", 0.25, 306e3, 18.0, 37.0, false},
    {"CHAI3D 3.3.0", 0.5, 22e3, 15.9, 19.5, false},
    {"Kobra, Chan's proxy", 0.5, 95e3, 19.0, 11.0, true},
    {"Kobra, Agus' penalty", 0.5, 90e3, 0.75, 1.2, true},
}};
inline constexpr std::string_view kPeersMachine = "2-vCPU EPYC VM";

/// The paper's rates on its 2012 desktop (Core i5, 3.1 GHz), "0.5 mm" burr; it gives no accuracy.
inline constexpr double kPaperExploration = 62e3, kPaperPerforation = 50e3;

}  // namespace cusp::bench
