// SPDX-License-Identifier: Apache-2.0
#include "reports/writers/reproduction_folder.hpp"

#include "reports/writers/disk.hpp"
#include "reports/writers/json_values.hpp"
#include "reports/writers/reproduction_html.hpp"
#include "reports/writers/reproduction_json.hpp"
#include "reports/writers/reproduction_markdown.hpp"
#include "reports/writers/whole_folder.hpp"

namespace polhode::report {
namespace {

namespace fs = std::filesystem;

constexpr const char *page = "reproductions.html", *text = "reproductions.md", *document = "reproductions.json";

const folder_contents reproduction_contents{
    "page of reproductions", [](std::string_view name) { return name == page || name == text || name == document; },
    document, [](std::string_view begin) { return begins_with_schema(begin, reproductions_schema_name); }};

}  // namespace

void check_reproduction_folder(const fs::path& out) { check_whole_folder(out, reproduction_contents); }

void write_reproductions(const fs::path& out, std::span<const reproduction> all) {
  write_whole_folder(out, reproduction_contents, [&](const fs::path& folder) {
    disk::write_file(folder / page, to_html(all), out / page);
    disk::write_file(folder / text, to_markdown(all), out / text);
    disk::write_file(folder / document, to_json(all), out / document);
  });
}

}  // namespace polhode::report
