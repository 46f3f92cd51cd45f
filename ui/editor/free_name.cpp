#include "ui/editor/free_name.h"

#include <algorithm>
#include <fstream>
#include <system_error>

#include "storage/base/files.h"

namespace cusp::ui {
namespace {

namespace fs = std::filesystem;

}  // namespace

Stored<std::string> write_under_free_name(const fs::path& folder, const std::string& wanted, const VolumeWriter& volume) {
  std::string name = wanted;
  for (int n = 2;; ++n) {
    const fs::path file = folder / name;
    const auto taken = write_new_file(file, {});
    if (taken) {
      if (auto written = volume.write(file); !written) {
        std::error_code ignored;
        fs::remove(file, ignored);
        return std::unexpected(written.error());
      }
      return name;
    }
    if (taken.error().code != StorageError::duplicate) return std::unexpected(taken.error());
    if (volume.is_it && volume.is_it(file)) return name;
    name = fs::path(wanted).stem().string() + '-' + std::to_string(n) + fs::path(wanted).extension().string();
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
