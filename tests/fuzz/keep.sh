#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Adds inputs to the corpus of a harness, each under its checksum: the same bytes for the same inputs.
set -euo pipefail

(($# > 1)) || { echo 'usage: keep.sh HARNESS FILE…   e.g. keep.sh results build/fuzz/found/results-crash-…' >&2; exit 2; }
name=$1
shift
archive=$(dirname "${BASH_SOURCE[0]}")/corpus/$name.tar.gz
[[ -e $archive ]] || { echo "keep.sh: no corpus $archive" >&2; exit 2; }
work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT
tar -xzf "$archive" -C "$work"
for input in "$@"; do cp -- "$input" "$work/$name/$(sha1sum <"$input" | cut -d' ' -f1)"; done
tar --sort=name --mtime=@0 --owner=0 --group=0 --numeric-owner --mode=u=rwX,go=rX -c -C "$work" "$name" | gzip -9n >"$work/packed"
cp "$work/packed" "$archive"
