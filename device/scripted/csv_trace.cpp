#include "device/scripted/csv_trace.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

namespace cusp::device {
namespace {

constexpr std::string_view kHeader = "elapsed_us,x,y,z,qx,qy,qz,qw,buttons,pedal";
constexpr std::string_view kHeaderWithBur = "elapsed_us,x,y,z,qx,qy,qz,qw,buttons,pedal,bur";
constexpr std::string_view kOlderHeaderWithBur = "elapsed_us,x,y,z,qx,qy,qz,qw,buttons,pedal,burr";
constexpr std::size_t kColumns = 10;
constexpr std::size_t kMostColumns = 11;
constexpr double kUnit = 32767.0;  // a quaternion's part of 1
constexpr std::uint16_t kGoneBit = 1u << 14;
constexpr std::uint16_t kLateBit = 1u << 15;

std::string place(std::size_t line, std::size_t column) { return std::to_string(line) + ":" + std::to_string(column); }

/// One line at a time; CR before LF belongs to the end of the line.
class Lines {
 public:
  explicit Lines(std::string_view text) : rest_(text) {}
  bool next(std::string_view& line) {
    if (rest_.empty()) return false;
    const std::size_t end = std::min(rest_.find('\n'), rest_.size());
    line = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    ++number_;
    return true;
  }
  std::size_t number() const noexcept { return number_; }

 private:
  std::string_view rest_;
  std::size_t number_ = 0;
};

struct Cells {
  std::array<std::string_view, kMostColumns> cell;
  std::size_t count = 0;  // kMostColumns + 1: more than fit
};

Cells split(std::string_view line) {
  Cells out;
  while (true) {
    const std::size_t end = std::min(line.find(','), line.size());
    if (out.count == kMostColumns) {
      ++out.count;
      return out;
    }
    out.cell[out.count++] = line.substr(0, end);
    if (end == line.size()) return out;
    line.remove_prefix(end + 1);
  }
}

/// Fills `row` cell by cell; remembers the first cell that does not read.
class RowReader {
 public:
  template <class Integer>
  void read(std::string_view cell, Integer& out) {
    ++column_;
    if (bad_column_ != 0) return;
    std::int64_t value = 0;
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    if (error == std::errc::result_out_of_range) return refuse(TraceError::out_of_range);
    if (error != std::errc{} || end != cell.data() + cell.size()) return refuse(TraceError::not_a_number);
    if (value < std::numeric_limits<Integer>::min() || value > std::numeric_limits<Integer>::max()) {
      return refuse(TraceError::out_of_range);
    }
    out = static_cast<Integer>(value);
  }
  void refuse(TraceError code) {
    bad_column_ = column_;
    code_ = code;
  }
  std::size_t bad_column() const noexcept { return bad_column_; }
  TraceError code() const noexcept { return code_; }

 private:
  std::size_t column_ = 0;
  std::size_t bad_column_ = 0;
  TraceError code_ = TraceError::not_a_number;
};

bool is_rotation(const TraceRow& row) {
  const double x = row.qx, y = row.qy, z = row.qz, w = row.qw;
  const double length = std::sqrt(x * x + y * y + z * z + w * w) / kUnit;
  return length > 0.98 && length < 1.02;
}

}  // namespace

std::string_view key_of(TraceError code) noexcept {
  switch (code) {
    case TraceError::empty:
      return "empty";
    case TraceError::bad_header:
      return "bad_header";
    case TraceError::wrong_columns:
      return "wrong_columns";
    case TraceError::not_a_number:
      return "not_a_number";
    case TraceError::out_of_range:
      return "out_of_range";
    case TraceError::not_a_rotation:
      return "not_a_rotation";
  }
  return "empty";
}

Result<std::vector<TraceRow>, TraceFailure> parse_trace(std::string_view text) {
  std::vector<TraceRow> rows;
  Lines lines(text);
  std::string_view line;
  std::size_t columns = 0;
  while (lines.next(line)) {
    if (line.empty() && rows.size() + columns > 0) {
      // Only the last line may be empty: a gap in the middle is a damaged file.
      std::string_view after;
      if (lines.next(after)) return fail(TraceError::wrong_columns, place(lines.number() - 1, 1));
      break;
    }
    if (lines.number() == 1 && !line.empty() && ((line.front() >= 'a' && line.front() <= 'z') || line.front() == '"')) {
      if (line != kHeader && line != kHeaderWithBur && line != kOlderHeaderWithBur)
        return fail(TraceError::bad_header, place(1, 1), std::string(line));
      columns = line == kHeader ? kColumns : kMostColumns;
      continue;
    }
    const Cells cells = split(line);
    if (columns == 0 && (cells.count == kColumns || cells.count == kMostColumns)) columns = cells.count;
    if (cells.count != columns)
      return fail(TraceError::wrong_columns, place(lines.number(), std::min(cells.count, kMostColumns)));
    TraceRow row;
    RowReader reader;
    reader.read(cells.cell[0], row.elapsed_us);
    reader.read(cells.cell[1], row.x);
    reader.read(cells.cell[2], row.y);
    reader.read(cells.cell[3], row.z);
    reader.read(cells.cell[4], row.qx);
    reader.read(cells.cell[5], row.qy);
    reader.read(cells.cell[6], row.qz);
    reader.read(cells.cell[7], row.qw);
    reader.read(cells.cell[8], row.buttons);
    reader.read(cells.cell[9], row.pedal);
    if (columns == kMostColumns) reader.read(cells.cell[10], row.bur);
    if (reader.bad_column() != 0) {
      return fail(reader.code(), place(lines.number(), reader.bad_column()),
                  std::string(cells.cell[reader.bad_column() - 1]));
    }
    if (!is_rotation(row)) return fail(TraceError::not_a_rotation, place(lines.number(), 5));
    rows.push_back(row);
  }
  if (rows.empty()) return fail(TraceError::empty, place(1, 1));
  return rows;
}

Sample sample_of(const TraceRow& row) noexcept {
  Sample sample;
  const bool gone = (row.buttons & kGoneBit) != 0, late = (row.buttons & kLateBit) != 0;
  if (gone != late) {
    sample.status = gone ? Sample::Status::gone : Sample::Status::late;
  } else {
    sample.status = Sample::Status::fresh;
  }
  // A position that is no number sets both bits again.
  sample.position_mm = gone && late ? Vec3(std::numeric_limits<double>::quiet_NaN()) : Vec3(row.x, row.y, row.z) / 1e4;
  sample.orientation = Quat(row.qw / kUnit, row.qx / kUnit, row.qy / kUnit, row.qz / kUnit);
  sample.buttons = static_cast<std::uint16_t>(row.buttons & ~(kGoneBit | kLateBit));
  sample.pedal = row.pedal;
  sample.bur = row.bur;
  return sample;
}

}  // namespace cusp::device
