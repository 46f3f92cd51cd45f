#include "ui/render/colours.h"

#include "scenarios/tissues/tissue_facts.h"
#include "ui/modules.h"

namespace cusp::ui {

std::array<Colour, kTissueCodes> tissue_colours() noexcept {
  std::array<Colour, kTissueCodes> out{};
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = colour_of(tissue_facts(static_cast<Tissue>(i)).colour.value);
  return out;
}

}  // namespace cusp::ui
