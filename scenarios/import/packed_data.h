/// The data part of a volume file as a stream of bytes, unpacked in blocks of 64 KiB: a file that unpacks to more than its
/// header states costs no memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <istream>
#include <memory>
#include <ostream>
#include <span>
#include <string>

#include "scenarios/import/import_error.h"

namespace cusp::scenarios {

/// Opens a regular file for reading: its length, or missing_file or io with the file's name.
[[nodiscard]] Result<std::uintmax_t, ImportFailure> open_volume_file(const std::filesystem::path& file, std::ifstream& in);

/// Lines of a NRRD header up to the blank one, which is taken from the stream too.
[[nodiscard]] Result<std::string, ImportFailure> read_nrrd_text(std::istream& in, const std::string& name);

/// deflate: gzip or zlib, whichever the bytes show; streams of gzip one behind the other are one.
enum class Packing : std::uint8_t { raw, deflate };

/// Sizes in bytes.
struct DataSize {
  std::uintmax_t file = 0, needed = 0;
};

/// Whether the rest of a stream of `size.file` bytes can hold `size.needed` bytes of data. Asked before any allocation.
bool data_can_be_there(std::istream& in, DataSize size, Packing packing);

class PackedSource {
 public:
  /// Reads on from the position of `in`; `in` outlives it.
  PackedSource(std::istream& in, Packing packing);
  ~PackedSource();
  PackedSource(const PackedSource&) = delete;
  PackedSource& operator=(const PackedSource&) = delete;

  /// Fills `out` whole: truncated, corrupt or io when that cannot be.
  [[nodiscard]] Result<void, ImportError> read(std::span<std::byte> out);
  /// Nothing may follow, and the packed data's own check sum must hold.
  [[nodiscard]] Result<void, ImportError> expect_end();

 private:
  struct Packed;
  std::istream& in_;
  std::unique_ptr<Packed> packed_;  // none: raw
};

class PackedSink {
 public:
  explicit PackedSink(std::ostream& out);
  ~PackedSink();
  PackedSink(const PackedSink&) = delete;
  PackedSink& operator=(const PackedSink&) = delete;

  void write(std::span<const std::byte> bytes);
  /// Writes what is left. The stream shows whether it has refused anything.
  void finish();

 private:
  void pump(int flush);
  struct Packed;
  std::ostream& out_;
  std::unique_ptr<Packed> packed_;
};

}  // namespace cusp::scenarios
