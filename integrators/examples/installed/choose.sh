#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# In CI: fails when another integrator than the one on record is the cheapest for the scene.
#
#   choose.sh SCENE GOAL TOLERANCE FILE    FILE holds the scheme's name; without it the name is written, to be committed
set -euo pipefail

(($# == 4)) || { echo 'usage: choose.sh SCENE GOAL TOLERANCE FILE' >&2; exit 2; }
scene=$1 goal=$2 tolerance=$3 file=$4

answer=$(polhode select "$scene" --goal "$goal" --tolerance "$tolerance" --format json)
winner=$(python3 -c 'import json, sys; print(json.load(sys.stdin)["scheme"])' <<<"$answer")
if [[ ! -e $file ]]; then
  echo "$winner" >"$file"
  echo "choose: $file now names $winner"
elif [[ $(<"$file") != "$winner" ]]; then
  tied=$(python3 -c 'import json, sys; print(json.load(sys.stdin)["tied"])' <<<"$answer")
  [[ $tied != True ]] || { echo "choose: $winner and its runner-up cost the same; $file is left as it is"; exit 0; }
  echo "choose: $winner is the cheapest now, $file names $(<"$file")" >&2
  exit 1
else
  echo "choose: still $winner"
fi
