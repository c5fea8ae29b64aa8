# Sourced by ./walk and ./check: what both need before they start.

packages=(
    g++ cmake ninja-build pkg-config
    libglfw3-dev libegl-dev libegl1 libgl1-mesa-dri libgles2 libepoxy-dev
    libglm-dev libfmt-dev libspdlog-dev libcli11-dev
    libtinygltf-dev nlohmann-json3-dev libflatbuffers-dev flatbuffers-compiler
    libpng-dev libjpeg62-turbo-dev zlib1g-dev libcairo2-dev
    libopenmesh-dev libtbb-dev libembree-dev
    libgtest-dev libgmock-dev libgmp-dev
)
check_packages=(xvfb xauth xdotool strace clang-format glslang-tools)
check_all_packages=(clang clang-tidy)

# install_missing_packages PACKAGE...: installs the Debian packages that are missing; says nothing when all are there.
install_missing_packages() {
    if ! command -v dpkg-query >/dev/null; then
        echo "This is no Debian system: please install what $* stand for, then use --no-install." >&2
        exit 2
    fi
    local present missing=() package
    present=$(dpkg-query -W -f '${db:Status-Status} ${Package}\n' "$@" 2>/dev/null || true)
    for package in "$@"; do
        grep -qxF "installed $package" <<<"$present" || missing+=("$package")
    done
    [ ${#missing[@]} -gt 0 ] || return 0
    echo "Installing ${missing[*]}" >&2
    local as_root=()
    [ "$(id -u)" = 0 ] || as_root=(sudo)
    "${as_root[@]}" apt-get update -qq
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
        apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
}

# build PRESET TARGET...: configures and builds into build/PRESET; says nothing when all is up to date.
build() {
    local preset=$1 folder=build/$1
    shift
    if [ ! -f "$folder/build.ninja" ]; then
        echo "Building Hatchway ($preset); the first time takes some minutes" >&2
        mkdir -p "$folder"
        cmake --preset "$preset" >"$folder/configure.log" 2>&1 || { cat "$folder/configure.log" >&2; return 1; }
    fi
    local output
    output=$(ninja -C "$folder" -n "$@" 2>&1 || true)
    [[ $output == *"no work to do"* ]] || cmake --build "$folder" --target "$@" >&2
}
