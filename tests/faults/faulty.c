// SPDX-License-Identifier: Apache-2.0
/* Preloaded into a program: calls of one kind fail, or end it.

   POLHODE_FAULT="KINDS N HOW WHAT [BYTES]"
     KINDS   letters: w write, s fsync, r rename, x rename by exchange or where nothing stands, o open for writing,
             l open for reading, d mkdir, c close, u remove, t a new thread, m memory
     N       the first call that fails, counted from main on; of memory, blocks of BYTES or more
     HOW     once, or on: every later one too
     WHAT    a value of errno; 0: SIGKILL in place of the call; -1: half of it is written, which is no fault
   POLHODE_FAULT_COUNT=FILE  two 64-bit counters: calls of these kinds, and how many of them failed

   Standard streams are spared: the program has to say what went wrong. */
#define _GNU_SOURCE
#include <dirent.h>
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <pthread.h>
#include <signal.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/uio.h>
#include <unistd.h>

extern void *__libc_malloc(size_t), *__libc_calloc(size_t, size_t), *__libc_realloc(void *, size_t), *__libc_memalign(size_t, size_t);

static struct { int64_t calls, faults; } own, *count = &own;
static char kinds[16], how[8];
static long long first, what, least;
static int in_main;

static int armed(char kind) {
  if (!in_main || strchr(kinds, kind) == NULL) return 0;
  const int64_t n = __atomic_add_fetch(&count->calls, 1, __ATOMIC_SEQ_CST);
  if (n < first || (n > first && how[1] == 'n' && how[2] == 'c')) return 0;
  __atomic_add_fetch(&count->faults, 1, __ATOMIC_SEQ_CST);
  if (what == 0) raise(SIGKILL);
  return 1;
}

static int fails(char kind) {
  if (!armed(kind)) return 0;
  errno = (int)what;
  return 1;
}

#define REAL(name) ((__typeof__(&name))(intptr_t)dlsym(RTLD_NEXT, #name))

static size_t part(int fd, size_t size, int *failed) {
  *failed = 0;
  if (fd <= 2 || !armed('w')) return size;
  errno = (int)what;
  *failed = what > 0;
  return what < 0 && size > 1 ? size / 2 : size;
}
ssize_t write(int fd, const void *from, size_t size) {
  int failed;
  size = part(fd, size, &failed);
  return failed ? -1 : REAL(write)(fd, from, size);
}
ssize_t pwrite(int fd, const void *from, size_t size, off_t at) {
  int failed;
  size = part(fd, size, &failed);
  return failed ? -1 : REAL(pwrite)(fd, from, size, at);
}
ssize_t pwrite64(int fd, const void *from, size_t size, off64_t at) { return pwrite(fd, from, size, at); }
ssize_t writev(int fd, const struct iovec *from, int n) {
  int failed;
  const size_t half = part(fd, n > 0 ? from[0].iov_len : 0, &failed);
  if (failed) return -1;
  return n > 0 && half != from[0].iov_len ? REAL(write)(fd, from[0].iov_base, half) : REAL(writev)(fd, from, n);
}

int fsync(int fd) { return fails('s') ? -1 : REAL(fsync)(fd); }
int fdatasync(int fd) { return fails('s') ? -1 : REAL(fdatasync)(fd); }
int rename(const char *a, const char *b) { return fails('r') ? -1 : REAL(rename)(a, b); }
int renameat2(int f, const char *a, int t, const char *b, unsigned flags) { return fails('x') ? -1 : REAL(renameat2)(f, a, t, b, flags); }
int mkdir(const char *name, mode_t mode) { return fails('d') ? -1 : REAL(mkdir)(name, mode); }
int unlink(const char *name) { return fails('u') ? -1 : REAL(unlink)(name); }
int unlinkat(int in, const char *name, int flags) { return fails('u') ? -1 : REAL(unlinkat)(in, name, flags); }
int rmdir(const char *name) { return fails('u') ? -1 : REAL(rmdir)(name); }
int remove(const char *name) { return fails('u') ? -1 : REAL(remove)(name); }
int close(int fd) {
  const int failed = fd > 2 && fails('c'), result = REAL(close)(fd);
  return failed ? (errno = (int)what, -1) : result;
}
int fclose(FILE *file) {
  const int failed = fails('c'), result = REAL(fclose)(file);
  return failed ? (errno = (int)what, EOF) : result;
}

static char kind_of(int flags) { return (flags & O_ACCMODE) == O_RDONLY && !(flags & O_CREAT) ? 'l' : 'o'; }
static mode_t mode_of(int flags, va_list rest) { return flags & (O_CREAT | O_TMPFILE) ? va_arg(rest, mode_t) : 0; }
#define OPENS(name, parameters, ...)                                  \
  int name parameters {                                               \
    va_list rest;                                                     \
    va_start(rest, flags);                                            \
    const mode_t mode = mode_of(flags, rest);                         \
    va_end(rest);                                                     \
    return fails(kind_of(flags)) ? -1 : REAL(name)(__VA_ARGS__);      \
  }
OPENS(open, (const char *path, int flags, ...), path, flags, mode)
OPENS(open64, (const char *path, int flags, ...), path, flags, mode)
OPENS(openat, (int in, const char *path, int flags, ...), in, path, flags, mode)
OPENS(openat64, (int in, const char *path, int flags, ...), in, path, flags, mode)
FILE *fopen(const char *path, const char *mode) { return fails(*mode == 'r' ? 'l' : 'o') ? NULL : REAL(fopen)(path, mode); }
FILE *fopen64(const char *path, const char *mode) { return fails(*mode == 'r' ? 'l' : 'o') ? NULL : REAL(fopen64)(path, mode); }
DIR *opendir(const char *path) { return fails('l') ? NULL : REAL(opendir)(path); }

int pthread_create(pthread_t *made, const pthread_attr_t *how, void *(*run)(void *), void *with) {
  return fails('t') ? (int)what : REAL(pthread_create)(made, how, run, with);
}

static int none_left(size_t size) { return size >= (size_t)least && fails('m'); }
void *malloc(size_t size) { return none_left(size) ? NULL : __libc_malloc(size); }
void *calloc(size_t n, size_t size) { return none_left(n * size) ? NULL : __libc_calloc(n, size); }
void *realloc(void *old, size_t size) { return none_left(size) ? NULL : __libc_realloc(old, size); }
void *memalign(size_t to, size_t size) { return none_left(size) ? NULL : __libc_memalign(to, size); }
void *aligned_alloc(size_t to, size_t size) { return memalign(to, size); }
int posix_memalign(void **at, size_t to, size_t size) { return (*at = memalign(to, size)) == NULL ? ENOMEM : 0; }

static void prepare(void) {
  const char *given = getenv("POLHODE_FAULT"), *file = getenv("POLHODE_FAULT_COUNT");
  if (given == NULL || sscanf(given, "%15s %lld %7s %lld %lld", kinds, &first, how, &what, &least) < 4) return;
  const int fd = file == NULL ? -1 : REAL(open)(file, O_RDWR);
  void *shared = fd < 0 ? MAP_FAILED : mmap(NULL, sizeof own, PROT_READ | PROT_WRITE, MAP_SHARED, fd, 0);
  if (fd >= 0) REAL(close)(fd);
  if (shared != MAP_FAILED) count = shared;
  in_main = 1;
}

static int (*real_main)(int, char **, char **);
static int counted_main(int argc, char **argv, char **environment) {
  prepare();
  return real_main(argc, argv, environment);
}
typedef int start(int (*)(int, char **, char **), int, char **, void (*)(void), void (*)(void), void (*)(void), void *);
int __libc_start_main(int (*to)(int, char **, char **), int argc, char **argv, void (*a)(void), void (*b)(void), void (*c)(void), void *end) {
  real_main = to;
  return ((start *)(intptr_t)dlsym(RTLD_NEXT, "__libc_start_main"))(counted_main, argc, argv, a, b, c, end);
}
