#include "scenarios/metrics/process.h"

#include <cmath>

namespace cusp {

void Process::add(const StepOutput& output) noexcept {
  const std::uint64_t dt = output.elapsed_us > elapsed_us_ ? output.elapsed_us - elapsed_us_ : 0;
  elapsed_us_ += dt;
  if (output.cutting) cutting_us_ += dt;
  if (output.has(PhenomenonSign::dry)) dry_us_ += dt;
  if (output.has(PhenomenonSign::overheated) && overheated_++ == 0) overheated_at_mm_ = output.proxy_mm;
  if (static_cast<double>(output.heat_k) > heat_peak_k_) {
    heat_peak_k_ = static_cast<double>(output.heat_k);
    heat_peak_at_mm_ = output.proxy_mm;
  }
  if (!output.contact) return;
  const Vec3 f = output.force_raw_n;
  const double n = std::sqrt(f.x * f.x + f.y * f.y + f.z * f.z);
  contact_us_ += dt;
  impulse_ += n * static_cast<double>(dt);
  if (n > peak_n_) {
    peak_n_ = n;
    peak_at_mm_ = output.proxy_mm;
  }
}

}  // namespace cusp
