/// Writes that stop short, as on a full disk.
#pragma once

#include <sys/resource.h>

#include <csignal>
#include <cstdint>

#include <gtest/gtest.h>

namespace cusp::test {

/// During `work` the process writes no file beyond `bytes`: EFBIG.
template <class Work>
auto with_files_up_to(std::uintmax_t bytes, const Work& work) {
  rlimit before{};
  EXPECT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  std::signal(SIGXFSZ, SIG_IGN);
  const rlimit limit{bytes, before.rlim_max};
  EXPECT_EQ(setrlimit(RLIMIT_FSIZE, &limit), 0);
  auto done = work();
  EXPECT_EQ(setrlimit(RLIMIT_FSIZE, &before), 0);
  return done;
}

}  // namespace cusp::test
