#!/usr/bin/env bash
# Compiles levels with two programs, by one thread and by two each: all four files must be the same, byte for byte.
#   tests/world/same_bytes.sh build/release/bin/hatchway build/debug/bin/hatchway LEVEL|GLB...
set -euo pipefail
[ $# -ge 3 ] || { echo "Use: same_bytes.sh PROGRAM PROGRAM LEVEL|GLB..." >&2; exit 2; }
programs=("$1" "$2")
shift 2
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT
for level in "$@"; do
    for program in 0 1; do
        for threads in 1 2; do
            "${programs[$program]}" --quiet compile "$level" -j "$threads" --out "$folder/$program-$threads" >/dev/null
            cmp "$folder/0-1" "$folder/$program-$threads" || { echo "$level: differs" >&2; exit 1; }
        done
    done
    echo "$level: $(stat -c %s "$folder/0-1") bytes, the same four times"
done
