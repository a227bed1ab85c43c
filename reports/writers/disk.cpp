// SPDX-License-Identifier: Apache-2.0
#include "reports/writers/disk.hpp"

#include <dirent.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <charconv>
#include <climits>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <new>
#include <utility>
#include <vector>

#include "reports/model/errors.hpp"
#include "reports/model/text.hpp"

namespace polhode::report::disk {
namespace {

constexpr std::string_view mark = ".partial-";

// Closes on every way out; close_checked is for the way that counts.
struct descriptor {
  int value;
  explicit descriptor(int opened) : value(opened) {}
  descriptor(const descriptor&) = delete;
  descriptor& operator=(const descriptor&) = delete;
  ~descriptor() {
    if (value >= 0) ::close(value);
  }
  int close_checked() { return ::close(std::exchange(value, -1)); }
};

bool is_unsupported(int error) { return error == EINVAL || error == ENOSYS || error == ENOTSUP; }

// The process that a staging name speaks of; 0 where it is no such name.
pid_t maker_of(std::string_view name) {
  const auto at = name.rfind(mark);
  if (name.empty() || name.front() != '.' || at == std::string_view::npos || at < 2) return 0;
  const auto digits = name.substr(at + mark.size());
  pid_t maker = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), maker);
  return error == std::errc() && end == digits.data() + digits.size() && maker > 0 ? maker : 0;
}

// Dead by its number, and nobody holds the lock: a number alone may belong to another container's process.
bool is_abandoned(const fs::path& directory, pid_t maker) {
  if (maker != ::getpid() && (::kill(maker, 0) == 0 || errno != ESRCH)) return false;
  const descriptor opened(::open(directory.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
  return opened.value >= 0 && ::flock(opened.value, LOCK_EX | LOCK_NB) == 0;
}

// The directory staged last, and the hidden name under which it is emptied, where a signal's handler may read them.
std::array<char, PATH_MAX> staged_path, emptied_path;
std::atomic<bool> is_staged = false;

void remember_staged(const fs::path& directory) {
  const auto keep = [](const fs::path& path, std::array<char, PATH_MAX>& to) {
    if (path.native().size() >= to.size()) return false;
    std::memcpy(to.data(), path.c_str(), path.native().size() + 1);
    return true;
  };
  is_staged = false;
  const auto& name = directory.native();
  const auto emptied = name + name.substr(name.rfind(mark));  // twice its maker: stale where it is
  is_staged = keep(directory, staged_path) && keep(emptied, emptied_path);
}

// By system calls alone: nothing of the standard library may be asked in a handler.
void remove_folder(int where, const char* name) noexcept {
  const int folder = ::openat(where, name, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
  if (folder < 0) return;
  alignas(dirent64) std::array<char, 4096> entries;
  for (ssize_t count; (count = ::getdents64(folder, entries.data(), entries.size())) > 0;)
    for (ssize_t at = 0; at < count;) {
      const auto* entry = reinterpret_cast<const dirent64*>(entries.data() + at);
      at += entry->d_reclen;
      if (::unlinkat(folder, entry->d_name, 0) == 0) continue;
      if (std::strcmp(entry->d_name, ".") != 0 && std::strcmp(entry->d_name, "..") != 0)
        remove_folder(folder, entry->d_name);
    }
  ::close(folder);
  ::unlinkat(where, name, AT_REMOVEDIR);
}

}  // namespace

// Under its own name another thread could still put it in place, half empty.
void remove_last_staged() noexcept {
  if (!is_staged.exchange(false) || ::rename(staged_path.data(), emptied_path.data()) != 0) return;
  remove_folder(AT_FDCWD, emptied_path.data());
}

void fail(const fs::path& known_as, int error) {
  throw output_error(fmt::format("cannot write '{}': {}", one_line(known_as.string()), std::strerror(error)));
}

void write_file(const fs::path& file, std::string_view content, const fs::path& known_as) {
  descriptor opened(::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666));
  if (opened.value < 0) fail(known_as, errno);
  while (!content.empty()) {
    const auto written = ::write(opened.value, content.data(), content.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail(known_as, errno);
    content.remove_prefix(static_cast<std::size_t>(written));
  }
  if (::fsync(opened.value) != 0 && !is_unsupported(errno)) fail(known_as, errno);
  if (opened.close_checked() != 0 && errno != EINTR) fail(known_as, errno);
}

void make_directory(const fs::path& directory, const fs::path& known_as) {
  if (::mkdir(directory.c_str(), 0777) != 0) fail(known_as, errno);
}

void sync_directory(const fs::path& directory, const fs::path& known_as) {
  const descriptor opened(::open(directory.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (opened.value < 0) fail(known_as, errno);
  if (::fsync(opened.value) != 0 && !is_unsupported(errno)) fail(known_as, errno);
}

bool move_if_free(const fs::path& from, const fs::path& to, const fs::path& known_as) {
  if (::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0) return true;
  if (errno == EEXIST) return false;
  if (!is_unsupported(errno)) fail(known_as, errno);
  if (std::error_code ignored; fs::exists(fs::symlink_status(to, ignored))) return false;
  if (::rename(from.c_str(), to.c_str()) != 0) fail(known_as, errno);
  return true;
}

void put_in_place(const fs::path& from, const fs::path& to) {
  if (move_if_free(from, to, to)) return;
  if (::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_EXCHANGE) == 0) return;
  if (!is_unsupported(errno)) fail(to, errno);
  // This file system cannot exchange: the old one steps aside, and for a moment there is none.
  const fs::path aside = to.parent_path() / staging_name(to.filename().string() + ".old");
  if (::rename(to.c_str(), aside.c_str()) != 0) fail(to, errno);
  if (::rename(from.c_str(), to.c_str()) != 0) {
    const int error = errno;
    static_cast<void>(::rename(aside.c_str(), to.c_str()));
    fail(to, error);
  }
  std::error_code ignored;
  fs::remove_all(aside, ignored);
}

staging::staging(fs::path where, const fs::path& known_as) : path_(std::move(where)) {
  make_directory(path_, known_as);
  remember_staged(path_);
  lock_ = ::open(path_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (lock_ >= 0) static_cast<void>(::flock(lock_, LOCK_EX | LOCK_NB));
}

staging::~staging() {
  is_staged = false;
  try {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  } catch (const std::bad_alloc&) {  // the next run removes it
  }
  if (lock_ >= 0) ::close(lock_);
}

fs::path staging_name(std::string_view name) { return fmt::format(".{}{}{}", name, mark, ::getpid()); }

bool is_staging_name(std::string_view name) { return maker_of(name) != 0; }

void remove_stale(const fs::path& folder, std::string_view name) {
  const std::string wanted = name.empty() ? "." : fmt::format(".{}{}", name, mark);
  std::error_code ignored;
  std::vector<fs::path> found;
  for (fs::directory_iterator entry(folder, ignored), end; !ignored && entry != end; entry.increment(ignored)) {
    const auto entry_name = entry->path().filename().string();
    const pid_t maker = maker_of(entry_name);
    if (maker != 0 && entry_name.rfind(wanted, 0) == 0 && is_abandoned(entry->path(), maker))
      found.push_back(entry->path());
  }
  for (const auto& one : found) fs::remove_all(one, ignored);
}

void replace_file(const fs::path& file, std::string_view content, const fs::path& known_as) {
  constexpr std::string_view name = "file";
  const auto folder = file.parent_path();
  remove_stale(folder, name);
  const staging beside(folder / staging_name(name), known_as);
  const auto whole = beside.path() / name;
  write_file(whole, content, known_as);
  if (::rename(whole.c_str(), file.c_str()) != 0) fail(known_as, errno);
  sync_directory(folder, known_as);
}

}  // namespace polhode::report::disk
