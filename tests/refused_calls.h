/// System calls that fail as a drive or a full disk lets them fail.
#pragma once

#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace cusp::test {

/// No errno: the call kills the process.
inline constexpr std::uint32_t kKills = 0xFFFFFFFF;

/// A system call, and the errno that it fails with, or kKills.
struct RefusedCall {
  long number;
  std::uint32_t error;
};

/// The calls that make a hard link. EPERM: as on FAT, which has none.
inline std::vector<RefusedCall> links_refused(std::uint32_t error) {
  std::vector<RefusedCall> calls = {{SYS_linkat, error}};
#ifdef SYS_link
  calls.push_back({SYS_link, error});
#endif
  return calls;
}

/// Of this thread alone, until it ends. False: the kernel admits no filter.
inline bool refuse_calls(const std::vector<RefusedCall>& calls) {
  std::vector<sock_filter> program;
  program.push_back(BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)));
  for (const RefusedCall& call : calls) {
    program.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, static_cast<std::uint32_t>(call.number), 0, 1));
    program.push_back(BPF_STMT(BPF_RET | BPF_K, call.error == kKills ? SECCOMP_RET_KILL_PROCESS : SECCOMP_RET_ERRNO | call.error));
  }
  program.push_back(BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW));
  sock_fprog filter{};
  filter.len = static_cast<unsigned short>(program.size());
  filter.filter = program.data();
  return prctl(PR_SET_NO_NEW_PRIVS, 1UL, 0UL, 0UL, 0UL) == 0 && prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &filter) == 0;
}

}  // namespace cusp::test
