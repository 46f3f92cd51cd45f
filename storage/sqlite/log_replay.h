/// The committed content of a write-ahead log, laid over the main file's pages. Source: SQLite's file format, 4.
/// Thread: any; works on memory alone.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>

namespace cusp::storage {

struct CommittedLog {
  std::uint32_t page_size = 0;                  // 0: nothing is committed in the log
  std::uint32_t pages = 0;                      // of the database after the last commit
  std::map<std::uint32_t, std::size_t> places;  // page number from 1 -> where its newest content begins in the log
};

/// Reads up to the first frame that is torn, of an older log, or uncommitted. Any bytes may be given.
CommittedLog read_log(std::span<const std::byte> log);
/// Pre: image holds log.pages pages.
void lay_over(const CommittedLog& log, std::span<const std::byte> bytes, std::span<std::byte> image);

}  // namespace cusp::storage
