#include "scenarios/import/nrrd_data.h"

#include <zlib.h>

#include <array>
#include <new>

namespace cusp {
namespace {

constexpr std::size_t kPiece = 65536;
constexpr int kGzip = 15 + 16;  // zlib: the largest window, with a gzip head and tail
// Of a tooth at 0.05 mm level 4 makes 3 % more bytes than 6 in three quarters of the time.
constexpr int kLevel = 4;

}  // namespace

struct NrrdSource::Packed {
  z_stream z{};
  std::array<unsigned char, kPiece> in;
  bool ended = false;
};

NrrdSource::NrrdSource(std::istream& in, bool gzip) : in_(in) {
  if (!gzip) return;
  packed_ = std::make_unique<Packed>();
  if (inflateInit2(&packed_->z, kGzip) != Z_OK) throw std::bad_alloc();
}

NrrdSource::~NrrdSource() {
  if (packed_) inflateEnd(&packed_->z);
}

Result<void, ImportError> NrrdSource::read(std::span<std::byte> out) {
  if (!packed_) {
    in_.read(reinterpret_cast<char*>(out.data()), static_cast<std::streamsize>(out.size()));
    if (static_cast<std::size_t>(in_.gcount()) == out.size()) return {};
    return std::unexpected(in_.bad() ? ImportError::io : ImportError::truncated);
  }
  z_stream& z = packed_->z;
  z.next_out = reinterpret_cast<unsigned char*>(out.data());
  z.avail_out = static_cast<uInt>(out.size());
  while (z.avail_out > 0) {
    if (packed_->ended) return std::unexpected(ImportError::truncated);
    if (z.avail_in == 0) {
      in_.read(reinterpret_cast<char*>(packed_->in.data()), kPiece);
      if (in_.bad()) return std::unexpected(ImportError::io);
      z.next_in = packed_->in.data();
      z.avail_in = static_cast<uInt>(in_.gcount());
      if (z.avail_in == 0) return std::unexpected(ImportError::truncated);
    }
    const int status = inflate(&z, Z_NO_FLUSH);
    if (status == Z_STREAM_END) packed_->ended = true;
    else if (status != Z_OK && status != Z_BUF_ERROR) return std::unexpected(ImportError::corrupt);
  }
  return {};
}

Result<void, ImportError> NrrdSource::expect_end() {
  std::byte beyond;
  const auto more = read({&beyond, 1});
  if (more) return std::unexpected(ImportError::corrupt);
  if (more.error() != ImportError::truncated) return more;
  // A packed stream that is cut within its check sum has not ended.
  if (packed_ && !packed_->ended) return more;
  return {};
}

struct NrrdSink::Packed {
  z_stream z{};
  std::array<unsigned char, kPiece> out;
};

NrrdSink::NrrdSink(std::ostream& out) : out_(out), packed_(std::make_unique<Packed>()) {
  if (deflateInit2(&packed_->z, kLevel, Z_DEFLATED, kGzip, 8, Z_DEFAULT_STRATEGY) != Z_OK) throw std::bad_alloc();
}

NrrdSink::~NrrdSink() { deflateEnd(&packed_->z); }

void NrrdSink::pump(int flush) {
  z_stream& z = packed_->z;
  do {
    z.next_out = packed_->out.data();
    z.avail_out = kPiece;
    deflate(&z, flush);
    out_.write(reinterpret_cast<const char*>(packed_->out.data()), static_cast<std::streamsize>(kPiece - z.avail_out));
  } while (z.avail_out == 0);
}

void NrrdSink::write(std::span<const std::byte> bytes) {
  packed_->z.next_in = reinterpret_cast<unsigned char*>(const_cast<std::byte*>(bytes.data()));
  packed_->z.avail_in = static_cast<uInt>(bytes.size());
  pump(Z_NO_FLUSH);
}

bool NrrdSink::finish() {
  packed_->z.avail_in = 0;
  pump(Z_FINISH);
  out_.flush();
  return out_.good();
}

}  // namespace cusp
