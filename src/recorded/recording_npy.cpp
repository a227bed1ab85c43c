// SPDX-License-Identifier: Apache-2.0
// Source of the format: numpy.lib.format, "Format Version 1.0" to 3.0.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstring>
#include <optional>
#include <string_view>

#include "recorded/recording_kinds.hpp"
#include "reports/model/errors.hpp"
#include "reports/model/text.hpp"

namespace polhode {
namespace {

static_assert(std::endian::native == std::endian::little, "arrays are read as they are stored");

constexpr std::uint32_t longest_header = 1 << 16;

struct npy_array {
  bool single = false;  ///< floats
  std::vector<std::uint64_t> shape;
};

[[noreturn]] void fail(const recording& r, const std::string& fault) {
  throw input_error(fmt::format("{}: {}", one_line(r.file.string()), fault));
}

std::string header_text(const recording& r, std::istream& in) {
  std::array<unsigned char, 8> mark{};
  in.read(reinterpret_cast<char*>(mark.data()), mark.size());
  const int version = mark[6], width = version == 1 ? 2 : 4;
  std::array<unsigned char, 4> length{};
  in.read(reinterpret_cast<char*>(length.data()), width);
  if (!in || std::memcmp(mark.data(), "\x93NUMPY", 6) != 0 || version < 1 || version > 3)
    fail(r, "no NPY header; accepted: what numpy.save writes");
  const std::uint32_t count = length[0] | static_cast<std::uint32_t>(length[1]) << 8 |
                              static_cast<std::uint32_t>(length[2]) << 16 | static_cast<std::uint32_t>(length[3]) << 24;
  if (count > longest_header)
    fail(r, fmt::format("an NPY header of {} bytes; accepted: at most {}", count, longest_header));
  std::string text(count, '\0');
  in.read(text.data(), static_cast<std::streamsize>(count));
  if (!in) fail(r, "ends inside its NPY header");
  return text;
}

/// What stands behind a key of the header, without blanks before it; empty where there is no such key.
std::string_view behind(std::string_view key, std::string_view header) {
  const auto at = header.find(key);
  if (at == header.npos) return {};
  header.remove_prefix(at + key.size());
  header.remove_prefix(std::min(header.find_first_not_of(' '), header.size()));
  return header;
}

/// Of a text that begins with `open`: what is between that and the next `close`.
std::optional<std::string_view> inside(std::string_view text, char open, char close) {
  if (!text.starts_with(open)) return {};
  const auto end = text.find(close, 1);
  return end == text.npos ? std::nullopt : std::optional(text.substr(1, end - 1));
}

npy_array parsed(const recording& r, const std::string& header) {
  npy_array out;
  const auto kind = inside(behind("'descr':", header), '\'', '\'');
  if (!kind) fail(r, "an NPY header without 'descr'");
  if (kind != "<f8" && kind != "<f4")
    fail(r, fmt::format("an array of '{}'; accepted: doubles or floats, '<f8' or '<f4'", one_line(*kind, 60)));
  out.single = kind == "<f4";
  if (!behind("'fortran_order':", header).starts_with("False"))
    fail(r, "an array in Fortran order; accepted: numpy.ascontiguousarray of it");
  const auto sizes = inside(behind("'shape':", header), '(', ')');
  if (!sizes || sizes->find_first_not_of("0123456789, ") != sizes->npos) fail(r, "an NPY header without 'shape'");
  for (const char *at = sizes->data(), *end = at + sizes->size(); at != end;) {
    std::uint64_t n = 0;
    const auto [stop, fault] = std::from_chars(at, end, n);
    if (fault == std::errc{}) out.shape.push_back(n);
    at = fault == std::errc{} ? stop : at + 1;
  }
  return out;
}

/// As [path][time][component].
std::array<std::uint64_t, 3> checked_shape(const recording& r, std::vector<std::uint64_t> shape) {
  const auto components = r.components.size();
  if (shape.size() < 2 || shape.size() > 3 || shape.back() != components)
    fail(r, fmt::format("an array of shape ({}); accepted: (paths, times, {})",
                        one_line(fmt::format("{}", fmt::join(shape, ", ")), 60), components));
  if (shape.size() == 2) shape.insert(shape.begin(), 1);
  if (shape[1] == 0) shape[0] = 0;  // no states, however many paths
  return {shape[0], shape[1], shape[2]};
}

template <class Real>
void read_states(const recording& r, std::istream& in, const std::array<std::uint64_t, 3>& shape,
                 const state_sink& take) {
  std::vector<Real> raw(shape[2]);
  std::vector<double> mu(shape[2]);
  std::uint64_t place = 0;
  for (std::uint64_t path = 0; path < shape[0]; ++path)
    for (std::uint64_t time = 0; time < shape[1]; ++time) {
      in.read(reinterpret_cast<char*>(raw.data()), static_cast<std::streamsize>(raw.size() * sizeof(Real)));
      ++place;
      if (!in)
        fail(r, fmt::format("ends before state {}; its shape says {} paths of {} states", place, shape[0], shape[1]));
      for (std::size_t k = 0; k < mu.size(); ++k) {
        mu[k] = static_cast<double>(raw[k]);
        if (!std::isfinite(mu[k]))
          fail(r, fmt::format("state {} (path {}, time {}): {} = {}; accepted: a finite number", place, path, time,
                              r.components[k], mu[k]));
      }
      take({static_cast<std::int64_t>(path), static_cast<double>(time) * *r.dt, mu, place});
    }
}

}  // namespace

recording_size read_recorded_npy(const recording& r, std::istream& in, const state_sink& take) {
  const auto array = parsed(r, header_text(r, in));
  const auto shape = checked_shape(r, array.shape);
  array.single ? read_states<float>(r, in, shape, take) : read_states<double>(r, in, shape, take);
  if (in.peek() != std::istream::traits_type::eof()) fail(r, "holds more than its shape says");
  in.clear();
  return {shape[0] * shape[1], array.single ? 0x1p-24 : 0x1p-53};
}

}  // namespace polhode
