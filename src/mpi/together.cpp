// SPDX-License-Identifier: Apache-2.0
#include "cli/together.hpp"

#include <fmt/format.h>
#include <mpi.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <thread>

#include "cli/terminal/terminal.hpp"
#include "reports/writers/json.hpp"

namespace polhode::cli {
namespace {

constexpr std::size_t most_at_once = std::size_t{1} << 30U;  // MPI counts in int
constexpr int whole_world_tag = 0;

/// Sleeps until that is done, for MPI's own waiting takes a whole processor. False where it is not done by then.
bool awaited(MPI_Request request, std::chrono::steady_clock::time_point until) {
  for (int done = 0;; std::this_thread::sleep_for(std::chrono::milliseconds(1))) {
    MPI_Test(&request, &done, MPI_STATUS_IGNORE);
    if (done != 0) return true;
    if (std::chrono::steady_clock::now() > until) return false;
  }
}
void await(MPI_Request request) { awaited(request, std::chrono::steady_clock::time_point::max()); }

bool all_come(MPI_Comm where, std::chrono::steady_clock::time_point until) {
  MPI_Request request = MPI_REQUEST_NULL;
  MPI_Ibarrier(where, &request);
  return awaited(request, until);
}

class mpi_ranks final : public ranks {
 public:
  mpi_ranks() {
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    MPI_Comm_size(MPI_COMM_WORLD, &size_);
  }
  int rank() const override { return rank_; }
  int size() const override { return size_; }

  std::vector<std::string> told_by_all(const std::string& mine) const override {
    await_all();
    std::vector<std::string> out;
    for (int other = 0; other < size_; ++other) out.push_back(from(other, mine));
    return out;
  }

  std::optional<report::results> of_the_first(const std::optional<report::results>& mine) const override {
    await_all();
    const auto text = from(0, rank_ == 0 && mine ? report::to_json(*mine) : "");
    if (text.empty()) return std::nullopt;
    return rank_ == 0 ? mine : report::from_json(text);
  }

  std::vector<report::results> of_all(const report::results& mine) const override {
    std::vector<report::results> out;
    for (const auto& text : told_by_all(report::to_json(mine))) out.push_back(report::from_json(text));
    return out;
  }

  void to_the_first(const std::string& bytes, const std::function<void(const std::string&)>& take) const override {
    if (rank_ > 0) return send(bytes);
    for (int other = 1; other < size_; ++other) take(received(other));
  }

 private:
  static void await_all() { all_come(MPI_COMM_WORLD, std::chrono::steady_clock::time_point::max()); }
  static int piece(std::size_t left) { return static_cast<int>(std::min(left, most_at_once)); }

  /// What that rank gives, everywhere.
  std::string from(int root, const std::string& mine) const {
    std::uint64_t size = mine.size();
    MPI_Bcast(&size, 1, MPI_UINT64_T, root, MPI_COMM_WORLD);
    std::string text = rank_ == root ? mine : std::string(size, ' ');
    for (std::size_t at = 0; at < size; at += most_at_once)
      MPI_Bcast(text.data() + at, piece(size - at), MPI_CHAR, root, MPI_COMM_WORLD);
    return text;
  }

  static void send(const std::string& bytes) {
    const std::uint64_t size = bytes.size();
    MPI_Request taken = MPI_REQUEST_NULL;
    MPI_Issend(&size, 1, MPI_UINT64_T, 0, whole_world_tag, MPI_COMM_WORLD, &taken);
    await(taken);
    for (std::size_t at = 0; at < size; at += most_at_once)
      MPI_Send(bytes.data() + at, piece(size - at), MPI_CHAR, 0, whole_world_tag, MPI_COMM_WORLD);
  }

  static std::string received(int other) {
    std::uint64_t size = 0;
    MPI_Request sent = MPI_REQUEST_NULL;
    MPI_Irecv(&size, 1, MPI_UINT64_T, other, whole_world_tag, MPI_COMM_WORLD, &sent);
    await(sent);
    std::string bytes(size, ' ');
    for (std::size_t at = 0; at < size; at += most_at_once)
      MPI_Recv(bytes.data() + at, piece(size - at), MPI_CHAR, other, whole_world_tag, MPI_COMM_WORLD,
               MPI_STATUS_IGNORE);
    return bytes;
  }

  int rank_ = 0, size_ = 1;
};

const mpi_ranks* world = nullptr;
MPI_Comm failing = MPI_COMM_NULL;  // apart from where the others may be at work

}  // namespace

together::together(int* argc, char*** argv) {
  int provided = 0;
  MPI_Init_thread(argc, argv, MPI_THREAD_FUNNELED, &provided);  // threads compute, the first one speaks
  static const mpi_ranks all;
  world = &all;
  MPI_Comm_dup(MPI_COMM_WORLD, &failing);
}

together::~together() {
  MPI_Comm_free(&failing);
  MPI_Finalize();
}

const ranks* others() { return world != nullptr && world->size() > 1 ? world : nullptr; }
bool speaks() { return others() == nullptr || world->rank() == 0; }

int processes_here() {
  MPI_Comm here = MPI_COMM_NULL;
  int size = 1;
  MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &here);
  MPI_Comm_size(here, &size);
  MPI_Comm_free(&here);
  return size;
}

std::string signature() { return speaks() ? "" : fmt::format("rank {} of {}: ", world->rank(), world->size()); }

void fail(std::string_view fault, int code) {
  if (speaks()) print_error(fault);
  if (others() == nullptr || all_come(failing, std::chrono::steady_clock::now() + std::chrono::seconds(1))) return;
  if (!speaks()) print_error(signature().append(fault));
  MPI_Abort(MPI_COMM_WORLD, code);
}

}  // namespace polhode::cli
