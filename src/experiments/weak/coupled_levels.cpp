// SPDX-License-Identifier: Apache-2.0
#include "experiments/weak/coupled_levels.hpp"

#include <cmath>

#include "ensemble/noise/paths.hpp"
#include "experiments/weak/common_error.hpp"

namespace polhode {
namespace {

constexpr int cells = 8;  // of the truth in the finest step
constexpr double resolution = 64;

}  // namespace

coupled_levels::coupled_levels(const context& c, const std::vector<scheme_entry>& schemes,
                               const std::vector<observable>& f, int paths)
    : context_(c),
      schemes_(schemes),
      grid_(asymptotic_levels(c.subject, resolution)),
      driven_(driven_kernels_of(c.subject, grid_, cells)),
      observables_(f),
      squares_(f.size(), std::vector<double>(static_cast<std::size_t>(paths))),
      truth_(f.size(), {paths, 1, std::vector<double>(static_cast<std::size_t>(paths))}),
      controls_(c.subject.model->layout(), grid_.steps.front(), grid_.horizon, paths),
      noise_{std::vector<double>(static_cast<std::size_t>(paths))},
      log_(*c.subject.model, paths / block_lanes, {{"", 0}, {"finest steps", cells}}) {
  const int levels = static_cast<int>(grid_.steps.size());
  const squared_errors room{paths, levels, std::vector<double>(static_cast<std::size_t>(paths * levels))};
  for (const auto& scheme : schemes) {
    found_.push_back({std::vector<squared_errors>(f.size(), room),
                      path_record(paths, levels, static_cast<int>(driven_.directions.size()))});
    kernels_.emplace_back();
    for (const double dt : grid_.dt()) kernels_.back().push_back(scheme.make(dt));
  }
}

double coupled_levels::steps_of_a_path() const {
  double sum = 0;
  for (const int n : grid_.steps) sum += n;
  return sum;
}

std::vector<squared_errors> coupled_levels::errors(int scheme, int paths, double resolved) const {
  auto out = found_[static_cast<std::size_t>(scheme)].differences;
  std::vector<double> sizes;
  for (auto& d : out) d.paths = paths;
  for (const auto& f : squares_) {
    double sum = 0;
    for (int p = 0; p < paths; ++p) sum += f[static_cast<std::size_t>(p)] / paths;
    sizes.push_back(std::sqrt(sum));
  }
  out = controls_.taken_out_of(out);
  out.push_back(along_their_errors(out, sizes, resolved));
  return out;
}

std::vector<squared_errors> coupled_levels::truth(int paths) const {
  auto out = truth_;
  for (auto& f : out) f.paths = paths;
  return controls_.taken_out_of(out);
}

squared_errors coupled_levels::values(int scheme, std::size_t observable, int paths) const {
  auto out = found_[static_cast<std::size_t>(scheme)].differences[observable];
  out.paths = paths;
  for (int path = 0; path < paths; ++path)
    for (int l = 0; l < out.levels; ++l) out.at(path, l) += truth_[observable].at(path, 0);
  return controls_.taken_out_of({out}).front();
}

path_limit coupled_levels::limit(int scheme, int paths) {
  auto& p = found_[static_cast<std::size_t>(scheme)].paths;
  p.error.paths = p.gap.paths = paths;
  return limit_of(context_, schemes_[static_cast<std::size_t>(scheme)].info, grid_.dt(), p, noise_, cells);
}

void coupled_levels::run_block(int block, std::span<const int> open) {
  const int first = block * block_lanes;
  driven_block truth(context_, grid_, cells, {context_.generator, noise_quality::fast}, driven_);
  const level_states start(grid_.steps.size(), replicated(context_.subject.scene.momentum));
  std::vector<level_states> states(open.size(), start);
  twin_chain chain(context_.subject, grid_, cells, driven_);
  truth.start(static_cast<std::uint64_t>(first));
  for (int chunk = 0; chunk < grid_.steps.front(); ++chunk) {
    truth.advance(chunk);
    chain.advance(truth);
    controls_.keep(first, chunk, truth.increments(0));
    log_.add(block, truth.fine(), driven_.truth->dt());
    log_.add(block, truth.increments(start.size() - 1), driven_.twins.back()->dt(), 1);
    for (std::size_t i = 0; i < open.size(); ++i)
      for (std::size_t l = 0; l < start.size(); ++l)
        kernels_[static_cast<std::size_t>(open[i])][l]->advance(states[i][l], truth.increments(l));
  }
  const auto responses = truth.responses();
  polhode::keep(responses, driven_.directions, first, noise_);
  for (std::size_t i = 0; i < open.size(); ++i) {
    const auto k = static_cast<std::size_t>(open[i]);
    polhode::keep(states[i], truth, responses, schemes_[k].needs_areas, first, found_[k].paths);
  }
  for (std::size_t f = 0; f < observables_.size(); ++f)
    for (int lane = 0; lane < block_lanes; ++lane) {
      const double end = observables_[f].value(lane_of(truth.truth(), lane, context_.subject.model->dimension()));
      squares_[f][static_cast<std::size_t>(first + lane)] = end * end;
      const auto excess = chain.excess(observables_[f].value, truth, lane);
      truth_[f].at(first + lane, 0) = end - excess.back();
      for (std::size_t i = 0; i < open.size(); ++i) keep(states[i], truth, excess, {f, open[i], first, lane});
    }
}

/// Against the driven equation that knows of the path what the scheme is told, and then its mean against the true one.
void coupled_levels::keep(const level_states& states, const driven_block& truth, const std::vector<double>& excess,
                          place at) {
  const auto scheme = static_cast<std::size_t>(at.scheme);
  const bool areas = schemes_[scheme].needs_areas;
  const auto value = [&](const std::vector<double>& all) {
    return observables_[at.observable].value(lane_of(all, at.lane, context_.subject.model->dimension()));
  };
  for (std::size_t l = 0; l < states.size(); ++l)
    found_[scheme].differences[at.observable].at(at.first_path + at.lane, static_cast<int>(l)) =
        value(states[l]) - value(areas ? truth.truth() : truth.twin(l)) + (areas ? excess.back() : excess[l]);
}

}  // namespace polhode
