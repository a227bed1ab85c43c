#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The installed headers by themselves: each alone, under g++ and clang, without exceptions and RTTI, for the baseline of
# x86-64, every warning an error; and the example programs, compiled for armv8-a and run under qemu-user.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

include=integrators/include
flags=(-std=c++20 -Wall -Wextra -Wconversion -Werror "-I$include" -isystem /usr/include/eigen3)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

for compiler in g++ clang++-19; do
  # shellcheck disable=SC2016
  find "$include" -name '*.hpp' -printf '%P\n' | sort | xargs -P "$(nproc)" -I{} bash -c '
    printf "#include <%s>\n" "$1" | "${@:2}" -x c++ - || { echo "portable: $1 under $2" >&2; exit 255; }' \
    _ {} "$compiler" "${flags[@]}" -march=x86-64 -fno-exceptions -fno-rtti -fsyntax-only
  echo "portable: every header under $compiler"
done

for source in integrators/examples/installed/*.cpp; do
  name=$(basename "$source" .cpp)
  aarch64-linux-gnu-g++ "${flags[@]}" -O2 -march=armv8-a -static "$source" -o "$work/$name"
  printf 'portable: %s on armv8-a: ' "$name"
  qemu-aarch64 "$work/$name"
done
