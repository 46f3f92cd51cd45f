#include <elf.h>
#include <link.h>

#include <cstring>
#include <span>

#include "ui/session/program_id.h"

namespace cusp::ui {
namespace {

constexpr std::size_t kAlign = 4;
constexpr char kOwner[] = "GNU";

std::size_t aligned(std::size_t bytes) noexcept { return (bytes + kAlign - 1) / kAlign * kAlign; }

/// The build id among the notes of a segment, in hex; empty without one.
std::string build_id_in(std::span<const char> notes) {
  while (notes.size() >= sizeof(ElfW(Nhdr))) {
    ElfW(Nhdr) head{};
    std::memcpy(&head, notes.data(), sizeof head);
    const std::size_t name = sizeof head, text = name + aligned(head.n_namesz), end = text + aligned(head.n_descsz);
    if (end > notes.size()) break;
    if (head.n_type == NT_GNU_BUILD_ID && head.n_namesz == sizeof kOwner && std::memcmp(notes.data() + name, kOwner, sizeof kOwner) == 0) {
      constexpr const char* kDigits = "0123456789abcdef";
      std::string out;
      for (const char c : notes.subspan(text, head.n_descsz)) {
        const auto byte = static_cast<unsigned char>(c);
        out += kDigits[byte >> 4];
        out += kDigits[byte & 15];
      }
      return out;
    }
    notes = notes.subspan(end);
  }
  return {};
}

/// Of the first object: the program itself. Ends the walk.
int look_at_program(dl_phdr_info* info, std::size_t, void* found) {
  for (const ElfW(Phdr)& part : std::span(info->dlpi_phdr, info->dlpi_phnum)) {
    if (part.p_type != PT_NOTE) continue;
    const auto* notes = reinterpret_cast<const char*>(info->dlpi_addr + part.p_vaddr);
    if (std::string id = build_id_in({notes, part.p_memsz}); !id.empty()) *static_cast<std::string*>(found) = std::move(id);
  }
  return 1;
}

}  // namespace

std::optional<std::string> program_id() {
  std::string id;
  dl_iterate_phdr(look_at_program, &id);
  return id.empty() ? std::nullopt : std::optional(std::move(id));
}

}  // namespace cusp::ui
