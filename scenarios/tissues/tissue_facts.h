/// The default feel, look and sound of each tissue: tissues.json, built in. An exercise may override the figures. Every
/// figure has its source; one that nobody verified is marked, and the interface shows the mark.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "engine/base/result.h"
#include "engine/volume/tissue.h"
#include "scenarios/modules.h"

namespace cusp::scenarios {

template <class Value>
struct Sourced {
  Value value{};
  std::string source;    // key of tissues.json's sources
  bool verified = false; // false: general knowledge, "[M]"
};

struct TissueFacts {
  Sourced<double> stiffness_n_per_mm;  // K of the contact force, (0, 20]
  Sourced<double> speed_mm_s;          // at full wear, [0, 100]
  Sourced<std::uint32_t> colour;       // 0xRRGGBB, sRGB
  Sourced<double> tone_hz;             // middle of the noise that cutting it makes, (0, 20000]
  Sourced<double> loudness;            // of that noise, [0, 1]
  Sourced<bool> critical;              // opening it fails an attempt if the rubric lists it
};

/// By tissue code; codes without a name (13 to 15, and 16 to 31, the scenario's own) have figures of "own", their colours
/// take turns, but for those of grown teeth (29 to 31, scenarios/teeth/own_tissues.h). [empty] is enamel's colour with nothing else.
using TissueTable = std::array<TissueFacts, kTissueCodes>;

enum class TissueTableError : std::uint8_t {
  bad_json,
  bad_value,        // not a number, a colour or a truth value, or out of its range
  unknown_tissue,   // no key of tissue.h, or one twice
  missing,          // a tissue or a key is not there
  unknown_source,   // a figure without a source, or with one that the file does not explain
};

/// `where`: JSON pointer.
[[nodiscard]] Result<TissueTable, Failure<TissueTableError>> read_tissue_table(std::string_view text);

/// The program's own table. The first call reads it: not on the haptic thread.
const TissueFacts& tissue_facts(Tissue tissue) noexcept;

}  // namespace cusp::scenarios
