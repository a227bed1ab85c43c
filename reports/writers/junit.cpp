// SPDX-License-Identifier: Apache-2.0
#include "reports/writers/junit.hpp"

#include <fmt/format.h>

#include <pugixml.hpp>
#include <sstream>

#include "reports/writers/board.hpp"
#include "reports/writers/numbers.hpp"
#include "reports/writers/text.hpp"

namespace polhode::report {
namespace {

void set(pugi::xml_node node, const char* name, const std::string& value) {
  node.append_attribute(name).set_value(printable(value).c_str());
}

void set_counts(pugi::xml_node node, const tally& t) {
  node.append_attribute("tests").set_value(t.total());
  node.append_attribute("failures").set_value(t.of(verdict_kind::refuted) + t.of(verdict_kind::inconclusive));
  node.append_attribute("errors").set_value(0);
  node.append_attribute("skipped").set_value(t.of(verdict_kind::skipped) + t.of(verdict_kind::not_tried));
}

std::string found(const verdict& v) {
  std::string text = fmt::format("claimed {}, found {}", shown(v.expected), shown(v.estimate));
  if (const auto interval = shown_interval(v.low, v.high); !interval.empty()) text += " in " + interval;
  const auto reason = reason_of(v);
  return reason.empty() ? text : text + ": " + reason;
}

void append_case(pugi::xml_node suite, const verdict& v) {
  auto node = suite.append_child("testcase");
  set(node, "classname", v.experiment + "." + v.scheme);
  set(node, "name", v.claim);
  if (v.kind == verdict_kind::holds) return;
  if (v.kind == verdict_kind::skipped) return set(node.append_child("skipped"), "message", reason_of(v));
  if (v.kind == verdict_kind::not_tried)
    return set(node.append_child("skipped"), "message", fmt::format("{}: {}", name_of(v.kind), reason_of(v)));
  auto failure = node.append_child("failure");
  set(failure, "type", std::string(name_of(v.kind)));
  set(failure, "message", found(v));
}

void append_suite(pugi::xml_node root, const results& r, const std::string& name) {
  auto suite = root.append_child("testsuite");
  set(suite, "name", name);
  const auto rows = verdicts_of(r, name);
  tally counts;
  for (const auto* row : rows) counts.add(row->kind);
  set_counts(suite, counts);
  if (!r.provenance.started.empty()) set(suite, "timestamp", r.provenance.started);
  for (const auto* row : rows) append_case(suite, *row);
  std::string skipped;
  for (const auto& one : r.skipped)
    if (one.experiment == name)
      skipped += fmt::format("skipped: {}: {}\n", one.scheme.empty() ? "every scheme" : one.scheme, one.reason);
  if (!skipped.empty()) suite.append_child("system-out").text().set(printable(skipped).c_str());
}

}  // namespace

std::string to_junit(const results& r) {
  pugi::xml_document document;
  auto declaration = document.append_child(pugi::node_declaration);
  declaration.append_attribute("version") = "1.0";
  declaration.append_attribute("encoding") = "UTF-8";
  auto root = document.append_child("testsuites");
  set(root, "name", "polhode: " + r.scene.name);
  set_counts(root, count(r.verdicts));
  for (const auto& name : experiment_names(r)) append_suite(root, r, name);
  std::ostringstream out;
  document.save(out, "  ", pugi::format_default, pugi::encoding_utf8);
  return out.str();
}

}  // namespace polhode::report
