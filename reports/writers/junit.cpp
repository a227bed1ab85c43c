// SPDX-License-Identifier: Apache-2.0
#include "reports/writers/junit.hpp"

#include <fmt/format.h>

#include <new>
#include <pugixml.hpp>
#include <string>
#include <utility>

#include "reports/writers/board.hpp"
#include "reports/writers/numbers.hpp"
#include "reports/writers/text.hpp"

namespace polhode::report {
namespace {

// Where memory is missing, pugixml leaves things out in silence.
void require(bool done) {
  if (!done) throw std::bad_alloc();
}

void set(pugi::xml_node node, const char* name, const std::string& value) {
  require(node.append_attribute(name).set_value(printable(value).c_str()));
}

pugi::xml_node appended_node(pugi::xml_node node, const char* name) {
  const auto child = node.append_child(name);
  require(child);
  return child;
}

void set_counts(pugi::xml_node node, const tally& t) {
  set(node, "tests", std::to_string(t.total()));
  set(node, "failures", std::to_string(t.of(verdict_kind::refuted) + t.of(verdict_kind::inconclusive)));
  set(node, "errors", "0");
  set(node, "skipped", std::to_string(t.of(verdict_kind::skipped) + t.of(verdict_kind::not_tried)));
}

struct text_writer final : pugi::xml_writer {
  std::string text;
  void write(const void* data, std::size_t size) override { text.append(static_cast<const char*>(data), size); }
};

std::string found(const verdict& v) {
  std::string text = fmt::format("claimed {}, found {}", shown(v.expected), shown(v.estimate));
  if (const auto interval = shown_interval(v.low, v.high); !interval.empty()) text += " in " + interval;
  const auto reason = reason_of(v);
  return reason.empty() ? text : text + ": " + reason;
}

void append_test_case(pugi::xml_node suite, const verdict& v) {
  auto node = appended_node(suite, "testcase");
  set(node, "classname", v.experiment + "." + v.scheme);
  set(node, "name", v.claim);
  if (v.kind == verdict_kind::holds) return;
  if (v.kind == verdict_kind::skipped) return set(appended_node(node, "skipped"), "message", reason_of(v));
  if (v.kind == verdict_kind::not_tried)
    return set(appended_node(node, "skipped"), "message", fmt::format("{}: {}", name_of(v.kind), reason_of(v)));
  auto failure = appended_node(node, "failure");
  set(failure, "type", std::string(name_of(v.kind)));
  set(failure, "message", found(v));
}

void append_suite(pugi::xml_node root, const results& r, const std::string& name) {
  auto suite = appended_node(root, "testsuite");
  set(suite, "name", name);
  const auto rows = verdicts_of(r, name);
  tally counts;
  for (const auto* row : rows) counts.add(row->kind);
  set_counts(suite, counts);
  if (!r.provenance.started.empty()) set(suite, "timestamp", r.provenance.started);
  for (const auto* row : rows) append_test_case(suite, *row);
  std::string skipped;
  for (const auto& one : r.skipped)
    if (one.experiment == name)
      skipped += fmt::format("skipped: {}: {}\n", one.scheme.empty() ? "every scheme" : one.scheme, one.reason);
  if (!skipped.empty()) require(appended_node(suite, "system-out").text().set(printable(skipped).c_str()));
}

}  // namespace

std::string to_junit(const results& r) {
  pugi::xml_document document;
  const auto declaration = document.append_child(pugi::node_declaration);
  set(declaration, "version", "1.0");
  set(declaration, "encoding", "UTF-8");
  const auto root = appended_node(document, "testsuites");
  set(root, "name", "polhode: " + r.scene.name);
  set_counts(root, count(r.verdicts));
  for (const auto& name : experiment_names(r)) append_suite(root, r, name);
  text_writer out;
  document.save(out, "  ", pugi::format_default, pugi::encoding_utf8);
  return std::move(out.text);
}

}  // namespace polhode::report
