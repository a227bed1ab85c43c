// SPDX-License-Identifier: Apache-2.0
#include "bench/summary.hpp"

#include <fmt/core.h>

#include "bench/catalogue.hpp"
#include "bench/counted_flops.hpp"
#include "bench/nominal_flops.hpp"

namespace polhode::bench {
namespace {

/// A number in its column, or a dash where it was not measured or does not apply.
std::string cell(std::optional<double> value, int width, int digits, const char* unit = "") {
  return value ? fmt::format("{:>{}.{}f}{}", *value, width, digits, unit)
               : fmt::format("{:>{}}{}", "-", width, std::string(std::string_view(unit).size(), ' '));
}

class summary {
 public:
  explicit summary(const timings& t) : t_(t), widest_(usable_isas().back()) {}

  void print() const {
    fmt::print(
        "\nCPU time, the least of the repetitions; ratios within this run. Paper: I=(1,2,3), theta=sigma=1/2, "
        "dt=0.01.\n");
    peaks();
    schemes();
    other_systems();
    features();
    instruction_sets();
    headers();
    normals();
    threads();
  }

 private:
  std::optional<double> cpu(const std::string& key) const {
    const auto t = t_.of(key);
    return t ? std::optional(t->cpu) : std::nullopt;
  }
  std::optional<double> ns(const std::string& key) const { return over(cpu(key), 1e-9); }
  static std::optional<double> over(std::optional<double> a, std::optional<double> b) {
    return a && b ? std::optional(*a / *b) : std::nullopt;
  }

  void peaks() const {
    fmt::print("\nFMA peak of a core:");
    for (const isa level : usable_isas())
      fmt::print("  {} {}", name_of(level), cell(over(1e-9, cpu(peak_key(level))), 0, 1, " GFlop/s"));
    fmt::print("\n");
  }

  /// Nominal operations over the time at the peak.
  std::optional<double> share(std::string_view scheme, ensemble_noise noise, isa level) const {
    const auto flops = nominal_flops(scheme, noise), peak = over(1.0, cpu(peak_key(level)));
    const auto time = cpu(scheme_key(scheme, noise, "paper", level));
    return flops && peak && time ? std::optional(100 * *flops / (*time * *peak)) : std::nullopt;
  }

  void schemes() const {
    fmt::print(
        "\nns a path and step on {}, scene paper. share: nominal operations of the algorithm over the FMA peak. Times "
        "the\n"
        "rate of: Eigen with std::normal_distribution; omp simd with Boost's ziggurat; Odeint's rk4\n",
        name_of(widest_));
    fmt::print("{:<18}{:<12}{:>8}{:>9}{:>9}{:>9}{:>10}{:>9}\n", "scheme", "noise", "CPU ns", "wall ns", "share",
               "eigen", "omp simd", "odeint");
    for (const auto& scheme : scheme_names(scene_features().front().scene))
      for (const auto noise : all_noises) scheme_row(scheme, noise);
  }

  void scheme_row(const std::string& scheme, ensemble_noise noise) const {
    const auto t = t_.of(scheme_key(scheme, noise, "paper", widest_));
    if (!t) return;
    const auto soa = scheme == "heun" ? cpu(soa_key(noise)) : std::nullopt;
    const auto rk4 = noise == ensemble_noise::none ? cpu(odeint_key) : std::nullopt;
    fmt::print("{:<18}{:<12}{:>8.3f}{:>9.3f}{}{}{}{}\n", scheme, name_of(noise), t->cpu * 1e9, t->wall * 1e9,
               cell(share(scheme, noise, widest_), 8, 1, "%"),
               cell(over(cpu(eigen_key(scheme, noise)), t->cpu), 8, 1, "x"), cell(over(soa, t->cpu), 9, 2, "x"),
               cell(over(rk4, t->cpu), 8, 1, "x"));
  }

  /// The main schemes and every noise, where they were measured on the scene `paper` and the widest instruction set.
  template <class Row>
  void for_main_schemes(Row row) const {
    for (const auto scheme : main_schemes)
      for (const auto noise : all_noises)
        if (t_.of(scheme_key(scheme, noise, "paper", widest_))) {
          fmt::print("{:<18}{:<12}", scheme, name_of(noise));
          row(scheme, noise);
          fmt::print("\n");
        }
  }

  /// Counted operations over the time at the peak.
  void other_systems() const {
    fmt::print(
        "\nOther systems, common noise: ns a path and step (share: counted operations of the step over the FMA peak of "
        "each)\n");
    for (const auto scene : other_scenes)
      for (const auto scheme : main_schemes) {
        if (!t_.of(scheme_key(scheme, ensemble_noise::common, scene, widest_))) continue;
        fmt::print("{:<18}{:<12}", scene, scheme);
        for (const isa level : usable_isas()) {
          const auto time = cpu(scheme_key(scheme, ensemble_noise::common, scene, level));
          const auto peak = over(100.0, over(time, cpu(peak_key(level))));
          const auto share = peak ? std::optional(counted_flops(scheme, scene) * *peak) : std::nullopt;
          fmt::print("  {}{} ({})", name_of(level), cell(over(time, 1e-9), 8, 3), cell(share, 6, 1, "%"));
        }
        fmt::print("\n");
      }
  }

  void features() const {
    fmt::print("\nWhat a scene does not need: ns a path and step on {}\n{:<30}", name_of(widest_), "");
    for (const auto& f : scene_features()) fmt::print("{:>15}", f.name);
    fmt::print("\n");
    for_main_schemes([&](auto scheme, auto noise) {
      for (const auto& f : scene_features())
        fmt::print("{}", cell(ns(scheme_key(scheme, noise, f.name, widest_)), 15, 3));
    });
  }

  void instruction_sets() const {
    fmt::print("\nInstruction sets: ns a path and step (rate beside {}, share of the peak of each)\n",
               name_of(widest_));
    for_main_schemes([&](auto scheme, auto noise) {
      const auto best = ns(scheme_key(scheme, noise, "paper", widest_));
      for (const isa level : usable_isas()) {
        const auto time = ns(scheme_key(scheme, noise, "paper", level));
        fmt::print("  {}{} ({},{})", name_of(level), cell(time, 8, 3), cell(over(best, time), 5, 2, "x"),
                   cell(share(scheme, noise, level), 6, 1, "%"));
      }
    });
    fmt::print("heun without noise, time over that of the kernel written by hand for it:");
    for (const isa level : usable_isas()) {
      const auto general = cpu(scheme_key("heun", ensemble_noise::none, "paper", level));
      fmt::print("  {} {}", name_of(level), cell(over(general, cpu(by_hand_key(level))), 0, 3));
    }
    fmt::print("\n");
  }

  void headers() const {
    fmt::print("\nns a path and step with one double at a time, for any x86-64\n{:<18}{:>18}{:>18}{:>8}\n", "",
               "installed headers", "laboratory's loop", "ratio");
    for (const auto scheme : main_schemes) {
      const auto outside = ns(headers_key(scheme)), inside = ns(scalar_key(scheme));
      if (outside)
        fmt::print("{:<18}{}{}{}\n", scheme, cell(outside, 18, 2), cell(inside, 18, 2),
                   cell(over(outside, inside), 8, 3));
    }
  }

  void normals() const {
    fmt::print("\nns a normal:");
    for (const isa level : usable_isas()) fmt::print("  own {} {}", name_of(level), cell(ns(normals_key(level)), 0, 3));
    for (const auto name : {"std", "boost_ziggurat", "gsl_ziggurat"})
      fmt::print("  {} {}", name, cell(ns(fmt::format("normals/{}", name)), 0, 3));
    fmt::print("\n");
  }

  /// Wall time is what counts. Where others had a part of the cores it says nothing, and CPU time gives a bound only.
  void threads() const {
    fmt::print(
        "\nWhole ensembles on one and two threads, ns a path and step; at most: by CPU time, had both cores been "
        "free\n{:<30}{:>9}{:>9}{:>9}{:>15}{:>15}\n",
        "", "wall 1", "wall 2", "faster", "cores had of 2", "at most");
    for (const auto scheme : main_schemes)
      for (const auto noise : all_noises) {
        const auto one = t_.of(threads_key(scheme, noise, 1)), two = t_.of(threads_key(scheme, noise, 2));
        if (one && two)
          fmt::print("{:<18}{:<12}{:>9.3f}{:>9.3f}{:>8.2f}x{:>15.2f}{:>14.2f}x\n", scheme, name_of(noise),
                     one->wall * 1e9, two->wall * 1e9, one->wall / two->wall, two->cpu / two->wall,
                     2 * one->cpu / two->cpu);
      }
  }

  const timings& t_;
  isa widest_;
};

}  // namespace

void print_summary(const timings& t) { summary(t).print(); }

}  // namespace polhode::bench
