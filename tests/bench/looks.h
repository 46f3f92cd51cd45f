/// How each method looks on every picture: its colour and mark never change, and neither tells it alone.
#pragma once

#include <string_view>

#include "tests/bench/names.h"
#include "tests/bench/svg.h"

namespace cusp::bench {

struct Look {
  std::string_view label;
  std::string_view colour;
  Mark mark;
};

constexpr Look look_of(Method method) {
  switch (method) {
    case Method::surface:
      return {"surface proxy (Cusp)", ink::kBlue, Mark::circle};
    case Method::occupancy:
      return {"occupancy proxy (the paper)", ink::kVermilion, Mark::square};
    case Method::occupancy_pivot:
      return {"occupancy, pivot only", ink::kOrange, Mark::diamond};
    case Method::ray:
      return {"ray proxy", ink::kGreen, Mark::triangle_up};
    case Method::penalty:
      return {"penalty", ink::kPurple, Mark::triangle_down};
    case Method::gradient:
      return {"gradient proxy", ink::kSky, Mark::hexagon};
  }
  return {"", ink::kText, Mark::circle};
}

}  // namespace cusp::bench
