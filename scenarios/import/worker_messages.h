/// Messages from the import's child process to its parent: lines of a mark and tab-separated fields on the child's standard
/// output. Lines without the mark come from foreign libraries and are ignored.
#pragma once

#include <charconv>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scenarios/import/import.h"

namespace cusp::scenarios {

inline constexpr std::string_view kWorkerVerb = "import-child";

template <class Number>
std::string text_of(Number value) {
  char buffer[40];
  return {buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr};
}
template <class Number>
std::optional<Number> number_of(std::string_view t) {
  Number value{};
  const auto [end, error] = std::from_chars(t.data(), t.data() + t.size(), value);
  if (error != std::errc{} || end != t.data() + t.size()) return std::nullopt;
  return value;
}

/// One line with its mark and its end.
std::string message_line(const std::vector<std::string>& fields);
/// The fields of a line without its end; nullopt for a line without the mark.
std::optional<std::vector<std::string>> fields_of_line(std::string_view line);

// Jobs as arguments of the child, in the order in which they are written, and back. nullopt: not such a job.
std::vector<std::string> arguments_of(const MeshImport& job, const std::filesystem::path& out);
std::vector<std::string> arguments_of(const ImageImport& job, const std::filesystem::path& out);
std::optional<MeshImport> mesh_job(std::span<const std::string_view> arguments, std::filesystem::path& out);
std::optional<ImageImport> image_job(std::span<const std::string_view> arguments, std::filesystem::path& out);

// Results, each as the fields of one message. nullopt: the fields are no such message.
std::vector<std::string> message_of(const MeshInfo& mesh);
std::vector<std::string> message_of(const ImageInfo& image);
std::vector<std::string> message_of(const ImportRemark& remark);
std::optional<MeshInfo> mesh_info_of(const std::vector<std::string>& fields);
std::optional<ImageInfo> image_info_of(const std::vector<std::string>& fields);
std::optional<ImportRemark> remark_of(const std::vector<std::string>& fields);

}  // namespace cusp::scenarios
