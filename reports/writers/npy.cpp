#include "reports/writers/npy.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <string_view>

namespace polhode::report {
namespace {

std::string header(std::string_view type, std::initializer_list<std::size_t> shape) {
  constexpr std::size_t alignment = 64, preamble = 10;
  std::string dimensions;
  for (const auto n : shape) dimensions += fmt::format("{}, ", n);
  std::string text = fmt::format("{{'descr': '{}', 'fortran_order': False, 'shape': ({}), }}", type, dimensions);
  text.append(alignment - 1 - (preamble + text.size()) % alignment, ' ');
  text += '\n';
  const auto length = text.size();
  std::string out("\x93NUMPY\x01\x00", 8);
  out += static_cast<char>(length & 0xFF);
  out += static_cast<char>(length >> 8);
  return out + text;
}

template <class T>
std::string array(std::string_view type, std::span<const T> values, std::initializer_list<std::size_t> shape) {
  std::string out = header(type, shape);
  const auto start = out.size();
  out.resize(start + values.size_bytes());
  if (!values.empty()) std::memcpy(out.data() + start, values.data(), values.size_bytes());
  if constexpr (std::endian::native == std::endian::big)
    for (auto at = out.begin() + static_cast<std::ptrdiff_t>(start); at != out.end(); at += sizeof(T))
      std::reverse(at, at + sizeof(T));
  return out;
}

}  // namespace

std::string to_npy(std::span<const double> values, std::initializer_list<std::size_t> shape) {
  return array("<f8", values, shape);
}

std::string to_npy(std::span<const std::uint32_t> values, std::initializer_list<std::size_t> shape) {
  return array("<u4", values, shape);
}

}  // namespace polhode::report
