#!/usr/bin/env bash
# Compiles levels with each program, by one thread and by two, and once more with the C library told that the processor has
# neither AVX2 nor FMA: all files must be the same, byte for byte. A program that is not there ends the test as skipped.
#   tests/world/visibility/same_bytes.sh PROGRAM[,PROGRAM...] LEVEL|GLB...
set -euo pipefail
[ $# -ge 2 ] || { echo "Use: same_bytes.sh PROGRAM[,PROGRAM...] LEVEL|GLB..." >&2; exit 2; }
IFS=, read -ra programs <<<"$1"
shift
for program in "${programs[@]}"; do
    [ -x "$program" ] || { echo "There is no $program" >&2; exit 77; }
done
without_avx2=glibc.cpu.hwcaps=-AVX2,-FMA,-FMA4,-AVX512F
linker=/lib64/ld-linux-x86-64.so.2
features() { "$linker" --list-diagnostics | grep '\.active'; }
if [ -x "$linker" ] && cmp -s <(features) <(export GLIBC_TUNABLES=$without_avx2 && features); then
    echo "GLIBC_TUNABLES hides nothing here" >&2
    exit 1
fi
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT
for level in "$@"; do
    count=0
    for program in "${programs[@]}"; do
        for run in "1:" "2:" "2:$without_avx2"; do
            GLIBC_TUNABLES=${run#*:} "$program" --quiet compile "$level" -j "${run%%:*}" --out "$folder/$count" >/dev/null
            cmp "$folder/0" "$folder/$count" || { echo "$level: $program differs with -j $run" >&2; exit 1; }
            count=$((count + 1))
        done
    done
    echo "$level: $(stat -c %s "$folder/0") bytes, the same $count times"
done
