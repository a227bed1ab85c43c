// SPDX-License-Identifier: Apache-2.0
// Reading back what json.cpp wrote: every complaint names the place in the document.
#include <fmt/format.h>

#include <string_view>
#include <utility>

#include "reports/model/errors.hpp"
#include "reports/model/text.hpp"
#include "reports/writers/digest.hpp"
#include "reports/writers/json.hpp"
#include "reports/writers/json_node.hpp"
#include "reports/writers/json_rows.hpp"

namespace polhode::report {
namespace {

std::string text_or_none(const node& n, const char* key) {
  const auto known = n.maybe(key);
  return known ? known->text() : "";
}

std::vector<std::pair<std::string, double>> measured_from(const node& n) {
  std::vector<std::pair<std::string, double>> out;
  if (const auto known = n.maybe("measured"))
    for (const auto& [key, _] : known->value.items()) out.emplace_back(key, (*known)[key.c_str()].number());
  return out;
}

scheme scheme_from(const node& n) {
  const node claims = n["claims"];
  return {n["name"].text(),
          n["title"].text(),
          n["source"].text(),
          n["calculus"].text(),
          n["implicit"].flag(),
          n["areas"].flag(),
          claims["strong_commuting"].number(),
          claims["strong_general"].number(),
          claims["deterministic_order"].integer<int>(),
          claims["casimir_exact"].flag(),
          claims["casimir_order"].number(),
          claims["weak_one_vector"].number(),
          claims["weak_isotropic"].number(),
          claims["weak_general"].number(),
          text_or_none(n, "from"),
          text_or_none(n, "takes"),
          measured_from(n)};
}

experiment experiment_from(const node& n) {
  return {n["name"].text(), n["question"].text(), n["notes"].list([](const node& one) { return one.text(); })};
}

counters counters_from(const node& n) {
  return {n["normals_drawn"].integer<std::uint64_t>(), n["path_steps"].integer<std::uint64_t>(),
          n["kernels_run"].integer<std::uint64_t>()};
}

saved saved_from(const node& n) { return {counters_from(n), n["cpu_seconds"].number()}; }

skip skip_from(const node& n) {
  const auto known = n.maybe("saved");
  return {n["experiment"].text(), n["scheme"].text(), n["reason"].text(), known ? saved_from(*known) : saved{}};
}

saving saving_from(const node& n) {
  return {n["experiment"].text(), n["scheme"].text(), n["what"].text(), n["reason"].text(), saved_from(n["saved"])};
}

reuse reuse_from(const node& n) {
  return {n["experiment"].text(), n["scheme"].text(), n["computed"].text(), saved_from(n["saved"])};
}

density density_from(const node& n) {
  density d{n["experiment"].text(),
            n["scheme"].text(),
            n["name"].text(),
            n["time"].maybe_number(),
            n["longitudes"].integer<int>(),
            n["heights"].integer<int>(),
            {}};
  const node values = n["values"];
  d.values = values.list([](const node& one) { return one.number(); });
  if (d.longitudes < 1 || d.heights < 1 || d.values.size() % static_cast<std::size_t>(d.longitudes) != 0 ||
      d.values.size() / static_cast<std::size_t>(d.longitudes) != static_cast<std::size_t>(d.heights))
    refuse(values.where, "as many numbers as longitudes times heights");
  return d;
}

audited_noise::deviation deviation_from(const node& n) { return {n["what"].text(), n["standard_errors"].number()}; }

audited_noise audited_noise_from(const node& n) {
  return {n["experiment"].text(),
          n["part"].text(),
          n["scheme"].text(),
          n["increments"].number(),
          n["areas"].number(),
          n["of_increments"].list(deviation_from),
          n["of_areas"].list(deviation_from)};
}

profile_row profile_row_from(const node& n) {
  return {n["experiment"].text(), n["scheme"].text(), n["cpu_seconds"].number()};
}

work_done work_from(const node& n) {
  return {counters_from(n), n["experiments_run"].integer<std::uint64_t>(),
          n["results_computed"].integer<std::uint64_t>(), n["results_reused"].integer<std::uint64_t>()};
}

json parsed(std::string_view text) {
  try {
    return json::parse(text);
  } catch (const json::parse_error& error) {
    throw input_error(fmt::format("results: not JSON, or cut short, at byte {} of {}", error.byte, text.size()));
  } catch (const json::exception&) {
    throw input_error("results: holds a number that is too large for a double");
  }
}

}  // namespace

results from_json(std::string_view text) {
  const json document = parsed(text);
  const node root{document, ""};
  const node schema = root["schema"];
  const auto name = schema["name"].text();
  if (name == digest_schema_name) return digest_from(root);
  if (name != schema_name)
    refuse("schema.name",
           fmt::format("\"{}\" or \"{}\", found \"{}\"", schema_name, digest_schema_name, one_line(name, 40)));
  const int version = schema["version"].integer<int>();
  if (version != 1 && version != schema_version)
    refuse("schema.version", fmt::format("1 or {}, found {}", schema_version, version));
  results r;
  r.provenance = provenance_from(root["provenance"]);
  r.scene = scene_from(root["scene"]);
  r.schemes = root["schemes"].list(scheme_from);
  r.experiments = root["experiments"].list(experiment_from);
  r.measurements = root["measurements"].list([&](const node& n) { return measurement_from(n, version); });
  r.fits = root["fits"].list([&](const node& n) { return fit_from(n, version, r.measurements); });
  r.verdicts = root["verdicts"].list([&](const node& n) { return verdict_from(n, version); });
  r.skipped = root["skipped"].list(skip_from);
  if (const auto savings = root.maybe("savings")) r.savings = savings->list(saving_from);
  if (const auto reused = root.maybe("reused")) r.reused = reused->list(reuse_from);
  if (const auto densities = root.maybe("densities")) r.densities = densities->list(density_from);
  if (const auto audits = root.maybe("audits")) r.audits = audits->list(audited_noise_from);
  if (const auto counted = root.maybe("counters")) r.done = work_from(*counted);
  if (const auto profile = root.maybe("profile")) r.profile = profile->list(profile_row_from);
  if (const auto rest = root.maybe("to_come")) r.to_come = rest->list([](const node& n) { return n.text(); });
  return r;
}

}  // namespace polhode::report
