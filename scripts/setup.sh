#!/usr/bin/env bash
# Sees to it that Fumetto can be built and run here, and installs what is missing.
#
#   scripts/setup.sh            to build and to draw: Rust, a linker, a Vulkan driver
#   scripts/setup.sh --window   also what the editor's window needs
#   scripts/setup.sh --lint     also what `make lint` needs
#   scripts/setup.sh --tests    also what `make test` needs
#
# It says what it installs, and why, before it does. Where everything is there it does nothing.
cd "$(dirname "$0")/.." && . scripts/common.sh

need_rust() {
    local wanted found
    wanted=$(sed -n 's/^rust-version = "\(.*\)"/\1/p' Cargo.toml)
    command -v cargo >/dev/null ||
        stop "Fumetto is written in Rust, and cargo is not installed. https://rustup.rs has a one-line
installer for Rust $wanted or newer; run this again afterwards."
    found=$(rustc --version | cut -d' ' -f2)
    [ "$(printf '%s\n%s\n' "$wanted" "$found" | sort -V | head -n 1)" = "$wanted" ] ||
        stop "Fumetto needs Rust $wanted or newer, and this is $found. 'rustup update stable' brings a newer one."
}

need_rust_tools() {
    if cargo fmt --version >/dev/null 2>&1 && cargo clippy --version >/dev/null 2>&1; then
        return
    fi
    command -v rustup >/dev/null ||
        stop "cargo fmt and cargo clippy are not installed; they come with the packages that brought Rust."
    say "Installing rustfmt and clippy with rustup: they check how the code is written."
    rustup component add rustfmt clippy
}

# install_packages REASON PACKAGE...: from Debian's or Ubuntu's archive.
install_packages() {
    local reason="$1" as_root=""
    shift
    if [ "$(id -u)" -ne 0 ]; then
        command -v sudo >/dev/null || stop "$reason. As root, run: apt-get install $*"
        as_root="sudo"
    fi
    say "Installing $* with ${as_root:+$as_root }apt-get: $reason."
    # The lists of packages may be missing or old; only then are they fetched, for that takes a while.
    $as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -q "$@" >/dev/null 2>&1 || {
        $as_root apt-get update -q
        $as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -q "$@"
    } || stop "apt-get could not install $*"
}

# need REASON DEBIAN-PACKAGES OTHERWISE: installs the packages where that can be done.
need() {
    command -v apt-get >/dev/null || stop "$1. $3"
    # shellcheck disable=SC2086 # several packages are several words
    install_packages "$1" $2
}

need_linker() {
    command -v cc >/dev/null ||
        need "Rust links programs with a C compiler, and there is none" "gcc libc6-dev" \
            "Install gcc or clang with this system's package manager."
}

has_library() {
    existing "/usr/lib/$1" "/usr/lib64/$1" /usr/lib/*/"$1" /lib/*/"$1" "/usr/local/lib/$1" >/dev/null
}

has_vulkan() {
    has_library libvulkan.so.1 || return 1
    [ -n "${VK_DRIVER_FILES:-}${VK_ICD_FILENAMES:-}" ] ||
        existing /usr/share/vulkan/icd.d/*.json /etc/vulkan/icd.d/*.json >/dev/null
}

need_vulkan() {
    has_vulkan ||
        need "Fumetto draws with Vulkan, and there is no driver" "libvulkan1 mesa-vulkan-drivers" \
            "Install the Vulkan loader and Mesa's drivers (Fedora: vulkan-loader mesa-vulkan-drivers;
Arch: vulkan-icd-loader vulkan-swrast), or your graphics card's own."
}

need_lavapipe() {
    lavapipe >/dev/null ||
        need "the tests draw with lavapipe, so that their pictures do not depend on the graphics card" \
            "mesa-vulkan-drivers" "Install lavapipe (Fedora: mesa-vulkan-drivers; Arch: vulkan-swrast)."
}

need_python() {
    python3 -c 'import ensurepip, venv' 2>/dev/null ||
        need "the spelling and licence checkers come as Python packages" "python3 python3-venv" \
            "Install Python 3 with its venv module."
}

# Where crates/fumetto-browser looks for it.
has_chromium() {
    local name program
    for name in chromium google-chrome google-chrome-stable chromium-browser; do
        program=$(command -v "$name") || continue
        # Ubuntu's package of that name is a script that asks for the snap.
        if [ -x /snap/bin/chromium ] || ! grep -qs 'requires the chromium snap' "$program"; then
            return 0
        fi
    done
    return 1
}

need_chromium() {
    if [ -n "${FUMETTO_CHROMIUM:-}" ]; then
        [ -x "$FUMETTO_CHROMIUM" ] || stop "FUMETTO_CHROMIUM is '$FUMETTO_CHROMIUM', which is no program."
        return
    fi
    has_chromium && return
    local reason="the tests ask a browser's own compiler about shaders"
    if grep -qsx 'ID=ubuntu' /etc/os-release; then
        stop "$reason, and Ubuntu has Chromium as a snap only: 'sudo snap install chromium', or install the
package of Chrome from https://www.google.com/chrome, or name another Chromium in FUMETTO_CHROMIUM."
    fi
    need "$reason" "chromium" "Install Chromium or Chrome, or name its program in FUMETTO_CHROMIUM."
}

# What the editor's window asks an X server with at run time, which a machine without a desktop does not have.
need_window() {
    local library
    for library in libX11-xcb.so.1 libXcursor.so.1 libXi.so.6 libxkbcommon-x11.so.0; do
        if ! has_library "$library"; then
            need "the editor's window needs $library" "libx11-xcb1 libxcursor1 libxi6 libxkbcommon-x11-0" \
                "Install it (Fedora: libX11-xcb libXcursor libXi libxkbcommon-x11; Arch: libxcursor libxi
libxkbcommon-x11)."
            return
        fi
    done
}

need_display() {
    command -v Xvfb >/dev/null ||
        need "the tests open the editor's window on a display that nobody sees" "xvfb" \
            "Install Xvfb (Fedora: xorg-x11-server-Xvfb; Arch: xorg-server-xvfb)."
}

window="" lint="" tests=""
for argument in "$@"; do
    case "$argument" in
        --window) window=yes ;;
        --lint) lint=yes ;;
        --tests) tests=yes ;;
        *) stop "setup.sh knows --window, --lint and --tests, but not '$argument'" ;;
    esac
done

need_rust
# macOS brings Metal and Windows Direct3D 12; Rust's own installer asks there for a linker.
if [ "$(uname -s)" = Linux ]; then
    need_linker
    need_vulkan
    # A Wayland desktop has what it needs; the tests use an X server everywhere.
    [ -z "$window" ] || [ -n "${WAYLAND_DISPLAY:-}" ] || need_window
    [ -z "$tests" ] || { need_lavapipe && need_window && need_display && need_chromium; }
fi
[ -z "$lint" ] || { need_rust_tools && need_python; }
