#include "device/scripted/csv_port.h"

#include <algorithm>
#include <fstream>
#include <string>
#include <thread>

namespace cusp::device {

Result<void, PortFailure> CsvPort::open() {
  if (!file_.empty()) {
    std::error_code error;
    const auto kind = std::filesystem::status(file_, error).type();
    if (kind == std::filesystem::file_type::not_found) return fail(PortError::not_found, file_.string());
    if (kind != std::filesystem::file_type::regular) return fail(PortError::io, file_.string());
    std::ifstream file(file_, std::ios::binary);
    if (!file) return fail(PortError::no_permission, file_.string());
    std::string text;
    std::vector<char> part(std::size_t{1} << 16);
    while (file.read(part.data(), static_cast<std::streamsize>(part.size())), file.gcount() > 0)
      text.append(part.data(), static_cast<std::size_t>(file.gcount()));
    if (file.bad()) return fail(PortError::io, file_.string());
    auto rows = parse_trace(text);
    if (!rows) {
      return fail(PortError::bad_file, file_.string() + ":" + rows.error().where,
                  std::string(key_of(rows.error().code)));
    }
    rows_ = std::move(*rows);
  }
  next_ = 0;
  open_ = true;
  started_ = false;
  over_ = false;
  last_ = Sample{};
  return {};
}

Sample CsvPort::wait(std::chrono::steady_clock::time_point deadline) noexcept {
  if (!open_ || next_ >= rows_.size()) {
    if (pacing_ == Pacing::real_time) std::this_thread::sleep_until(deadline);
    over_ = true;
    last_.status = Sample::Status::gone;
    return last_;
  }
  const TraceRow& row = rows_[next_];
  if (pacing_ == Pacing::real_time) {
    if (!started_) due_ = deadline;  // the first row comes at once; the others by their own times after it
    started_ = true;
    if (due_ > deadline) {
      std::this_thread::sleep_until(deadline);
      Sample repeated = last_;
      repeated.status = Sample::Status::late;
      return repeated;
    }
    std::this_thread::sleep_until(due_);
  }
  ++next_;
  if (next_ < rows_.size()) due_ += std::chrono::microseconds(rows_[next_].elapsed_us);
  last_ = sample_of(row);
  return last_;
}

DeviceLimits CsvPort::limits() const {
  DeviceLimits limits;
  limits.name = "Recorded motion";
  limits.device_class = "scripted";
  limits.rotation_axes = 3;
  limits.max_stiffness_n_per_mm = 20.0;  // no hand stands in the loop: any stiffness a scenario may name
  limits.closed_loop = false;
  limits.has_own_clock = true;
  return limits;
}

}  // namespace cusp::device
