#!/bin/bash
# System calls that fail while something is written, of each kind of output: an error leaves what was there before, success
# the new, nothing a part of it or a temporary file. Kills are in kills_test.cpp. Exit code 77 means skipped.
#   faults_test.sh PROGRAM CONTENT_FOLDER
set -uo pipefail

program=$1
content=$2
command -v strace >/dev/null || { echo "skipped: strace is not installed"; exit 77; }
strace -o /dev/null true 2>/dev/null || { echo "skipped: strace may not look at processes here"; exit 77; }

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cp "$content/models/prism.glb" "$work"
cd "$work" || exit 1
export XDG_CACHE_HOME=$work/cache XDG_STATE_HOME=$work/state

# OUTPUT: how it is written, the old and the new value of its last option.
outputs=(map a.compiled a.lightmap a.png a.svg a.pdf)
declare -A words=(
    [map]="map hatch --width" [a.compiled]="compile prism.glb --pvs" [a.lightmap]="bake prism.glb --samples 4 --luxels-per-m"
    [a.png]="render prism.glb --size" [a.svg]="lines prism.glb --size" [a.pdf]="lines prism.glb --size"
)
declare -A values=(
    [map]="64 128" [a.compiled]="fast full" [a.lightmap]="1 2" [a.png]="32x32 40x40" [a.svg]="320x240 400x300"
    [a.pdf]="320x240 400x300"
)

fail() { echo "FAILED: $*"; ls -la . map; cat log; exit 1; }
state() { find "$1" -type f -exec sha256sum {} + | sort | sha256sum; }
# command_line OUTPUT VALUE: the words that write it.
command_line() { echo "$program --quiet ${words[$1]} $2 --out $1"; }

runs=0 refused=0
try() { # OUTPUT SYSCALL ERROR NUMBER
    rm -rf "$1" && cp -r "saved/$1" "$1"
    # shellcheck disable=SC2046
    strace -f --seccomp-bpf -o log -e "trace=$2" -e "inject=$2:error=$3:when=$4" $(command_line "$1" "$new_value") >/dev/null 2>&1
    local code=$? now
    grep -q INJECTED log || return 1 # it makes fewer such calls
    runs=$((runs + 1))
    now=$(state "$1")
    [ -z "$(find . -name '.hatchway-*.tmp')" ] || fail "$1: something was left behind after $2 $3 $4"
    case $code in
        1 | 2) refused=$((refused + 1)); [ "$now" = "$old" ] || fail "$1: an error, and not the old one, after $2 $3 $4" ;;
        0) [ "$now" = "$new" ] || fail "$1: no error, and not the new one, after $2 $3 $4" ;;
        *) fail "$1: exit code $code after $2 $3 $4" ;;
    esac
}

mkdir saved
for output in "${outputs[@]}"; do
    read -r old_value new_value <<<"${values[$output]}"
    $(command_line "$output" "$new_value") >/dev/null 2>&1 || fail "the new $output"
    new=$(state "$output")
    $(command_line "$output" "$old_value") >/dev/null 2>&1 || fail "the old $output"
    old=$(state "$output")
    [ "$old" != "$new" ] || fail "both are alike: $output"
    cp -r "$output" "saved/$output"
    step=${HATCHWAY_FAULT_STEP:-3} # 1: at every call
    before=$refused
    for call in mkdirat write fsync renameat renameat2; do
        for number in $(seq 1 "$step" 40); do try "$output" "$call" ENOSPC "$number" || break; done
    done
    try "$output" fsync EIO 1
    [ "$refused" -gt "$before" ] || fail "nothing was tried of $output"
done
echo "$runs faults, $refused refused"
