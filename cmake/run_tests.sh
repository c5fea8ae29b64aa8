# Sourced by ./check: what it runs beside builds. The sums over all runs are in passed, failed and skipped.
passed=0 failed=0 skipped=0

# run_tests PRESET [CTEST ARGUMENT...]: runs tests and counts their cases. A test without a list of cases, be it a script
# or a suite that crashed, counts as one; one that failed after all its cases passed, such as for a leak, counts, too.
run_tests() {
    local preset=$1 results=build/$1/tests/results
    shift
    mkdir -p "$results"
    ctest --preset "$preset" -j "$(nproc)" --output-junit "$PWD/$results/ctest.xml" "$@"
    local name status sums
    while read -r name status; do
        sums=$(cases_of "$results/${name//\//_}.xml" "$status")
        read -r p f s <<<"$sums"
        passed=$((passed + p)) failed=$((failed + f)) skipped=$((skipped + s))
    done < <(sed -nE 's/.*<testcase name="([^"]+)".* status="([a-z]+)".*/\1 \2/p' "$results/ctest.xml")
}

# cases_of FILE STATUS: "passed failed skipped" of a suite's cases in FILE, if it is there, or of the test itself.
cases_of() {
    local counts
    counts=$(grep -m1 '<testsuite ' "$1" 2>/dev/null |
             sed -E 's/.* tests="([0-9]+)" failures="([0-9]+)".* skipped="([0-9]+)".*/\1 \2 \3/')
    case "$counts:$2" in
        :run) echo 1 0 0 ;;
        :notrun) echo 0 0 1 ;;
        :*) echo 0 1 0 ;;
        *)
            local all failures skips
            read -r all failures skips <<<"$counts"
            [ "$2" != fail ] || [ "$failures" != 0 ] || failures=1
            echo $((all - failures - skips)) "$failures" "$skips" ;;
    esac
}

own_sources() {
    find scenegraph npr_plugins editor_tools tests -name '*.[ch]pp' -print0 | sort -z
}

is_formatted() {
    own_sources | xargs -0 -P "$(nproc)" -n 40 clang-format --dry-run -Werror
}

# Names as .clang-tidy says; the compiler's own flags come from a build folder without precompiled headers.
names_are_right() {
    build tidy scenegraph/io/generated/compiled_level_generated.h hatchway_commit || return 1
    own_sources | grep -z '\.cpp$' |
        xargs -0 -P "$(nproc)" -n 4 clang-tidy --quiet -p build/tidy --checks='-*,readability-identifier-naming'
}
