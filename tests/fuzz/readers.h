/// Each own reader of volume files, and that of scenario.json, given bytes and nothing else. It must read or refuse, and what it reads must be whole.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace cusp::fuzz {

using Reader = void (*)(std::span<const std::uint8_t> bytes);

void nrrd_specimen(std::span<const std::uint8_t> bytes);
void nrrd_image(std::span<const std::uint8_t> bytes);
void metaimage(std::span<const std::uint8_t> bytes);
void binvox(std::span<const std::uint8_t> bytes);
void scenario(std::span<const std::uint8_t> bytes);

struct Target {
  std::string_view name;  // also the folder of its corpus
  Reader read;
};
inline constexpr Target kTargets[] = {
    {"nrrd_specimen", nrrd_specimen}, {"nrrd_image", nrrd_image}, {"metaimage", metaimage}, {"binvox", binvox}, {"scenario", scenario}};

}  // namespace cusp::fuzz
