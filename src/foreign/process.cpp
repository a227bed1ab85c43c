// SPDX-License-Identifier: Apache-2.0
#include "foreign/process.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <mutex>
#include <nlohmann/json.hpp>
#include <vector>

#include "foreign/frames.hpp"
#include "foreign/greeting.hpp"
#include "problem/drives.hpp"
#include "reports/model/errors.hpp"
#include "reports/model/text.hpp"

namespace polhode::foreign {
namespace {

/// The problem without dt, which every frame of steps states; sigma has a row for each channel.
std::string scene_of(problem p) {
  auto vectors = noise_vectors_of(p.scene);
  vectors.resize(static_cast<std::size_t>(p.channels), std::vector<double>(static_cast<std::size_t>(p.components)));
  p.scene = with_noise_vectors(std::move(p.scene), std::move(vectors));
  auto all = nlohmann::ordered_json::parse(json_of(p));
  all.erase("dt");
  return all.dump();
}

struct told_process {
  told_process(const std::vector<std::string>& words, double deadline) : talk(words, deadline) {}

  dialogue talk;
  std::string scene;  ///< that it has been told last
};

/// The processes of one command: those that wait, and where more come from.
class processes {
 public:
  processes(const std::string& command, double deadline) : words_(words_of(command)), deadline_(deadline) {
    auto first = started();
    greeting_ = hear_greeting(first->talk);
    give_back(std::move(first));
  }
  const std::string& greeting() const { return greeting_; }

  /// One that knows the scene. Throws failure.
  std::unique_ptr<told_process> take(const std::string& scene) {
    auto one = waiting(scene);
    if (!one) {
      one = started();
      if (hear_greeting(one->talk) != greeting_) throw failure("greets with another line when it is started again");
    }
    if (one->scene != scene) {
      tell_scene(one->talk, scene);
      one->scene = scene;
    }
    return one;
  }
  void give_back(std::unique_ptr<told_process> one) {
    const std::lock_guard lock(guard_);
    waiting_.push_back(std::move(one));
  }

 private:
  std::unique_ptr<told_process> started() const { return std::make_unique<told_process>(words_, deadline_); }
  /// If there is, one that knows the scene; null: all are busy.
  std::unique_ptr<told_process> waiting(const std::string& scene) {
    const std::lock_guard lock(guard_);
    if (waiting_.empty()) return nullptr;
    auto found = std::ranges::find_if(waiting_, [&](const auto& one) { return one->scene == scene; });
    if (found == waiting_.end()) --found;
    auto one = std::move(*found);
    waiting_.erase(found);
    return one;
  }

  std::vector<std::string> words_;
  double deadline_;
  std::string greeting_;
  std::mutex guard_;
  std::vector<std::unique_ptr<told_process>> waiting_;
};

class process_stepper final : public stepper {
 public:
  process_stepper(processes& all, const problem& p) : all_(all), problem_(p), scene_(scene_of(p)) {}

  void advance(const batch& b) override {
    auto one = all_.take(scene_);
    ask_for_steps(one->talk, problem_, b);
    all_.give_back(std::move(one));
  }

 private:
  processes& all_;
  problem problem_;
  std::string scene_;
};

class process_integrator final : public integrator {
 public:
  process_integrator(const std::string& command, double deadline, const std::string& where)
      : all_(command, deadline), about_(read_greeting(all_.greeting(), where, "command " + one_line(command, 200))) {}
  const description& about() const override { return about_; }
  std::unique_ptr<stepper> open(const problem& p) override { return std::make_unique<process_stepper>(all_, p); }

 private:
  processes all_;
  description about_;
};

}  // namespace

std::unique_ptr<integrator> open_process(const std::string& command, double deadline) {
  const auto where = fmt::format("--with '{}'", one_line(command, 200));
  try {
    return std::make_unique<process_integrator>(command, deadline, where);
  } catch (const failure& f) {
    throw input_error(fmt::format("{}: {}", where, f.what()));
  }
}

}  // namespace polhode::foreign
