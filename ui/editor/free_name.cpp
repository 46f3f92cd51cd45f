#include "ui/editor/free_name.h"

#include <algorithm>
#include <fstream>
#include <system_error>

#include "scenarios/import/left_parts.h"
#include "storage/base/files.h"

namespace cusp::ui {
namespace {

namespace fs = std::filesystem;

/// NAME, NAME-2, NAME-3, …
std::string numbered(const fs::path& wanted, int n) {
  if (n == 1) return wanted.string();
  return wanted.stem().string() + '-' + std::to_string(n) + wanted.extension().string();
}

/// A volume without a name yet. If the program is killed, what next writes to the folder removes it a day later (left_parts.h).
class UnnamedVolume {
 public:
  explicit UnnamedVolume(const fs::path& folder) : file_(folder / ("volume" + std::string(kPartMark) + Uuid::v7().text().substr(24))) {}
  ~UnnamedVolume() {
    std::error_code ignored;
    fs::remove(file_, ignored);
  }
  UnnamedVolume(const UnnamedVolume&) = delete;
  UnnamedVolume& operator=(const UnnamedVolume&) = delete;

  /// Writes it at the first call.
  Stored<void> write(const VolumeWriter& volume) {
    if (written_) return {};
    const auto done = volume.write(file_);
    written_ = done.has_value();
    return done;
  }
  const fs::path& file() const { return file_; }

 private:
  fs::path file_;
  bool written_ = false;
};

}  // namespace

Stored<std::string> write_under_free_name(const fs::path& folder, const std::string& wanted, const VolumeWriter& volume) {
  UnnamedVolume fresh(folder);
  for (int n = 1;; ++n) {
    const std::string name = numbered(wanted, n);
    const fs::path file = folder / name;
    std::error_code ignored;
    if (!fs::exists(fs::symlink_status(file, ignored))) {
      if (auto written = fresh.write(volume); !written) {
        if (written.error().where == fresh.file().string()) written.error().where = file.string();
        return std::unexpected(written.error());
      }
      const auto named = rename_new(fresh.file(), file);
      if (named) return name;
      if (named.error().code != StorageError::duplicate) return std::unexpected(named.error());
    }
    if (volume.is_it && volume.is_it(file)) return name;
  }
}

bool hold_the_same(const fs::path& a, const fs::path& b) {
  constexpr std::size_t kPieceBytes = 1 << 16;
  std::error_code error;
  if (fs::file_size(a, error) != fs::file_size(b, error) || error) return false;
  std::ifstream one(a, std::ios::binary), other(b, std::ios::binary);
  std::string of_one(kPieceBytes, '\0'), of_other(kPieceBytes, '\0');
  do {
    one.read(of_one.data(), static_cast<std::streamsize>(of_one.size()));
    other.read(of_other.data(), static_cast<std::streamsize>(of_other.size()));
    if (one.gcount() != other.gcount() || !std::equal(of_one.begin(), of_one.begin() + one.gcount(), of_other.begin())) return false;
  } while (one && other);
  return one.eof() && other.eof();
}

}  // namespace cusp::ui
