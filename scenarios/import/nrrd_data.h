/// The data part of a NRRD file as a stream of bytes, unpacked in pieces of 64 KiB: a file that unpacks to more than its
/// header says costs no memory.
#pragma once

#include <cstddef>
#include <istream>
#include <memory>
#include <ostream>
#include <span>

#include "scenarios/import/import_error.h"

namespace cusp {

class NrrdSource {
 public:
  /// Reads on from where `in` stands; `in` outlives it.
  NrrdSource(std::istream& in, bool gzip);
  ~NrrdSource();
  NrrdSource(const NrrdSource&) = delete;
  NrrdSource& operator=(const NrrdSource&) = delete;

  /// Fills `out` whole: truncated, corrupt or io when that cannot be.
  [[nodiscard]] Result<void, ImportError> read(std::span<std::byte> out);
  /// Nothing may follow, and the packed data's own check sum must hold.
  [[nodiscard]] Result<void, ImportError> expect_end();

 private:
  struct Packed;
  std::istream& in_;
  std::unique_ptr<Packed> packed_;  // none: raw
};

class NrrdSink {
 public:
  explicit NrrdSink(std::ostream& out);
  ~NrrdSink();
  NrrdSink(const NrrdSink&) = delete;
  NrrdSink& operator=(const NrrdSink&) = delete;

  void write(std::span<const std::byte> bytes);
  /// Writes what is left. False when the stream refused anything since the start.
  [[nodiscard]] bool finish();

 private:
  void pump(int flush);
  struct Packed;
  std::ostream& out_;
  std::unique_ptr<Packed> packed_;
};

}  // namespace cusp
