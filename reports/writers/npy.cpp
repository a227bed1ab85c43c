// SPDX-License-Identifier: Apache-2.0
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

/// A header, and room for the values.
template <class T>
std::string room_for(std::string_view type, std::size_t count, std::initializer_list<std::size_t> shape) {
  std::string out = header(type, shape);
  out.resize(out.size() + count * sizeof(T));
  return out;
}

template <class T>
void put(T value, char* at) {
  std::memcpy(at, &value, sizeof value);
  if constexpr (std::endian::native == std::endian::big) std::reverse(at, at + sizeof value);
}

template <class T>
std::string array(std::string_view type, std::span<const T> values, std::initializer_list<std::size_t> shape) {
  std::string out = room_for<T>(type, values.size(), shape);
  char* at = out.data() + out.size() - values.size_bytes();
  for (const T value : values) {
    put(value, at);
    at += sizeof value;
  }
  return out;
}

}  // namespace

std::string to_npy_rows(std::span<const double> columns, std::size_t count) {
  const std::size_t rows = columns.size() / count;
  std::string out = room_for<double>("<f8", columns.size(), {rows, count});
  char* at = out.data() + out.size() - columns.size_bytes();
  for (std::size_t i = 0; i < rows; ++i)
    for (std::size_t k = 0; k < count; ++k, at += sizeof(double)) put(columns[k * rows + i], at);
  return out;
}

std::string npy_header_of_doubles(std::initializer_list<std::size_t> shape) { return header("<f8", shape); }

std::string to_npy(std::span<const std::uint32_t> values, std::initializer_list<std::size_t> shape) {
  return array("<u4", values, shape);
}

}  // namespace polhode::report
