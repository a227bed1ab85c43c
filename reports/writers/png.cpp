// SPDX-License-Identifier: Apache-2.0
#include "reports/writers/png.hpp"

#include <png.h>

#include <csetjmp>
#include <new>
#include <vector>

#include "reports/model/errors.hpp"

namespace polhode::report {
namespace {

// Bodies are noise: runs are all that can be found in it, and looking for more takes ten times as long for larger
// files.
constexpr int compression = 1, runs_only = 3;  // zlib's Z_BEST_SPEED, Z_RLE

// libpng reports faults by a long jump: no exception may cross it, and no destructor may be jumped over.
void append_bytes(png_structp png, png_bytep bytes, png_size_t count) {
  bool full = false;
  try {
    static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(bytes), count);
  } catch (const std::bad_alloc&) {
    full = true;
  }
  if (full) png_error(png, "out of memory");
}

void be_silent(png_structp, png_const_charp) {}
[[noreturn]] void jump(png_structp png, png_const_charp) { png_longjmp(png, 1); }

/// Holds nothing that needs destruction.
bool write(png_structp png, png_infop info, const png_color* colours, const raster* picture, std::string* out) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  png_set_write_fn(png, out, append_bytes, nullptr);
  png_set_IHDR(png, info, static_cast<png_uint_32>(picture->width), static_cast<png_uint_32>(picture->height), 8,
               PNG_COLOR_TYPE_PALETTE, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_set_PLTE(png, info, colours, static_cast<int>(picture->palette.size()));
  png_set_compression_level(png, compression);
  png_set_compression_strategy(png, runs_only);
  png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_NONE);
  png_write_info(png, info);
  for (int y = 0; y < picture->height; ++y)
    png_write_row(png, picture->pixels.data() + static_cast<std::ptrdiff_t>(y) * picture->width);
  png_write_end(png, nullptr);
  return true;
}

}  // namespace

std::string to_png(const raster& picture) {
  std::string out;
  std::vector<png_color> colours;
  for (const auto& c : picture.palette) colours.push_back({c[0], c[1], c[2]});
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, jump, be_silent);
  png_infop info = png == nullptr ? nullptr : png_create_info_struct(png);
  const bool good = info != nullptr && write(png, info, colours.data(), &picture, &out);
  png_destroy_write_struct(&png, &info);
  if (!good) throw output_error("a picture could not be made: libpng failed");
  return out;
}

}  // namespace polhode::report
