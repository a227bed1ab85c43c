// SPDX-License-Identifier: Apache-2.0
// An integrator from elsewhere as a scheme of the laboratory: its kernels, its claims, and what became of it.
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "foreign/integrator.hpp"
#include "problem/subject.hpp"

namespace polhode::foreign {

/// Shared by the kernels of one integrator. Once it has failed it is not called again: its states are NaN from there
/// on, and whoever runs an experiment asks for the reason.
class foreign_scheme {
 public:
  explicit foreign_scheme(std::unique_ptr<integrator>);

  const description& about() const { return about_; }
  integrator& source() { return *integrator_; }

  /// As our own schemes state them; an order that is not claimed is NaN, and a deterministic one 0.
  scheme_info info() const;

  /// Tries it on the scene of the subject, whatever happened on others: a fault is its failure, and what must not be
  /// called by two threads at a time no longer is.
  void try_on(const subject&);
  /// Why it does not run on the scene on which it was tried; empty: it does.
  const std::string& refusal() const { return refusal_; }
  void refuse(const std::string& why) { refusal_ = why; }

  /// Nanoseconds of a step of one path, as it was tried.
  double cost() const { return cost_; }

  /// Orders that were measured take the place of those that are not claimed (run/measured_claims.hpp).
  void take_as_claimed(const foreign::claims& measured) { about_.claims = measured; }
  const foreign::claims& given() const { return given_; }
  /// What was measured beside what it claims: name and order.
  std::vector<std::pair<std::string, double>> measured() const;

  /// Why it can no longer be called; nothing while it can.
  std::optional<std::string> failure() const;
  void fail(const std::string& why);

  /// Held around each call where it must not be called by two threads at a time.
  std::unique_lock<std::mutex> turn();

 private:
  std::unique_ptr<integrator> integrator_;
  description about_;
  foreign::claims given_;
  mutable std::mutex guard_, turn_;
  std::optional<std::string> failure_;
  std::string refusal_;
  double cost_ = 0;
};

using foreign_schemes = std::vector<std::shared_ptr<foreign_scheme>>;

/// Entries beside those of the subject, on this scene and on every one that it is changed to. Throws input_error where
/// a name is taken.
subject with_foreign(subject, const foreign_schemes&);

/// Of the schemes with that name; null: it is one of ours.
foreign_scheme* find_foreign(const foreign_schemes&, std::string_view name);

}  // namespace polhode::foreign
