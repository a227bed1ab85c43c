#include "experiments/common/driven_block.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace polhode {
namespace {

constexpr double more = 0x1p-17;  // relative: its square and rounding over it are both below 1e-10

}  // namespace

std::vector<direction> directions_of(const subject& s) {
  std::vector<direction> out;
  const int channels = s.model->active_channels();
  for (int k = 0; k < channels; ++k)
    out.push_back({channels == 1 ? "noise" : fmt::format("noise {}", k + 1), k, false, s.model->reference()});
  if (const double theta = dissipation_of(s.scene); theta > 0)
    out.push_back({"dissipation", -1, false, s.with(with_dissipation(s.scene, theta * (1 + more))).model->reference()});
  out.push_back({"time", -1, true, s.model->reference()});
  return out;
}

driven_block::driven_block(const context& c, const level_grid& grid, int cells, noise_source source,
                           const kernel& reference, const std::vector<direction>& directions, int looks)
    : context_(c),
      ladder_(*c.subject.model, grid, cells, source),
      reference_(reference),
      directions_(directions),
      course_(static_cast<std::size_t>(looks)),
      twins_(grid.steps.size()),
      varied_(directions.size()) {}

void driven_block::start(std::uint64_t first_path) {
  first_path_ = first_path;
  const auto initial = replicated(context_.subject.scene.momentum);
  for (auto* states : {&course_, &twins_, &varied_}) std::ranges::fill(*states, initial);
}

void driven_block::advance(int chunk) {
  fine_ = ladder_.fill(context_.seed, first_path_, chunk);
  const int looks = static_cast<int>(course_.size());
  for (int i = 0; i < looks; ++i) {
    const auto at = static_cast<std::size_t>(i);
    course_[at] = course_[i > 0 ? at - 1 : course_.size() - 1];
    reference_.advance(course_[at], part_of(fine_, i, looks));
  }
  for (std::size_t l = 0; l < twins_.size(); ++l) reference_.advance(twins_[l], ladder_.level(l));
  advance_varied(ladder_.level(varied_level()));
}

void driven_block::advance_varied(const increment_view& view) {
  const std::size_t row = block_lanes, step = view.dw.size() / static_cast<std::size_t>(view.steps);
  for (std::size_t k = 0; k < directions_.size(); ++k) {
    const auto& d = directions_[k];
    auto varied = view;
    if (d.time) varied.dt *= 1 + more;
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
  const auto& twin = twins_[varied_level()];
  for (auto& r : out)
    for (std::size_t i = 0; i < r.size(); ++i) r[i] = (r[i] - twin[i]) / more;
  return out;
}

increment_view part_of(const increment_view& v, int part, int parts) {
  const auto within = [&]<class Real>(std::span<const Real> all) {
    const auto size = all.size() / static_cast<std::size_t>(parts);
    return all.subspan(static_cast<std::size_t>(part) * size, size);
  };
  return {v.dt, v.steps / parts, within(v.dw), within(v.area), within(v.singles), v.scale};
}

}  // namespace polhode
