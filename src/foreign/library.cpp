// SPDX-License-Identifier: Apache-2.0
#include "foreign/library.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>

#include <polhode/abi.h>

#include "foreign/naming.hpp"
#include "problem/drives.hpp"
#include "reports/model/errors.hpp"

namespace polhode::foreign {
namespace {

/// polhode_scene with what it points to. `parameter` finds its way back, as the struct is the first member.
struct told_scene {
  polhode_scene scene{};
  problem p;
  std::string json;
  std::vector<double> sigma;
  std::vector<std::vector<double>> parameters;

  explicit told_scene(const problem& of) : p(of), json(json_of(of)) {
    for (const auto& row : noise_vectors_of(p.scene)) sigma.insert(sigma.end(), row.begin(), row.end());
    sigma.resize(static_cast<std::size_t>(p.channels * p.components));  // channels that the scene leaves out are silent
    for (const auto& one : p.scene.parameters) {
      auto& flat = parameters.emplace_back();
      for (const auto& row : one.rows) flat.insert(flat.end(), row.begin(), row.end());
    }
    scene = {sizeof(polhode_scene),
             p.components,
             p.channels,
             p.dt,
             dissipation_of(p.scene),
             p.scene.name.c_str(),
             p.scene.system.c_str(),
             p.scene.momentum.data(),
             sigma.data(),
             find,
             json.c_str()};
  }
  told_scene(const told_scene&) = delete;
  told_scene& operator=(const told_scene&) = delete;

  static const double* find(const polhode_scene* from, const char* key, std::int32_t* rows, std::int32_t* columns) {
    const auto& all = *reinterpret_cast<const told_scene*>(from);
    for (std::size_t i = 0; i < all.parameters.size(); ++i) {
      const auto& one = all.p.scene.parameters[i];
      if (one.name != key || one.rows.empty()) continue;
      if (rows != nullptr) *rows = static_cast<std::int32_t>(one.rows.size());
      if (columns != nullptr) *columns = static_cast<std::int32_t>(one.rows[0].size());
      return all.parameters[i].data();
    }
    return nullptr;
  }
};

/// Calls into a library: what it throws is a failure of the integrator.
template <class Call>
int guarded(const char* what, Call call) {
  try {
    return call();
  } catch (const std::exception& e) {
    throw failure(fmt::format("{} threw an exception: {}", what, e.what()));
  } catch (...) {
    throw failure(fmt::format("{} threw an exception", what));
  }
}

class library_stepper final : public stepper {
 public:
  library_stepper(const polhode_integrator& of, const problem& p) : of_(of), told_(p) {
    std::array<char, 256> why{};
    if (const int code = guarded("open", [&] { return of_.open(&told_.scene, &self_, why.data(), why.size()); })) {
      why.back() = 0;
      throw refusal(fmt::format("open returned {}{}{}", code, why[0] ? ": " : "", why.data()));
    }
  }
  library_stepper(const library_stepper&) = delete;
  library_stepper& operator=(const library_stepper&) = delete;
  ~library_stepper() override {
    if (of_.close != nullptr) of_.close(self_);
  }

  void advance(const batch& b) override {
    // No equation depends on the time, and integrators that draw variables of their own are refused.
    const polhode_batch given{sizeof(polhode_batch), b.paths, b.steps, b.states, b.dw, b.area, b.seed, nullptr, nullptr};
    if (const int code = guarded("advance", [&] { return of_.advance(self_, &given); }))
      throw failure(fmt::format("advance returned {}", code));
  }

 private:
  const polhode_integrator& of_;
  told_scene told_;
  void* self_ = nullptr;
};

std::string text(const char* given) { return given == nullptr ? "" : given; }

description description_of(const polhode_integrator& i, const std::string& path) {
  const auto& c = i.claims;
  const auto has = [&](unsigned flag) { return (i.flags & flag) != 0; };
  description d{text(i.name), text(i.title), text(i.source),
                "library " + std::filesystem::path(path).filename().string()};
  d.takes = static_cast<noise_access>(i.takes);
  d.calculus = has(POLHODE_ITO) ? calculus::ito : calculus::stratonovich;
  d.implicit = has(POLHODE_IMPLICIT);
  d.poisson = has(POLHODE_POISSON);
  d.one_thread = has(POLHODE_ONE_THREAD);
  d.claims = {c.strong_commuting, c.strong_general, c.weak_one_vector, c.weak_isotropic,
              c.weak_general,     c.deterministic,  c.casimir,         c.casimir_deterministic};
  return d;
}

class library_integrator final : public integrator {
 public:
  library_integrator(const polhode_integrator& of, const std::string& path)
      : of_(of), about_(checked(description_of(of, path), path)) {}
  const description& about() const override { return about_; }
  std::unique_ptr<stepper> open(const problem& p) override { return std::make_unique<library_stepper>(of_, p); }
  bool within() const override { return true; }

 private:
  const polhode_integrator& of_;
  description about_;
};

/// A library finds its own functions before ours and the system's: libc has one that is called `advance`. Sanitizers
/// forbid it.
#if defined(RTLD_DEEPBIND) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
constexpr int how_to_load = RTLD_NOW | RTLD_LOCAL | RTLD_DEEPBIND;
#else
constexpr int how_to_load = RTLD_NOW | RTLD_LOCAL;
#endif

constexpr std::uint32_t least_size = offsetof(polhode_integrator, draws);  // what comes after was added

bool draws_variables(const polhode_integrator& i) {
  return i.size >= sizeof(polhode_integrator) && i.draws != nullptr && i.drawn > 0;
}

/// Integrators of another size than ours are stepped over by the size that they state.
const polhode_integrator& at(const polhode_integrator* first, int index) {
  const auto* bytes = reinterpret_cast<const char*>(first);
  return *reinterpret_cast<const polhode_integrator*>(bytes + static_cast<std::size_t>(index) * first->size);
}

}  // namespace

std::vector<std::unique_ptr<integrator>> open_library(const std::string& path) {
  const auto full = path.find('/') == std::string::npos ? "./" + path : path;  // no search through the system's folders
  void* handle = dlopen(full.c_str(), how_to_load);
  if (handle == nullptr) {
    const char* why = dlerror();
    throw input_error(fmt::format("{}: cannot be loaded as a library: {}", path, text(why)));
  }
  const auto entry = reinterpret_cast<decltype(&polhode_integrators)>(dlsym(handle, "polhode_integrators"));
  if (entry == nullptr)
    throw input_error(fmt::format(
        "{}: has no function polhode_integrators; accepted: a library with the entry of <polhode/abi.h>", path));
  std::int32_t count = 0;
  const polhode_integrator* first = nullptr;
  try {
    first = entry(POLHODE_ABI_VERSION, &count);
  } catch (...) {
    throw input_error(fmt::format("{}: polhode_integrators threw an exception", path));
  }
  if (first == nullptr || count < 1)
    throw input_error(
        fmt::format("{}: offers no integrator for version {} of the interface", path, POLHODE_ABI_VERSION));
  if (first->size < least_size)
    throw input_error(fmt::format("{}: its polhode_integrator has {} bytes; accepted: version {} with at least {}",
                                  path, first->size, POLHODE_ABI_VERSION, least_size));
  std::vector<std::unique_ptr<integrator>> out;
  for (int i = 0; i < count; ++i) {
    const auto& one = at(first, i);
    if (one.open == nullptr || one.advance == nullptr)
      throw input_error(fmt::format("{}: integrator {}: open and advance are needed", path, i + 1));
    if (draws_variables(one))
      throw input_error(fmt::format("{}: integrator {} draws random variables of kind {}; accepted so far: increments, "
                                    "areas, or numbers of its own from the seeds",
                                    path, i + 1, one.draws[0].kind));
    out.push_back(std::make_unique<library_integrator>(one, path));
  }
  return out;
}

}  // namespace polhode::foreign
