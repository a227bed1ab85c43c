// SPDX-License-Identifier: Apache-2.0
#include "experiments/common/driven_block.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace polhode {
namespace {

constexpr double more = 0x1p-17;  // relative: its square and rounding over it are both below 1e-10

/// Of so many levels the one of the responses.
std::size_t varied_among(std::size_t levels) { return levels < 3 ? 0 : levels - 3; }

std::vector<direction> directions_of(const subject& s, double dt) {
  std::vector<direction> out;
  const int channels = s.model->layout().active;
  for (int k = 0; k < channels; ++k)
    out.push_back({channels == 1 ? "noise" : fmt::format("noise {}", k + 1), k, s.model->reference(dt)});
  if (const double damping = dissipation_of(s.scene); damping > 0)
    out.push_back({"dissipation", -1, s.with(with_dissipation(s.scene, damping * (1 + more))).model->reference(dt)});
  out.push_back({"time", -1, s.model->reference(dt * (1 + more))});
  return out;
}

}  // namespace

driven_kernels driven_kernels_of(const subject& s, const level_grid& grid, int cells) {
  const auto dt = grid.dt();
  driven_kernels out{s.model->reference(dt.back() / cells), {}, directions_of(s, dt[varied_among(dt.size())])};
  for (const double step : dt) out.twins.push_back(s.model->reference(step));
  return out;
}

driven_block::driven_block(const context& c, const level_grid& grid, int cells, noise_source source,
                           const driven_kernels& kernels, int looks)
    : context_(c),
      coupled_(*c.subject.model, grid, cells, source),
      kernels_(kernels),
      course_(static_cast<std::size_t>(looks)),
      twins_(grid.steps.size()),
      varied_(kernels.directions.size()) {}

void driven_block::start(std::uint64_t first_path) {
  first_path_ = first_path;
  const auto initial = replicated(context_.subject.scene.momentum);
  for (auto* states : {&course_, &twins_, &varied_}) std::ranges::fill(*states, initial);
}

void driven_block::advance(int chunk) {
  fine_ = coupled_.fill(context_.seed, first_path_, chunk);
  const int looks = static_cast<int>(course_.size()), each = fine_.steps / looks;
  for (int i = 0; i < looks; ++i) {
    const auto at = static_cast<std::size_t>(i);
    course_[at] = course_[i > 0 ? at - 1 : course_.size() - 1];
    kernels_.truth->advance(course_[at], fine_.part(i * each, each));
  }
  for (std::size_t l = 0; l < twins_.size(); ++l) kernels_.twins[l]->advance(twins_[l], coupled_.level(l));
  advance_varied(coupled_.level(varied_among(twins_.size())));
}

void driven_block::advance_varied(const increment_view& view) {
  const std::size_t row = block_lanes, step = view.dw.size() / static_cast<std::size_t>(view.steps);
  for (std::size_t k = 0; k < kernels_.directions.size(); ++k) {
    const auto& d = kernels_.directions[k];
    auto varied = view;
    if (d.channel >= 0) {
      scaled_.assign(view.dw.begin(), view.dw.end());
      for (auto at = static_cast<std::size_t>(d.channel) * row; at < scaled_.size(); at += step)
        for (std::size_t lane = 0; lane < row; ++lane) scaled_[at + lane] *= 1 + more;
      varied.dw = scaled_;
    }
    d.reference->advance(varied_[k], varied);
  }
}

std::vector<std::vector<double>> driven_block::responses() const {
  auto out = varied_;
  const auto& twin = twins_[varied_among(twins_.size())];
  for (auto& r : out)
    for (std::size_t i = 0; i < r.size(); ++i) r[i] = (r[i] - twin[i]) / more;
  return out;
}

}  // namespace polhode
