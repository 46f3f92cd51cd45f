/// Plays a CSV trace as a HapticPort: one row per wait(), a loss of the device included. After the last row it is `gone`
/// and over().
#pragma once

#include <chrono>
#include <filesystem>
#include <vector>

#include "device/scripted/csv_trace.h"
#include "engine/base/haptic_port.h"

namespace cusp::device {

enum class Pacing : std::uint8_t {
  real_time,  // delivers a row at its time; an earlier deadline gets the last row again, `late`
  at_once,    // every wait() delivers the next row without sleeping: for tests and sessions without a window
};

class CsvPort final : public HapticPort {
 public:
  CsvPort(std::filesystem::path file, Pacing pacing) : file_(std::move(file)), pacing_(pacing) {}
  CsvPort(std::vector<TraceRow> rows, Pacing pacing) : rows_(std::move(rows)), pacing_(pacing) {}

  /// not_found, no_permission, io, or bad_file with where "<file>:<line>:<column>" and the TraceError's key in detail.
  Result<void, PortFailure> open() override;
  Sample wait(std::chrono::steady_clock::time_point deadline) noexcept override;
  /// False after a row with the mark of a lost device: the rows after it follow.
  bool over() const noexcept override { return over_; }
  void write(const Feedback&) noexcept override {}
  DeviceLimits limits() const override;
  void close() noexcept override { open_ = false; }

  const std::vector<TraceRow>& rows() const noexcept { return rows_; }

 private:
  std::filesystem::path file_;
  std::vector<TraceRow> rows_;
  Pacing pacing_;
  std::size_t next_ = 0;
  bool open_ = false;
  bool started_ = false;
  bool over_ = false;  // a wait() found no row
  std::chrono::steady_clock::time_point due_{};  // of row next_
  Sample last_;
};

}  // namespace cusp::device
