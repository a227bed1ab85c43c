// SPDX-License-Identifier: Apache-2.0
// Runs a harness on every file of its corpus, without a fuzzer.
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <set>
#include <vector>

#include "fuzz.hpp"

int main(int argc, char** argv) {
  const std::filesystem::directory_iterator folder(argc == 2 ? argv[1] : ".");
  std::set<std::filesystem::path> files;
  for (const auto& entry : folder) files.insert(entry.path());
  for (const auto& file : files) {
    std::cout << file.filename().string() << '\n' << std::flush;  // the last one that is named is at fault
    std::ifstream in(file, std::ios::binary);
    const std::vector<char> bytes{std::istreambuf_iterator<char>(in), {}};
    LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
  }
  return files.empty() ? 1 : 0;
}
