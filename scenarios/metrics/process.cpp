#include "scenarios/metrics/process.h"

#include <bit>
#include <cmath>

namespace cusp::scenarios {

namespace {

constexpr std::uint64_t kProcessFormat = 0x31434F5250;  // "PROC1"

struct Writer {
  std::vector<std::byte> out;
  void operator()(std::uint64_t value) {
    for (int i = 0; i < 8; ++i) out.push_back(static_cast<std::byte>(value >> (8 * i)));
  }
  void operator()(int value) { (*this)(static_cast<std::uint64_t>(value)); }
  void operator()(double value) { (*this)(std::bit_cast<std::uint64_t>(value)); }
  void operator()(const Vec3& value) {
    (*this)(value.x);
    (*this)(value.y);
    (*this)(value.z);
  }
};

struct Reader {
  std::span<const std::byte> bytes;
  bool good = true;
  void operator()(std::uint64_t& value) {
    good = good && bytes.size() >= 8;
    if (!good) return;
    value = 0;
    for (std::size_t i = 0; i < 8; ++i) value |= std::to_integer<std::uint64_t>(bytes[i]) << (8 * i);
    bytes = bytes.subspan(8);
  }
  void operator()(int& value) {
    std::uint64_t wide = 0;
    (*this)(wide);
    value = static_cast<int>(wide);
    good = good && value >= 0 && static_cast<std::uint64_t>(value) == wide;
  }
  void operator()(double& value) {
    std::uint64_t bits = 0;
    (*this)(bits);
    value = std::bit_cast<double>(bits);
    good = good && std::isfinite(value);
  }
  void operator()(Vec3& value) {
    (*this)(value.x);
    (*this)(value.y);
    (*this)(value.z);
  }
};

}  // namespace

std::vector<std::byte> Process::save() const {
  Writer writer;
  writer(kProcessFormat);
  visit(*this, writer);
  return std::move(writer.out);
}

std::optional<Process> Process::restore(std::span<const std::byte> bytes) {
  Reader reader{bytes};
  std::uint64_t format = 0;
  reader(format);
  Process process;
  visit(process, reader);
  if (!reader.good || format != kProcessFormat || !reader.bytes.empty()) return std::nullopt;
  return process;
}

Process Process::lasting(double time_s, double dry_s) noexcept {
  Process out;
  out.elapsed_us_ = static_cast<std::uint64_t>(1e6 * time_s);
  out.dry_us_ = static_cast<std::uint64_t>(1e6 * dry_s);
  return out;
}

std::optional<double> known_force_n(const StepOutput& output) noexcept {
  if (!output.contact || output.deferred) return std::nullopt;
  const Vec3 f = output.force_raw_n;
  return std::sqrt(f.x * f.x + f.y * f.y + f.z * f.z);
}

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
  const std::optional<double> n = known_force_n(output);
  if (!n) return;
  contact_us_ += dt;
  impulse_ += *n * static_cast<double>(dt);
  if (*n > peak_n_) {
    peak_n_ = *n;
    peak_at_mm_ = output.proxy_mm;
  }
}

}  // namespace cusp::scenarios
