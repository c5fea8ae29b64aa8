#!/bin/bash
# Kills and failing system calls at every step of writing a map's folder and a file: what was there before is there, or the
# new, never a part of it; what a killed process left is gone after the next. Exit code 77 means skipped.
#   faults_test.sh PROGRAM
set -uo pipefail

program=$1
command -v strace >/dev/null || { echo "skipped: strace is not installed"; exit 77; }
strace -o /dev/null true 2>/dev/null || { echo "skipped: strace may not look at processes here"; exit 77; }

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
export XDG_CACHE_HOME=$work/cache XDG_STATE_HOME=$work/state

fail() { echo "FAILED: $*"; ls -la . map; exit 1; }
draw() { "$program" --quiet map hatch --width "$1" --out map >/dev/null 2>&1; }
# The map of a width is the same bytes at every time.
state() { (cd map && sha256sum ./* | sha256sum); }

draw 64 || fail "the first map"
old=$(state)
draw 128 || fail "the second map"
new=$(state)
[ "$old" != "$new" ] || fail "both maps are alike"

runs=0 killed=0 refused=0
try() { # SYSCALL WHAT NUMBER
    draw 64 || fail "back to the old map"
    [ "$(state)" = "$old" ] || fail "the old map is not as before"
    [ -z "$(find . -maxdepth 1 -name '.hatchway-*')" ] || fail "something was left behind after $1 $3"
    strace -f -o log -e "trace=$1" -e "inject=$1:$2:when=$3" \
        "$program" --quiet map hatch --width 128 --out map >/dev/null 2>&1
    local code=$? now
    grep -q 'INJECTED\|killed by SIGKILL' log || return 1 # it makes fewer such calls
    runs=$((runs + 1))
    now=$(state)
    [ "$now" = "$old" ] || [ "$now" = "$new" ] || fail "a mixed map after $1 $2 $3"
    case $code in
        137) killed=$((killed + 1)) ;;
        2 | 1) refused=$((refused + 1)); [ "$now" = "$old" ] || fail "an error, and yet the new map, after $1 $3" ;;
        0) [ "$now" = "$new" ] || fail "no error, and yet the old map, after $1 $2 $3" ;;
        *) fail "exit code $code after $1 $2 $3" ;;
    esac
}

step=${HATCHWAY_FAULT_STEP:-3} # 1: at every call
for call in mkdirat write fsync renameat renameat2 unlinkat; do
    for number in $(seq 1 "$step" 40); do try "$call" signal=SIGKILL "$number" || break; done
done
for call in mkdirat write fsync renameat renameat2; do
    for number in $(seq 1 "$step" 40); do try "$call" error=ENOSPC "$number" || break; done
done
[ "$runs" -gt 0 ] && [ "$killed" -gt 0 ] && [ "$refused" -gt 0 ] || fail "nothing was tried: $runs, $killed, $refused"
echo "$runs faults: $killed kills, $refused refused"
