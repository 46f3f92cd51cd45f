#include "tests/storage/failing_vfs.h"

#include <sqlite3.h>

#include <cerrno>
#include <cstdlib>
#include <new>
#include <utility>

namespace cusp::test {
namespace {

Failing failing = Failing::nothing;
int fail_at = 0;
int seen = 0;
int last_errno = 0;
std::function<void(std::string_view)> opening;

int answer(int io_code) {
  switch (failing) {
    case Failing::no_index:
      return SQLITE_FULL;
    case Failing::disk_full:
      return seen >= fail_at ? SQLITE_FULL : SQLITE_OK;
    case Failing::short_write:
    case Failing::over_quota:
    case Failing::too_large:
    case Failing::io_error:
      return seen >= fail_at ? io_code : SQLITE_OK;
    case Failing::any_call:
    case Failing::once:
      return seen == fail_at ? io_code : SQLITE_OK;
    default:
      return SQLITE_OK;
  }
}

int errno_of(int status) {
  if (failing == Failing::over_quota) return EDQUOT;
  if (failing == Failing::too_large) return EFBIG;
  return status == SQLITE_FULL ? ENOSPC : EIO;
}

/// Status of the next write or sync, with an errno as a disk sets it.
int verdict(int io_code) {
  ++seen;
  const int status = answer(io_code);
  if (status != SQLITE_OK) errno = last_errno = errno_of(status);
  return status;
}
/// Status of a call that writes nothing.
int verdict_of_other(int io_code) { return failing == Failing::any_call ? verdict(io_code) : SQLITE_OK; }

struct File {
  sqlite3_file base;
  sqlite3_file* real;  // follows in the same memory
};
sqlite3_file* real(sqlite3_file* file) { return reinterpret_cast<File*>(file)->real; }

int close(sqlite3_file* f) { return real(f)->pMethods->xClose(real(f)); }
int read(sqlite3_file* f, void* to, int n, sqlite3_int64 at) {
  if (const int bad = verdict_of_other(SQLITE_IOERR_READ); bad != SQLITE_OK) return bad;
  return real(f)->pMethods->xRead(real(f), to, n, at);
}
int write(sqlite3_file* f, const void* from, int n, sqlite3_int64 at) {
  if (const int bad = verdict(SQLITE_IOERR_WRITE); bad != SQLITE_OK) {
    if (failing == Failing::short_write && seen == fail_at) real(f)->pMethods->xWrite(real(f), from, n / 2, at);
    return bad;
  }
  return real(f)->pMethods->xWrite(real(f), from, n, at);
}
int truncate(sqlite3_file* f, sqlite3_int64 n) {
  if (const int bad = verdict(SQLITE_IOERR_TRUNCATE); bad != SQLITE_OK) {
    // A full disk can truncate.
    if (bad != SQLITE_FULL) return bad;
  }
  return real(f)->pMethods->xTruncate(real(f), n);
}
int sync(sqlite3_file* f, int flags) {
  if (const int bad = verdict(SQLITE_IOERR_FSYNC); bad != SQLITE_OK) return bad;
  return real(f)->pMethods->xSync(real(f), flags);
}
int file_size(sqlite3_file* f, sqlite3_int64* n) {
  if (const int bad = verdict_of_other(SQLITE_IOERR_FSTAT); bad != SQLITE_OK) return bad;
  return real(f)->pMethods->xFileSize(real(f), n);
}
int lock(sqlite3_file* f, int n) {
  if (const int bad = verdict_of_other(SQLITE_IOERR_LOCK); bad != SQLITE_OK) return bad;
  return real(f)->pMethods->xLock(real(f), n);
}
int unlock(sqlite3_file* f, int n) { return real(f)->pMethods->xUnlock(real(f), n); }
int check_lock(sqlite3_file* f, int* n) { return real(f)->pMethods->xCheckReservedLock(real(f), n); }
int control(sqlite3_file* f, int op, void* arg) {
  if (op == SQLITE_FCNTL_LAST_ERRNO && last_errno != 0) {
    *static_cast<int*>(arg) = last_errno;
    return SQLITE_OK;
  }
  return real(f)->pMethods->xFileControl(real(f), op, arg);
}
int sector(sqlite3_file* f) { return real(f)->pMethods->xSectorSize(real(f)); }
int traits(sqlite3_file* f) { return real(f)->pMethods->xDeviceCharacteristics(real(f)); }
int shm_map(sqlite3_file* f, int page, int size, int extend, void volatile** to) {
  if (const int bad = verdict_of_other(SQLITE_IOERR_SHMMAP); bad != SQLITE_OK) return bad;
  // Existing pages of the index can still be mapped.
  if (failing == Failing::no_index && extend != 0) {
    const int status = real(f)->pMethods->xShmMap(real(f), page, size, 0, to);
    if (status != SQLITE_OK || *to != nullptr) return status;
    errno = last_errno = ENOSPC;
    return SQLITE_IOERR_SHMSIZE;
  }
  return real(f)->pMethods->xShmMap(real(f), page, size, extend, to);
}
int shm_lock(sqlite3_file* f, int at, int n, int flags) { return real(f)->pMethods->xShmLock(real(f), at, n, flags); }
void shm_barrier(sqlite3_file* f) { real(f)->pMethods->xShmBarrier(real(f)); }
int shm_unmap(sqlite3_file* f, int remove) { return real(f)->pMethods->xShmUnmap(real(f), remove); }

// Version 2: with shared memory for the write-ahead log, without memory mapping, so that every write comes by here.
const sqlite3_io_methods kMethods = {2,        close,       read,       write,   truncate, sync,   file_size,
                                     lock,     unlock,      check_lock, control, sector,   traits, shm_map,
                                     shm_lock, shm_barrier, shm_unmap,  nullptr, nullptr};

sqlite3_vfs* system_vfs = nullptr;

int open(sqlite3_vfs*, const char* name, sqlite3_file* file, int flags, int* out_flags) {
  auto* mine = reinterpret_cast<File*>(file);
  mine->base.pMethods = nullptr;
  mine->real = reinterpret_cast<sqlite3_file*>(mine + 1);
  if (opening && name != nullptr) opening(name);
  if (const int bad = verdict_of_other(SQLITE_CANTOPEN); bad != SQLITE_OK) return bad;
  if (failing == Failing::read_only) {
    if ((flags & (SQLITE_OPEN_WAL | SQLITE_OPEN_MAIN_JOURNAL)) != 0) return SQLITE_CANTOPEN;
    flags = (flags & ~(SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE)) | SQLITE_OPEN_READONLY;
  }
  const int status = system_vfs->xOpen(system_vfs, name, mine->real, flags, out_flags);
  if (mine->real->pMethods != nullptr) mine->base.pMethods = &kMethods;
  return status;
}

int remove(sqlite3_vfs*, const char* name, int sync_folder) {
  if (const int bad = verdict_of_other(SQLITE_IOERR_DELETE); bad != SQLITE_OK) return bad;
  return system_vfs->xDelete(system_vfs, name, sync_folder);
}

}  // namespace

std::string failing_vfs() {
  static sqlite3_vfs vfs;
  if (system_vfs == nullptr) {
    system_vfs = sqlite3_vfs_find(nullptr);
    vfs = *system_vfs;  // paths, randomness and time of the system
    vfs.szOsFile = static_cast<int>(sizeof(File)) + system_vfs->szOsFile;
    vfs.zName = "failing";
    vfs.pNext = nullptr;
    vfs.xOpen = open;
    vfs.xDelete = remove;
    vfs.xGetLastError = [](sqlite3_vfs* own, int size, char* text) {
      return last_errno != 0 ? last_errno : system_vfs->xGetLastError(own, size, text);
    };
    sqlite3_vfs_register(&vfs, 0);
  }
  return "failing";
}

void fail_from(Failing how, int n) {
  failing = how;
  fail_at = n;
  seen = 0;
  last_errno = 0;
}

int operations_seen() { return seen; }

void at_opening(std::function<void(std::string_view path)> call) { opening = std::move(call); }

}  // namespace cusp::test
