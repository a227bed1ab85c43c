// SPDX-License-Identifier: Apache-2.0
#include "reports/writers/packed.hpp"

#include <zlib.h>

#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>
#include <new>

namespace polhode::report {
namespace {

std::string compressed(std::string_view text) {
  auto size = ::compressBound(text.size());
  std::string out(size, '\0');
  const auto* from = reinterpret_cast<const Bytef*>(text.data());
  // The space suffices by compressBound, so that nothing but memory can lack.
  if (::compress(reinterpret_cast<Bytef*>(out.data()), &size, from, text.size()) != Z_OK) throw std::bad_alloc();
  out.resize(size);
  return out;
}

std::string base64(std::string bytes) {
  using namespace boost::archive::iterators;
  using digits = base64_from_binary<transform_width<std::string::const_iterator, 6, 8>>;
  const auto lacking = (3 - bytes.size() % 3) % 3;  // of the last group of three bytes
  bytes.append(lacking, '\0');
  std::string out(digits(bytes.cbegin()), digits(bytes.cend()));
  out.replace(out.size() - lacking, lacking, lacking, '=');
  return out;
}

}  // namespace

std::string packed(std::string_view text) { return text.empty() ? "" : base64(compressed(text)); }

}  // namespace polhode::report
