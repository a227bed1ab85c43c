// Compiled once per instruction set, without contraction of products and sums, so that every one gives the same bits.
#include "ensemble/normal_block.hpp"
#include "ensemble/isa_entry.hpp"
#include "ensemble/kernel.hpp"

extern "C" [[gnu::flatten]] void POLHODE_ENTRY(polhode_fill_normals_)(const polhode::normal_block& request) {
  using namespace polhode;
  using B = bits_of<pack>;
  constexpr int width = static_cast<int>(pack::size());
  for (int step = 0; step < request.steps; ++step) {
    const noise_address address{request.seed, request.kind, 0, request.first_step + static_cast<std::uint64_t>(step)};
    double* row = request.out + step * request.rows * block_lanes;
    for (int k = 0; k < request.wanted; k += 2, row += 2 * block_lanes)
      for (int lane = 0; lane < block_lanes; lane += width) {
        const B path([&](auto i) { return request.first_path + static_cast<std::uint64_t>(lane) + i; });
        const auto pair = normal_pair<pack>(address, path, static_cast<std::uint32_t>(k / 2));
        (pack(request.scale) * pair[0]).copy_to(row + lane, stdx::element_aligned);
        if (k + 1 < request.wanted)
          (pack(request.scale) * pair[1]).copy_to(row + block_lanes + lane, stdx::element_aligned);
      }
  }
}
