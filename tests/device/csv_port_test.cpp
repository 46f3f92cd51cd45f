#include "device/scripted/csv_port.h"
#include "engine/loop/haptic_loop.h"
#include "tests/engine/loop/block_scene.h"
#include "tests/modules.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>
#include <string>
#include <string_view>

namespace cusp::test {
namespace {

using Clock = std::chrono::steady_clock;

constexpr const char* kHeader = "elapsed_us,x,y,z,qx,qy,qz,qw,buttons,pedal\n";

std::string with_header(std::string_view rows) {
  std::string text = kHeader;
  return text.append(rows);
}

/// The rows as a trace: the header line, and the bur column if a row has a bur.
std::string text_of(const std::vector<TraceRow>& rows) {
  const bool burs = std::ranges::any_of(rows, [](const TraceRow& row) { return row.bur != 0; });
  std::ostringstream out;
  out << "elapsed_us,x,y,z,qx,qy,qz,qw,buttons,pedal" << (burs ? ",bur\n" : "\n");
  for (const TraceRow& r : rows) {
    out << r.elapsed_us << ',' << r.x << ',' << r.y << ',' << r.z << ',' << r.qx << ',' << r.qy << ',' << r.qz << ','
        << r.qw << ',' << r.buttons << ',' << r.pedal;
    if (burs) out << ',' << r.bur;
    out << '\n';
  }
  return out.str();
}

TraceError error_of(const std::string& text, std::string* where = nullptr) {
  const auto rows = parse_trace(text);
  if (rows) {
    ADD_FAILURE() << "it was accepted: " << text;
    return TraceError::empty;
  }
  if (where != nullptr) *where = rows.error().where;
  return rows.error().code;
}

std::filesystem::path file_with(const std::string& text) {
  const auto path =
      std::filesystem::temp_directory_path() / ("cusp-trace-" + std::to_string(std::random_device{}()) + ".csv");
  std::ofstream(path, std::ios::binary) << text;
  return path;
}

TEST(CsvTrace, ReadsTheStepsOwnIntegers) {
  const auto rows = parse_trace(with_header("1000,-12345,0,2147483647,0,0,0,32767,1,65535\r\n"));
  ASSERT_TRUE(rows);
  ASSERT_EQ(rows->size(), 1u);
  const TraceRow row = rows->front();
  EXPECT_EQ(row.x, -12345);
  EXPECT_EQ(row.z, 2147483647);
  EXPECT_EQ(row.pedal, 65535);
  const Sample sample = sample_of(row);
  EXPECT_EQ(sample.position_mm.x, -1.2345);  // 0.1 µm a unit
  EXPECT_EQ(sample.orientation, Quat(1, 0, 0, 0));
  EXPECT_EQ(sample.buttons, 1);
}

TEST(CsvTrace, TakesABurColumnAndNoHeader) {
  const auto rows = parse_trace("1000,0,0,0,0,0,0,32767,0,0,3\n1000,1,0,0,0,0,0,32767,0,0,4");
  ASSERT_TRUE(rows);
  ASSERT_EQ(rows->size(), 2u);
  EXPECT_EQ(rows->at(1).bur, 4);
}

TEST(CsvTrace, RefusesBrokenRowsWithLineAndColumn) {
  const std::string good = "1000,0,0,0,0,0,0,32767,0,0\n";
  std::string where;
  EXPECT_EQ(error_of(kHeader + good + "1000,0,0,zero,0,0,0,32767,0,0\n", &where), TraceError::not_a_number);
  EXPECT_EQ(where, "3:4");
  EXPECT_EQ(error_of(good + "1000,0,0,0.5,0,0,0,32767,0,0\n", &where), TraceError::not_a_number);
  EXPECT_EQ(where, "2:4");
  EXPECT_EQ(error_of(good + "1000,0,0,,0,0,0,32767,0,0\n", &where), TraceError::not_a_number);
  EXPECT_EQ(error_of(good + "1000,2147483648,0,0,0,0,0,32767,0,0\n", &where), TraceError::out_of_range);
  EXPECT_EQ(where, "2:2");
  EXPECT_EQ(error_of(good + "-1,0,0,0,0,0,0,32767,0,0\n", &where), TraceError::out_of_range);
  EXPECT_EQ(where, "2:1");
  EXPECT_EQ(error_of("1000,0,0,0,0,0,0,32768,0,0\n"), TraceError::out_of_range);
  EXPECT_EQ(error_of("1000,0,0,0,0,0,0,32767,65536,0\n"), TraceError::out_of_range);
  EXPECT_EQ(error_of("99999999999999999999,0,0,0,0,0,0,32767,0,0\n"), TraceError::out_of_range);
  EXPECT_EQ(error_of(good + "1000,0,0\n", &where), TraceError::wrong_columns);
  EXPECT_EQ(where, "2:3");
  EXPECT_EQ(error_of(good + "1000,0,0,0,0,0,0,32767,0,0,0\n"), TraceError::wrong_columns);
  EXPECT_EQ(error_of(good + "\n" + good, &where), TraceError::wrong_columns);
  EXPECT_EQ(where, "2:1");
  EXPECT_EQ(error_of("1000,0,0,0,0,0,0,20000,0,0\n", &where), TraceError::not_a_rotation);
  EXPECT_EQ(where, "1:5");
  EXPECT_EQ(error_of("time,x,y,z\n" + good), TraceError::bad_header);
  EXPECT_EQ(error_of(""), TraceError::empty);
  EXPECT_EQ(error_of(kHeader), TraceError::empty);
}

TEST(CsvTrace, EveryValueReadsBackAsWritten) {
  const unsigned seed = 7;
  SCOPED_TRACE(seed);
  std::mt19937_64 random(seed);
  for (int round = 0; round < 50; ++round) {
    std::vector<TraceRow> rows(1 + random() % 40);
    for (TraceRow& row : rows) {
      row.elapsed_us = static_cast<std::uint32_t>(random());
      row.x = static_cast<std::int32_t>(random());
      row.y = static_cast<std::int32_t>(random());
      row.z = static_cast<std::int32_t>(random());
      row.qx = 32767;
      row.qw = 0;
      row.buttons = static_cast<std::uint16_t>(random());
      row.pedal = static_cast<std::uint16_t>(random());
      row.bur = round % 2 == 0 ? 0 : static_cast<std::uint16_t>(random());
    }
    const auto again = parse_trace(text_of(rows));
    ASSERT_TRUE(again);
    ASSERT_EQ(*again, rows);
  }
}

TEST(CsvTrace, NoTextBreaksTheReader) {
  const unsigned seed = 11;
  SCOPED_TRACE(seed);
  std::mt19937_64 random(seed);
  const std::string good = with_header("1000,-5,6,7,0,0,0,32767,1,65535\r\n1000,-5,6,8,0,0,0,32767,1,65535\n");
  for (int round = 0; round < 20000; ++round) {
    std::string text = good;
    for (int change = 0; change < 3; ++change) {
      const std::size_t at = random() % text.size();
      if (random() % 3 == 0) {
        text.erase(at, 1 + random() % 8);
      } else {
        text[at] = static_cast<char>(random());
      }
      if (text.empty()) break;
    }
    const auto rows = parse_trace(text);
    EXPECT_LE(rows ? rows->size() : 0, 4u);
  }
}

TEST(CsvPort, PlaysEachRowOnceAndIsGoneAtTheEnd) {
  const auto path = file_with(with_header("1000,10000,0,0,0,0,0,32767,0,0\n1000,20000,0,0,0,0,0,32767,1,0\n"));
  CsvPort port(path, Pacing::at_once);
  ASSERT_TRUE(port.open());
  EXPECT_EQ(port.wait({}).position_mm.x, 1);
  const Sample second = port.wait({});
  EXPECT_EQ(second.position_mm.x, 2);
  EXPECT_EQ(second.status, Sample::Status::fresh);
  EXPECT_EQ(port.wait({}).status, Sample::Status::gone);
  EXPECT_EQ(port.wait({}).status, Sample::Status::gone);
  ASSERT_TRUE(port.open());  // plays again from the start
  EXPECT_EQ(port.wait({}).position_mm.x, 1);
  std::filesystem::remove(path);
}

TEST(CsvPort, GivesEachRowAtItsTimeAndLateBefore) {
  std::vector<TraceRow> rows(3);
  rows[1].elapsed_us = 1000;
  rows[1].x = 10000;
  rows[2].elapsed_us = 3000;
  rows[2].x = 20000;
  CsvPort port(rows, Pacing::real_time);
  ASSERT_TRUE(port.open());
  auto at = Clock::now() - std::chrono::hours(1);  // deadlines long past: nothing sleeps
  const auto next = [&] { return port.wait(at += std::chrono::milliseconds(1)); };
  EXPECT_EQ(next().position_mm.x, 0);
  EXPECT_EQ(next().position_mm.x, 1);
  for (int i = 0; i < 2; ++i) {
    const Sample early = next();
    EXPECT_EQ(early.status, Sample::Status::late);
    EXPECT_EQ(early.position_mm.x, 1);
  }
  EXPECT_EQ(next().position_mm.x, 2);
  EXPECT_EQ(next().status, Sample::Status::gone);
}

TEST(CsvPort, SaysWhatIsWrongWithAFile) {
  const auto missing = CsvPort("/nowhere/at/all.csv", Pacing::at_once).open();
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().code, PortError::not_found);
  const auto folder = CsvPort(std::filesystem::temp_directory_path(), Pacing::at_once).open();
  ASSERT_FALSE(folder);
  EXPECT_EQ(folder.error().code, PortError::io);
  const auto failing = CsvPort("/proc/self/mem", Pacing::at_once).open();  // reading at address 0 fails with EIO
  ASSERT_FALSE(failing);
  EXPECT_EQ(failing.error().code, PortError::io);
  const auto path = file_with(with_header("1000,0,0,0,0,0,0,32767,0\n"));
  CsvPort broken(path, Pacing::at_once);
  const auto opened = broken.open();
  ASSERT_FALSE(opened);
  EXPECT_EQ(opened.error().code, PortError::bad_file);
  EXPECT_EQ(opened.error().where, path.string() + ":2:9");
  EXPECT_EQ(opened.error().detail, "wrong_columns");
  EXPECT_EQ(broken.wait({}).status, Sample::Status::gone);
  std::filesystem::remove(path);
}

TEST(CsvPort, MarksOfTheRecorderBecomeItsStatusAgain) {
  TraceRow row;
  row.buttons = 1 | 1u << 15;
  EXPECT_EQ(sample_of(row).status, Sample::Status::late);
  EXPECT_EQ(sample_of(row).buttons, 1);
  row.buttons = 1u << 14;
  EXPECT_EQ(sample_of(row).status, Sample::Status::gone);
  row.buttons = 1u << 14 | 1u << 15;
  EXPECT_TRUE(std::isnan(sample_of(row).position_mm.x));
}

TEST(CsvPort, IsOverAfterItsLastRowAndNotAfterALoss) {
  std::vector<TraceRow> rows(3);
  rows[0].buttons = rows[2].buttons = 1u << 14;
  CsvPort port(rows, Pacing::at_once);
  ASSERT_TRUE(port.open());
  EXPECT_EQ(port.wait({}).status, Sample::Status::gone);
  EXPECT_FALSE(port.over());
  EXPECT_EQ(port.wait({}).status, Sample::Status::fresh);
  EXPECT_EQ(port.wait({}).status, Sample::Status::gone);
  EXPECT_FALSE(port.over()) << "the last row is a tick of its own";
  EXPECT_EQ(port.wait({}).status, Sample::Status::gone);
  EXPECT_TRUE(port.over());
  ASSERT_TRUE(port.open());
  EXPECT_FALSE(port.over());
}

/// The rows that the loop records when it plays the text as `play` does.
std::vector<TraceRow> recorded_from(const std::string& text) {
  const auto path = file_with(text);
  CsvPort port(path, Pacing::at_once);
  EXPECT_TRUE(port.open());
  VirtualLoop loop(port, StepState(test::block_scene()));
  loop.take_elapsed_from([&port, next = std::size_t{0}]() mutable { return port.rows()[next++].elapsed_us; });
  loop.run(1'000'000);
  EXPECT_EQ(loop.hand_over().end.load(), LoopEnd::port_over);
  std::filesystem::remove(path);
  std::vector<TraceRow> rows;
  StepInput in;
  while (loop.hand_over().inputs.pop(in)) {
    rows.push_back({in.elapsed_us, in.x, in.y, in.z, in.qx, in.qy, in.qz, in.qw, in.buttons, in.pedal, in.bur});
  }
  return rows;
}

TEST(CsvPort, ATraceWithALossInItsMiddleIsPlayedToItsEndAndRecordedToTheSameBits) {
  std::vector<TraceRow> rows;
  StepInput in;
  for (std::uint64_t i = 0; i < 400; ++i) {
    in = quantise(test::drilling_sample(i), 900 + static_cast<std::uint32_t>(i % 3) * 100, in);
    rows.push_back({in.elapsed_us, in.x, in.y, in.z, in.qx, in.qy, in.qz, in.qw, in.buttons, in.pedal, in.bur});
  }
  constexpr std::uint16_t kRearm = StepInput::kRearm, kGone = StepInput::kGone, kNotFinite = StepInput::kNotFinite;
  const auto mark = [&rows](std::size_t row, std::uint16_t bits) { rows[row].buttons |= bits; };
  // As a record has them: without a position the last one stands, and the row after a fault re-arms.
  const auto repeats = [&rows](std::size_t row) { rows[row].x = rows[row - 1].x, rows[row].y = rows[row - 1].y, rows[row].z = rows[row - 1].z; };
  for (const std::size_t row : {150u, 151u, 152u, 300u, 399u}) repeats(row);
  mark(150, kGone);
  mark(151, kGone | kRearm);
  mark(152, kGone | kRearm);
  mark(153, kRearm);
  mark(200, StepInput::kLate);
  mark(250, kRearm);  // after a pause, without a fault
  mark(300, kNotFinite);
  mark(301, kRearm);
  mark(399, kGone);
  const std::vector<TraceRow> recorded = recorded_from(text_of(rows));
  ASSERT_EQ(recorded.size(), rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) EXPECT_EQ(recorded[i], rows[i]) << i << ": " << recorded[i].buttons << ", not " << rows[i].buttons;
  EXPECT_EQ(text_of(recorded), text_of(rows));
}

}  // namespace
}  // namespace cusp::test
